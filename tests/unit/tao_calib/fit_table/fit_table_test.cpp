#include "tao_calib/fit_table/fit_text.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tests/unit/tao_calib/solver/petsc_environment.hpp"

#include "demens/base/error.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::tao_calib;

namespace {

Pounders pounders()
{
    return Pounders(*PetscEnvironment::session());
}

std::string message(auto&& action)
{
    try {
        action();
    } catch (InputError const& error) {
        return error.what();
    }
    return "no error";
}

//! The auger at 800 rev/min with the wall friction of the paper's figure 13. The angle of repose may differ
//! by the 0.3 degrees that the paper accepts, the bulk density by its scatter about the model, and the mass
//! flow is a line.
char const* const auger = R"(
[fit]
table = "auger_lactose_doe.csv"
[[factor]]
column = "speed"
fixed = 800
[[factor]]
column = "mu_s_pp"
[[factor]]
column = "mu_s_pw"
fixed = 0.347
[[factor]]
column = "mu_r_pp"
[[response]]
column = "aor"
target = 33.2
tolerance = 0.3
[[response]]
column = "bulk_density"
target = 0.758
tolerance = 0.002
[[response]]
column = "mass_flow"
target = 0.5074
tolerance = 0.0005
[[response]]
column = "na_tke"
)";

TableFit fit_of(std::string const& toml)
{
    auto const input = FitInput::from_text(toml, DEMENS_TEST_DATA "/fit.toml");
    return TableFit(input, text::CsvTable::from_file(input.table));
}

//! y and z of the factors a and b.
TableFit fit_of_table(std::string const& rows, std::string const& more = "",
                      std::string const& responses = "[[response]]\ncolumn = \"y\"\n")
{
    auto const input =
        FitInput::from_text("[fit]\ntable = \"t.csv\"\nmodel = \"linear\"\n" + more +
                                "\n[[factor]]\ncolumn = \"a\"\n[[factor]]\ncolumn = \"b\"\n" + responses,
                            "fit.toml");
    return TableFit(input, text::CsvTable::from_text(rows, "t.csv"));
}

std::string const plane = "a,b,y\n0,0,1\n1,0,3.1\n0,1,2\n1,1,3.9\n0.5,0.5,2.6\n";

} // namespace

// El Kassem et al. (2021), section 4.4 and figure 13: mu_r between 0.1 and 0.2 with mu_s between 0.34 and
// 0.5, read off a graph: to a quarter of a tenth.
TEST(FitTable, AdmissibleRegionOfTheAuger)
{
    auto const region = admissible_region(fit_of(auger));
    ASSERT_EQ(region.parts.size(), 1u);
    EXPECT_NEAR(region.lower()[0], 0.34, 0.025);
    EXPECT_NEAR(region.upper()[0], 0.50, 0.025);
    EXPECT_NEAR(region.lower()[1], 0.10, 1e-12);
    EXPECT_NEAR(region.upper()[1], 0.20, 0.025);
    EXPECT_LT(region.share(), 0.01);
}

// Table 7, run 23: at 800 rev/min and a wall friction of 0.347 the optimum is mu_s = 0.51, mu_r = 0.1.
TEST(FitTable, OptimumOfTheAugerFromTheDataAlone)
{
    auto const optima = fit_optima(fit_of(auger), pounders());
    ASSERT_FALSE(optima.empty());
    EXPECT_EQ(optima[0].values[0], 800);
    EXPECT_NEAR(optima[0].values[1], 0.51, 0.005);
    EXPECT_EQ(optima[0].values[2], 0.347);
    EXPECT_NEAR(optima[0].values[3], 0.1, 1e-6);
}

// Table 8: the paper's optimum, simulated, gave 33.5 degrees, .757 g/cm3, .5053 g/s; the models say so within
// twice their scatter of .60, .0019, .0055.
TEST(FitTable, PredictsTheConfirmationRunOfTheAuger)
{
    auto const predicted = fit_of(auger).predict(Eigen::Vector2d(.51, .1));
    EXPECT_NEAR(predicted[0], 33.5, 1.2);
    EXPECT_NEAR(predicted[1], 0.757, 0.0038);
    EXPECT_NEAR(predicted[2], 0.5053, 0.011);
}

TEST(FitTable, TextSaysWhatWasFound)
{
    auto const fit = fit_of(auger);
    auto const text = fit_text(fit, fit_optima(fit, pounders()), admissible_region(fit));
    for (auto const* part :
         {"aor: 20 runs, R2 0.98", "adjusted 0.9740, predicted 0.94", "mu_s_pp*mu_r_pp             left out",
          "aor                                33.3201  target 33.2, deviation +0.12",
          "mean 32.4702 to 34.1701, one run 31.7541 to 34.8862", "best point, sum of squares",
          "speed                                  800  fixed", "admissible region:"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

// y = a + b between 0 and 2, to be 0.5 within 0.1: a band from (0, .5) to (.5, 0); and |2 a - 1| = .5 in two
// strips.
TEST(FitTable, AdmissibleRegionsOfKnownShape)
{
    std::string const responses = "[[response]]\ncolumn = \"y\"\ntarget = 0.5\ntolerance = 0.1\n";
    std::string const exact = "a,b,y\n0,0,0\n1,0,1\n0,1,1\n1,1,2\n0.5,0.5,1\n";
    auto const band = admissible_region(fit_of_table(exact, "", responses), 1002001);
    ASSERT_EQ(band.parts.size(), 1u);
    EXPECT_NEAR(band.share(), (0.36 - 0.16) / 2, 2e-3);
    EXPECT_NEAR(band.upper()[0], 0.6, 2e-3);
    EXPECT_EQ(band.lower()[0], 0);

    auto const below = admissible_region(
        fit_of_table(exact, "", responses + "[[constraint]]\nexpression = \"b <= a\"\n"), 1002001);
    EXPECT_NEAR(below.share(), (0.36 - 0.16) / 2, 2e-3); // half of the band in half of the square
    EXPECT_NEAR(below.upper()[1], 0.3, 2e-3);

    auto const input =
        FitInput::from_text("[fit]\ntable = \"t.csv\"\nselection = \"none\"\n[[factor]]\ncolumn = \"a\"\n"
                            "[[response]]\ncolumn = \"y\"\ntarget = 0.25\ntolerance = 0.05\n",
                            "fit.toml");
    TableFit const parabola(
        input, text::CsvTable::from_text("a,y\n0,1\n0.25,0.25\n0.5,0\n0.75,0.25\n1,1\n", "t.csv"));
    auto const strips = admissible_region(parabola, 2000);
    ASSERT_EQ(strips.parts.size(), 2u);
    // (2 a - 1)^2 from .2 to .3: sqrt(.3) - sqrt(.2) wide in 2 a - 1 on both sides
    EXPECT_NEAR(strips.share(), std::sqrt(.3) - std::sqrt(.2), 2e-3);
    EXPECT_EQ(fit_optima(parabola, pounders()).size(), 2u);
}

TEST(FitTable, LeavesOutRowsWithAWarning)
{
    auto const fit = fit_of_table(plane + "1,,3\n0.2,0.3,\n1,1,3.9\n0,0,1.1\n");
    EXPECT_EQ(fit.fits()[0].regression().runs(), 7); // the five and both repeats
    ASSERT_EQ(fit.warnings().size(), 3u);
    EXPECT_EQ(fit.warnings()[0], "t.csv:7: left out, since `b` is missing");
    EXPECT_EQ(fit.warnings()[1],
              "t.csv:9: repeats line 5 in every number; it is kept, as a run of its own. If it is a "
              "copy: repeated_rows = \"leave_out\"");
    auto const without = fit_of_table(plane + "1,1,3.9\n0,0,1.1\n", "repeated_rows = \"leave_out\"");
    EXPECT_EQ(without.fits()[0].regression().runs(), 6);
    EXPECT_EQ(without.warnings()[0], "t.csv:7: repeats line 5 in every number: left out");
    EXPECT_EQ(fit.warnings()[2], "t.csv: `y` is missing in line 8; fitted without");
}

TEST(FitTable, SaysByHowMuchATargetIsOutOfReach)
{
    auto const fit = fit_of_table(plane, "", "[[response]]\ncolumn = \"y\"\ntarget = 5\n");
    ASSERT_EQ(fit.warnings().size(), 1u);
    EXPECT_EQ(fit.warnings()[0], "`y`: the target 5 is above every run, by 1.1");
}

TEST(FitTable, BadInputIsNamed)
{
    auto const fit = [](std::string const& text) {
        return message([&] { FitInput::from_text(text, "fit.toml"); });
    };
    EXPECT_NE(fit("[fit]\ntabel = \"x.csv\"\n").find("fit.toml:2: fit.tabel"), std::string::npos);
    EXPECT_NE(fit("[fit]\ntable = \"x.csv\"\nmodel = \"cubic\"\n").find("cubic"), std::string::npos);
    EXPECT_NE(fit("[campaign]\nname = \"x\"\n").find("this is a campaign"), std::string::npos);
    EXPECT_NE(fit("a,b\n1,2\n").find("fit.toml:1: is a table"), std::string::npos);
    EXPECT_NE(fit("\x89HDF\r\n").find("an HDF5 file"), std::string::npos);
    EXPECT_NE(fit("[fit]\ntable = \"x.csv\"\n[[factor]]\ncolumn = \"a\"\nlog_scale = true\nlower = 0\n")
                  .find("fit.toml:6: factor[1].lower = 0: must be above 0"),
              std::string::npos);
    EXPECT_EQ(fit("[fit]\ntable = \"x.csv\"\n"),
              "fit.toml: a fit needs at least one [[factor]] and one [[response]]");
    EXPECT_EQ(message([&] { fit_of_table("a,y\n0,1\n1,2\n"); }),
              "fit.toml:8: factor[2].column = \"b\": t.csv has no column `b`; its columns are a, y");
    EXPECT_EQ(message([&] { fit_of_table("a,b,y\n0,0,1\n1,1,x\n"); }),
              "t.csv:3: column y: \"x\" is not a number");
    EXPECT_EQ(message([&] { fit_of_table("a,b,y\n0,0,1\n1,0\n"); }),
              "t.csv:3: has 2 values where the header has 3 columns, separated by commas");
    EXPECT_EQ(message([&] { fit_of_table("a,b,y\n0,1,1\n1,1,2\n"); }),
              "t.csv: factor `b` does not vary: its effect cannot be found");
    EXPECT_EQ(
        message([&] { fit_of_table("a,b,y\n0,0,1\n1,1,2\n0.5,0.5,1.7\n0.2,0.2,1.3\n"); }),
        "fit.toml: response `y`: the runs cannot tell these terms apart: b = a; leave terms out or add runs");
    EXPECT_EQ(message([&] { fit_of_table("a,b,y\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n"); }),
              "fit.toml: response `y` is 1 in all 4 runs: there is nothing to fit");
}
