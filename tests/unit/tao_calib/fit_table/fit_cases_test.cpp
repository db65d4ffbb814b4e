// Fits whose numbers are not all defined, and factors that are no numbers.
#include "demens/base/error.hpp"
#include "tao_calib/fit_table/fit_document.hpp"
#include "tao_calib/fit_table/fit_report.hpp"
#include "tao_calib/fit_table/fit_text.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tests/unit/tao_calib/solver/petsc_environment.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace demens;
using namespace demens::tao_calib;

namespace {

TableFit fit_of(std::string const& toml, std::string const& table)
{
    return TableFit(FitInput::from_text("[fit]\ntable = \"t.csv\"\n" + toml, "fit.toml"),
                    text::CsvTable::from_text(table, "t.csv"));
}

std::string columns(std::vector<std::string> const& factors, std::string const& responses)
{
    std::string toml;
    for (auto const& factor : factors)
        toml += "[[factor]]\ncolumn = \"" + factor + "\"\n";
    return toml + responses;
}

std::string response(std::string const& column, std::string const& more = "")
{
    return "[[response]]\ncolumn = \"" + column + "\"\n" + more;
}

std::vector<FitOptimum> optima_of(TableFit const& fit)
{
    return fit_optima(fit, Pounders(*PetscEnvironment::session()));
}

std::string text_of(TableFit const& fit)
{
    return fit_text(fit, optima_of(fit), admissible_region(fit));
}

std::string message(std::string const& toml, std::string const& table)
{
    try {
        fit_of(toml, table);
    } catch (InputError const& error) {
        return error.what();
    }
    return "no error";
}

double value_of(std::vector<FitTerm> const& terms, std::string const& name)
{
    for (auto const& term : terms)
        if (term.name == name)
            return term.value;
    throw std::runtime_error("no term " + name);
}

std::string const line = "x,y\n0,1\n1,3\n2,5\n3,7\n4,9\n"; // y = 1 + 2 x

//! Two mills, y = 10 + 3 mill + 2 x + 4 x^2 with a little scatter.
std::string mills(std::string const& first, std::string const& second)
{
    double const y[2][6] = {{10.02, 16.1, 29.9, 9.95, 15.9, 30.1}, {13.1, 18.9, 33.05, 12.9, 19.1, 32.9}};
    std::string table = "mill,x,y\n";
    for (int mill = 0; mill < 2; ++mill)
        for (int i = 0; i < 6; ++i)
            table += (mill == 0 ? first : second) + "," + std::to_string(i % 3) + "," +
                     std::to_string(y[mill][i]) + "\n";
    return table;
}

} // namespace

// Where the model meets every run nothing scatters, and the scatter weighs nothing.
TEST(FitExactData, HasOneOptimum)
{
    for (std::string const weight : {"", "scale = 8e-12\n", "tolerance = 8e-12\n", "scale = 1e6\n"}) {
        auto const fit =
            fit_of("model = \"linear\"\n" + columns({"x"}, response("y", "target = 6\n" + weight)), line);
        auto const optima = optima_of(fit);
        ASSERT_EQ(optima.size(), 1u) << weight;
        EXPECT_NEAR(optima[0].values[0], 2.5, 1e-12) << weight;
        EXPECT_NEAR(optima[0].predicted[0], 6, 1e-12) << weight;
        EXPECT_EQ(fit.fits()[0].regression().scatter(), Scatter::none);
    }
    auto const two =
        fit_of("model = \"linear\"\n" +
                   columns({"a", "b"}, response("y", "target = 4.5\n") + response("z", "target = 1.5\n")),
               "a,b,y,z\n0,0,2,1\n0,1,3,0\n0,2,4,-1\n1,0,3,2\n1,1,4,1\n1,2,5,0\n2,0,4,3\n2,1,5,2\n2,2,6,1\n");
    auto const optima = optima_of(two);
    ASSERT_EQ(optima.size(), 1u);
    EXPECT_NEAR(optima[0].values[0], 1.5, 1e-12);
    EXPECT_NEAR(optima[0].values[1], 1.0, 1e-12);
}

// y = 1 + 2 x + 0 x^2, and x^2 has no part in it.
TEST(FitExactData, EliminationKeepsWhatHasAPart)
{
    auto const fit = fit_of(columns({"x"}, response("y")), line);
    auto const report = report_of(fit, 0);
    ASSERT_EQ(report.terms.size(), 2u);
    EXPECT_NEAR(value_of(report.own_units, "constant"), 1, 1e-12);
    EXPECT_NEAR(value_of(report.own_units, "x"), 2, 1e-12);
    EXPECT_TRUE(std::isnan(report.terms[1].t));
    EXPECT_EQ(report.scatter, 0);
}

TEST(FitSaturated, LeavesOpenWhatIsNotDefined)
{
    auto const fit = fit_of("model = \"linear\"\nselection = \"none\"\n" +
                                columns({"a", "b"}, response("y", "target = 2\n")),
                            "a,b,y\n0,0,1\n1,0,2.2\n0,1,2.9\n");
    auto const report = report_of(fit, 0);
    EXPECT_NEAR(report.r_squared, 1, 1e-12);
    for (double const number :
         {report.adjusted, report.predicted, report.scatter, report.terms[1].standard_error,
          report.terms[1].t, report.terms[1].p, report.terms[1].interval.lower})
        EXPECT_TRUE(std::isnan(number)) << number;
    EXPECT_NE(fit.warnings().at(0).find("3 runs for 3 coefficients leave no degree of freedom"),
              std::string::npos);
    auto const optima = optima_of(fit);
    EXPECT_NEAR(1 + 1.2 * optima.at(0).values[0] + 1.9 * optima[0].values[1], 2, 1e-12);
    auto const text = text_of(fit);
    for (auto const* nonsense : {" inf ", " inf\n", "-inf", " nan", "-nan"})
        EXPECT_EQ(text.find(nonsense), std::string::npos) << text;
    EXPECT_NE(text.find("the targets do not determine the factors"), std::string::npos);
    EXPECT_NE(text.find("  residual                                 0             0"), std::string::npos)
        << text;
}

TEST(FitSaturated, NamesTheRunThatAloneDeterminesACoefficient)
{
    auto const fit = fit_of("model = \"linear\"\nselection = \"none\"\n" + columns({"a"}, response("y")),
                            "a,y\n0,1\n0,1.1\n0,0.9\n1,3\n");
    EXPECT_EQ(fit.warnings(),
              std::vector<std::string>{"`y`: the run in line 5 alone determines a coefficient "
                                       "(leverage 1): predicted R2 is not defined"});
    EXPECT_TRUE(std::isnan(report_of(fit, 0).predicted));
}

TEST(FitResponses, OneThatCannotBeFittedLeavesTheOthers)
{
    std::string const table = "x,y,z\n0,1,7\n1,3,7\n2,5.1,7\n3,7,7\n";
    auto const fit =
        fit_of("model = \"linear\"\n" + columns({"x"}, response("y", "target = 4\n") + response("z")), table);
    EXPECT_TRUE(fit.answers());
    EXPECT_EQ(fit.warnings(),
              std::vector<std::string>{"response `z` is 7 in all 4 runs: there is nothing to fit; this "
                                       "response is not fitted"});
    EXPECT_EQ(optima_of(fit).size(), 1u);
    auto const asked =
        fit_of("model = \"linear\"\n" + columns({"x"}, response("y") + response("z", "target = 7\n")), table);
    EXPECT_FALSE(asked.answers());
    EXPECT_TRUE(optima_of(asked).empty());
    EXPECT_NE(text_of(asked).find("no best point"), std::string::npos);
}

// A factor of two levels has no square, with numbers as well as with words.
TEST(FitCategorical, TwoLevelsBesideASquare)
{
    auto const numbers = report_of(fit_of(columns({"mill", "x"}, response("y")), mills("0", "1")), 0);
    auto const words = report_of(fit_of(columns({"mill", "x"}, response("y")), mills("A", "B")), 0);
    auto const flagged = report_of(
        fit_of("[[factor]]\ncolumn = \"mill\"\ncategorical = true\n" + columns({"x"}, response("y")),
               mills("0", "1")),
        0);
    for (auto const* report : {&numbers, &words, &flagged}) {
        EXPECT_GT(report->r_squared, 0.999);
        EXPECT_NEAR(value_of(report->own_units, "x^2"), 4, 0.07);
        EXPECT_EQ(report->terms.size() + report->left_out.size(), 5u);
        EXPECT_EQ(report->r_squared, numbers.r_squared);
    }
    EXPECT_NEAR(value_of(words.terms, "mill[B]"), 1.5, 0.07); // half of the difference
    EXPECT_NEAR(value_of(numbers.own_units, "mill"), 3, 0.14);
}

// Means 1, 2 and 6 of three materials: their mean is 3, from which steel differs by -1 and glass by 3.
TEST(FitCategorical, LevelsDifferFromTheirMean)
{
    std::string const table = "m,y\nPTFE,0.9\nPTFE,1.1\nsteel,1.9\nsteel,2.1\nglass,6.1\nglass,5.9\n";
    auto const fit = fit_of("model = \"linear\"\n" + columns({"m"}, response("y", "target = 2\n")), table);
    auto const report = report_of(fit, 0);
    EXPECT_NEAR(value_of(report.terms, "constant"), 3, 1e-12);
    EXPECT_NEAR(value_of(report.terms, "m[steel]"), -1, 1e-12);
    EXPECT_NEAR(value_of(report.terms, "m[glass]"), 3, 1e-12);
    // One-way analysis of variance: 28 between on 2 degrees, 0.06 within on 3.
    EXPECT_NEAR(report.anova[0].sum_of_squares, 28, 1e-12);
    EXPECT_NEAR(report.anova[0].f, 14 / 0.02, 1e-9);
    ASSERT_EQ(report.influence.size(), 1u);
    EXPECT_EQ(optima_of(fit).at(0).values[0], 1); // steel
    EXPECT_NE(text_of(fit).find("  m                                    steel\n"), std::string::npos)
        << text_of(fit);
}

// All levels of a factor stay or go together, by their common F: here nothing tells the materials apart.
TEST(FitCategorical, LevelsAreLeftOutTogether)
{
    std::string const table =
        "m,x,y\nA,0,1.01\nB,0,0.99\nC,0,1.0\nA,1,2.0\nB,1,2.02\nC,1,1.99\nA,2,3.0\nB,2,2.98\nC,2,3.01\n";
    auto const report =
        report_of(fit_of("model = \"linear\"\n" + columns({"m", "x"}, response("y")), table), 0);
    EXPECT_EQ(report.terms.size(), 2u);
    ASSERT_EQ(report.left_out.size(), 2u);
    EXPECT_EQ(report.left_out[0].second, report.left_out[1].second);
}

// Day 2 lies 10 above day 1; within days y = 2 x.
TEST(FitBlocks, ShiftWithoutPartInTheAnswer)
{
    std::string const table = "day,x,y\n1,0,0.01\n1,1,2\n1,2,3.99\n2,0,10\n2,1,12.02\n2,2,13.98\n";
    auto const fit = fit_of(
        "model = \"linear\"\nblocks = [\"day\"]\n" + columns({"x"}, response("y", "target = 7\n")), table);
    auto const report = report_of(fit, 0);
    EXPECT_NEAR(value_of(report.own_units, "x"), 1.99, 1e-12);
    EXPECT_NEAR(value_of(report.terms, "day[2]"), 5, 1e-12);
    EXPECT_EQ(report.influence.size(), 1u);
    // At the mean of the days y = 7 lies in the middle.
    EXPECT_NEAR(optima_of(fit).at(0).values[0], 1, 1e-9);
}

// Weights as numbers of equal runs: the coefficients of the long table (NIST's remark on replicates).
TEST(FitWeights, CountLikeRepeatedRuns)
{
    auto const weighted = report_of(
        fit_of("model = \"linear\"\nselection = \"none\"\nweights = \"n\"\n" + columns({"x"}, response("y")),
               "x,y,n\n0,1,1\n1,3.5,3\n2,5,2\n3,6,1\n4,100,0\n"),
        0);
    auto const repeated =
        report_of(fit_of("model = \"linear\"\nselection = \"none\"\n" + columns({"x"}, response("y")),
                         "x,y\n0,1\n1,3.5\n1,3.5\n1,3.5\n2,5\n2,5\n3,6\n"),
                  0);
    EXPECT_EQ(weighted.runs, 4);
    for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(weighted.own_units[k].value, repeated.own_units[k].value, 1e-12);
    EXPECT_NEAR(weighted.r_squared, repeated.r_squared, 1e-12);
}

TEST(FitTerms, CanBeLeftOut)
{
    auto const fit = fit_of("selection = \"none\"\nleave_out = [\"x * mill\", \"x^2\"]\n" +
                                columns({"mill", "x"}, response("y")),
                            mills("A", "B"));
    EXPECT_EQ(report_of(fit, 0).terms.size(), 3u);
    EXPECT_EQ(message("leave_out = [\"x^3\"]\n" + columns({"mill", "x"}, response("y")), mills("A", "B"))
                  .substr(0, 52),
              "fit.toml: leave_out: there is no term `x^3`: did you");
}

TEST(FitMessages, NameWhatIsWrong)
{
    // A word among numbers is a slip, not a level.
    EXPECT_EQ(message(columns({"x"}, response("y")), "x,y\n1,1\n2,2\nO.5,3\n4,5\n"),
              "t.csv:4: column x: \"O.5\" is not a number");
    EXPECT_EQ(message("[[factor]]\ncolumn = \"m\"\nfixed_level = \"C\"\n" + columns({"x"}, response("y")),
                      "m,x,y\nA,1,1\nB,2,2\nA,3,3.1\nB,3,4\n"),
              "fit.toml: factor `m`: fixed_level = \"C\" is not in the table: known: A, B");
    EXPECT_EQ(message("[[factor]]\ncolumn = \"m\"\nlower = 1\n" + columns({"x"}, response("y")),
                      "m,x,y\nA,1,1\nB,2,2\n"),
              "fit.toml: factor `m` is categorical: lower, upper, log_scale and fixed mean nothing; "
              "fixed_level does");
    EXPECT_EQ(message(columns({"x"}, response("y")), "x,y\n"),
              "t.csv: holds no rows; a line of column names and rows of numbers are needed");
}

// 25 factors have 351 terms. y = x1 + x2 x3 but for a scatter that is made of sines.
TEST(FitManyFactors, Ends)
{
    constexpr int factors = 25, rows = 400;
    RandomStream random(3);
    std::string table;
    std::vector<std::string> names;
    for (int k = 0; k < factors; ++k) {
        names.push_back(fmt::format("x{}", k + 1));
        table += names.back() + ",";
    }
    table += "y\n";
    for (int i = 0; i < rows; ++i) {
        std::vector<double> x;
        for (int k = 0; k < factors; ++k) {
            x.push_back(random.uniform());
            table += std::to_string(x.back()) + ",";
        }
        table += std::to_string(x[0] + x[1] * x[2] + 0.01 * std::sin(100.0 * i)) + "\n";
    }
    auto const fit =
        fit_of("alpha = 0.0001\n" + columns(names, response("y", "target = 1\ntolerance = 0.1\n")), table);
    auto const report = report_of(fit, 0);
    EXPECT_EQ(report.left_out.size() + report.terms.size(), 351u);
    EXPECT_NEAR(value_of(report.own_units, "x2*x3"), 1, 0.02);
    EXPECT_LT(report.terms.size(), 12u);
    auto const region = admissible_region(fit);
    EXPECT_EQ(region.points_per_factor, 0); // no grid of 25 factors
    EXPECT_GT(region.share(), 0.05);
}

// y = a x + b by the textbook: x 1..5, y 2, 4, 5, 4, 5: slope .6, intercept 2.2, s^2 = 2.4/3, t_.975(3)
// = 3.18245.
TEST(FitDocument, HoldsAllNumbers)
{
    auto const fit = fit_of("model = \"linear\"\nselection = \"none\"\n" + columns({"x"}, response("y")),
                            "x,y\n1,2\n2,4\n3,5\n4,4\n5,5\n");
    auto const json = nlohmann::json::parse(fit_json(fit, {}, {}));
    auto const& y = json["responses"][0];
    auto const& slope = y["own_units"][1];
    EXPECT_EQ(slope["term"], "x");
    EXPECT_NEAR(slope["value"].get<double>(), 0.6, 1e-12);
    double const error = std::sqrt(0.8 / 10);
    EXPECT_NEAR(slope["standard_error"].get<double>(), error, 1e-12);
    EXPECT_NEAR(slope["upper"].get<double>(), 0.6 + 3.182446305284263 * error, 1e-9);
    auto const& last = y["fitted"][4];
    EXPECT_EQ(last["line"], 6);
    EXPECT_NEAR(last["predicted"].get<double>(), 5.2, 1e-12);
    EXPECT_NEAR(last["leverage"].get<double>(), 0.6, 1e-12); // 1/5 + 4/10
    EXPECT_NEAR(last["mean_upper"].get<double>(), 5.2 + 3.182446305284263 * std::sqrt(0.8 * 0.6), 1e-9);
    EXPECT_NEAR(last["run_upper"].get<double>(), 5.2 + 3.182446305284263 * std::sqrt(0.8 * 1.6), 1e-9);
    EXPECT_TRUE(y["coded_terms"][0]["vif"].is_null());
    auto const csv = fit_csv(fit, {}, {});
    EXPECT_NE(csv.find("\"y\",\"fitted\",6,\"measured\",5.0\n"), std::string::npos) << csv;
    EXPECT_NE(csv.find("\"y\",\"fit\",,\"runs\",5\n"), std::string::npos) << csv;
}
