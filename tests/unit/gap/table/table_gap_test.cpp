// A table of another program's runs against measurements at several points.
#include "gap/table/table_report.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/unit/tao_calib/solver/petsc_environment.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using namespace demens;
using namespace demens::test;

gap::TableGap gap_of(gap::MeasuredTable const& measured)
{
    return gap::table_gap(measured, tao_calib::Pounders(*tao_calib::PetscEnvironment::session()));
}

//! Runs on a grid of a speed, a friction and a rolling friction, with two responses and a little scatter.
double angle(double speed, double friction, double rolling)
{
    return 20 + 0.01 * speed + 20 * friction + 10 * rolling + 0.004 * speed * friction -
           8 * friction * friction;
}
double flow(double speed, double friction, double rolling)
{
    return 0.001 * speed - 0.1 * friction - 0.02 * rolling + 0.0003 * speed * rolling;
}
std::string runs(std::string const& more_names = "", std::string const& more = "")
{
    std::string text = "speed,friction,rolling,angle,flow" + more_names + "\n";
    int run = 0;
    for (double const speed : {400, 600, 800})
        for (double const friction : {0.2, 0.5, 0.8})
            for (double const rolling : {0.0, 0.2, 0.4}) {
                double const scatter = 0.02 * (run++ * 7 % 5 - 2);
                text += fmt::format("{},{},{},{},{}{}\n", speed, friction, rolling,
                                    angle(speed, friction, rolling) + scatter,
                                    flow(speed, friction, rolling) + 0.01 * scatter, more);
            }
    return text;
}

std::string const sections =
    "[[factor]]\ncolumn = \"speed\"\n[[factor]]\ncolumn = \"friction\"\n[[factor]]\ncolumn = \"rolling\"\n"
    "[[response]]\ncolumn = \"angle\"\nscale = 0.1\n[[response]]\ncolumn = \"flow\"\nscale = 0.002\n";

gap::MeasuredTable table_of(std::string const& measured, std::string const& fit = "form_floor = 0\n")
{
    return gap::measured_table(
        tao_calib::FitInput::from_text("[fit]\ntable = \"t.csv\"\nmeasured = \"m.csv\"\n" + fit + sections,
                                       "fit.toml"),
        text::CsvTable::from_text(runs(), "t.csv"), text::CsvTable::from_text(measured, "m.csv"));
}

//! Measured where friction is 0.4 and rolling friction 0.1, but for what is added at 800.
std::string measured(double to_angle = 0, double to_flow = 0)
{
    std::string text = "speed,angle,flow\n";
    for (double const speed : {400, 500, 650, 800})
        text += fmt::format("{},{},{}\n", speed, angle(speed, 0.4, 0.1) + (speed == 800 ? to_angle : 0),
                            flow(speed, 0.4, 0.1) + (speed == 800 ? to_flow : 0));
    return text;
}

TEST(TableGap, OneSetOfFactorsThatMeetsAllIsFoundAndNothingIsBeyondChance)
{
    auto const table = table_of(measured());
    auto const found = gap_of(table);
    EXPECT_NEAR(found.best.values[1], 0.4, 0.01);
    EXPECT_NEAR(found.best.values[2], 0.1, 0.02);
    EXPECT_FALSE(found.located.beyond_floor());
    EXPECT_EQ(found.form_error_that_hides_it, 0);
    EXPECT_EQ(found.cells.size(), 8u);
    for (auto const& cell : found.located.cells)
        EXPECT_NE(cell.finding, gap::Finding::beyond_floor);
    auto const text = gap::table_gap_text(table, found);
    EXPECT_NE(text.find("one set of factors meets all points within the errors"), std::string::npos) << text;
}

TEST(TableGap, AValueThatIsOffIsLocated)
{
    auto const table = table_of(measured(0, 0.03)); // 15 standard deviations, 4 % of the flow
    auto const found = gap_of(table);
    EXPECT_TRUE(found.located.beyond_floor());
    EXPECT_LT(found.located.p, 0.01);
    for (std::size_t i = 0; i < found.cells.size(); ++i)
        if (std::abs(found.located.cells[i].sigmas) == found.located.largest) {
            EXPECT_EQ(found.evidence.cells[i].name, "flow at speed 800");
            EXPECT_GT(found.located.cells[i].residual, 0);
        }
    EXPECT_GT(found.form_error_that_hides_it, 0.002);
    EXPECT_LT(found.form_error_that_hides_it, 0.04);
    // With that much error of the laws themselves it is hidden.
    EXPECT_FALSE(gap_of(table_of(measured(0, 0.03), "")).located.beyond_floor());
    auto const document = gap::table_gap_document(table, found);
    EXPECT_TRUE(document["contradiction"].get<bool>());
    EXPECT_EQ(document["cells"].size(), 8u);
    EXPECT_EQ(document["points"][3]["point"], "speed 800");
}

TEST(TableGap, StandardDeviationsOfTheTableCount)
{
    auto const with_sd = [](double sd) {
        std::string text = "speed,angle,angle_sd\n";
        for (double const speed : {400, 500, 650, 800})
            text += fmt::format("{},{},{}\n", speed, angle(speed, 0.4, 0.1) + (speed == 800 ? 1 : 0), sd);
        return gap_of(table_of(text));
    };
    EXPECT_TRUE(with_sd(0.05).located.beyond_floor());
    EXPECT_FALSE(with_sd(2).located.beyond_floor());
    EXPECT_TRUE(with_sd(2).assumed.empty());
}

//! El Kassem et al. 2021, Table 7: the optima that they found for each speed by itself.
TEST(TableGap, LactoseAtThreeSpeedsContradictsOneSetInItsFlow)
{
    auto const table = gap::read_measured(std::filesystem::path(DEMENS_TEST_DATA) / "three_speeds.toml");
    auto const found = gap_of(table);
    ASSERT_EQ(found.own.size(), 3u);
    double const published[3][3] = {{0.523, 0.375, 0.1}, {0.313, 0.36, 0.32}, {0.51, 0.347, 0.1}};
    for (std::size_t p = 0; p < 3; ++p)
        for (Eigen::Index k = 0; k < 3; ++k)
            EXPECT_NEAR(found.own[p].values[k + 1], published[p][k], 0.025) << p << " " << k;
    EXPECT_TRUE(found.located.beyond_floor());
    for (std::size_t i = 0; i < found.cells.size(); ++i)
        EXPECT_EQ(std::abs(found.located.cells[i].sigmas) > 2,
                  found.evidence.cells[i].name == "mass_flow at speed 600" ||
                      found.evidence.cells[i].name == "mass_flow at speed 800")
            << found.evidence.cells[i].name;
    EXPECT_NEAR(found.form_error_that_hides_it, 0.0036, 0.0005);
    EXPECT_NE(gap::table_gap_text(table, found).find("not to be said of a table"), std::string::npos);
}

TEST(TableGap, BadInputIsNamed)
{
    auto const fault = [](std::string const& text, std::string const& fit = "") {
        return fault_of([&] { table_of(text, fit); });
    };
    EXPECT_NE(fault("speed,angle\n400,30\n").find("one point alone"), std::string::npos);
    EXPECT_NE(fault("speed,height\n400,30\n500,31\n").find("nothing is measured"), std::string::npos);
    EXPECT_NE(fault("angle,flow\n30,1\n31,2\n").find("where was this measured"), std::string::npos);
    EXPECT_NE(fault("speed,angle\n400,30\n900,31\n").find("m.csv:3: `speed` = 900 is beyond all runs"),
              std::string::npos);
    EXPECT_NE(fault("speed,angle\n400,30\n,31\n").find("`speed` is missing"), std::string::npos);
    EXPECT_NE(fault("speed,angle,angle_sd\n400,30,0\n500,31,1\n").find("must be above 0"), std::string::npos);
    EXPECT_NE(fault_of([] {
                  gap::measured_table(
                      tao_calib::FitInput::from_text(
                          "[fit]\ntable = \"t.csv\"\nmeasured = \"m.csv\"\n[[factor]]\ncolumn = "
                          "\"speed\"\nfixed = 400\n[[factor]]\ncolumn = \"friction\"\n"
                          "[[response]]\ncolumn = \"angle\"\n",
                          "fit.toml"),
                      text::CsvTable::from_text(runs(), "t.csv"),
                      text::CsvTable::from_text(measured(), "m.csv"));
              }).find("leave out one"),
              std::string::npos);
    EXPECT_NE(fault("speed,friction,rolling,angle\n400,.4,.1,30\n500,.4,.1,31\n").find("none is left"),
              std::string::npos);
    auto const table = table_of("speed,angle,operator,flow_sd\n400,33,1,2\n500,34,2,2\n");
    ASSERT_EQ(table.warnings.size(), 2u);
    EXPECT_NE(table.warnings.front().find("`operator`"), std::string::npos);
    EXPECT_NE(table.warnings.back().find("`flow_sd`"), std::string::npos);
}

TEST(TableGap, AsManyValuesAsFactorsTestNothing)
{
    auto const table = table_of(
        fmt::format("speed,angle,flow\n400,{},\n800,,{}\n", angle(400, 0.4, 0.1), flow(800, 0.4, 0.1)));
    auto const found = gap_of(table);
    EXPECT_EQ(found.cells.size(), 2u);
    EXPECT_NE(gap::table_gap_text(table, found).find("not testable"), std::string::npos);
}

} // namespace
