#include "ensemble/curve/units.hpp"

#include "demens/base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::ensemble {
namespace {

TEST(Units, AreFoundInNamesOfColumns)
{
    EXPECT_EQ(unit_in_name("t_s"), "s");
    EXPECT_EQ(unit_in_name("mass_upper_kg"), "kg");
    EXPECT_EQ(unit_in_name("flow_kg_s"), "kg_s");
    EXPECT_EQ(unit_in_name("torque_n_m"), "n_m");
    EXPECT_EQ(unit_in_name("torque_N_mm"), "N_mm");
    EXPECT_EQ(unit_in_name("Mass [g]"), "g");
    EXPECT_EQ(unit_in_name("v (mm/s)"), "mm/s");
    EXPECT_EQ(unit_in_name("t / ms"), " ms");
    EXPECT_EQ(unit_in_name("mass"), "");
    EXPECT_EQ(unit_in_name("mass_upper"), "");
}

TEST(Units, AreTurnedIntoEachOther)
{
    EXPECT_DOUBLE_EQ(unit_ratio("g", "kg"), 1e-3);
    EXPECT_DOUBLE_EQ(unit_ratio("min", "s"), 60);
    EXPECT_DOUBLE_EQ(unit_ratio("kg/h", "kg/s"), 1.0 / 3600);
    EXPECT_DOUBLE_EQ(unit_ratio("J/kg", "mJ/kg"), 1e3);
    EXPECT_DOUBLE_EQ(unit_ratio("mN m", "N m"), 1e-3);
    EXPECT_DOUBLE_EQ(unit_ratio("percent", "%"), 1);
    EXPECT_NEAR(unit_ratio("rad", "deg"), 57.29577951308232, 1e-12);
    EXPECT_DOUBLE_EQ(unit_ratio("furlong", "furlong"), 1); // whatever it is
}

TEST(Units, ThatMeasureSomethingElseAreRefused)
{
    auto const message = [](char const* from, char const* to) -> std::string {
        try {
            unit_ratio(from, to);
        } catch (InputError const& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_EQ(message("mm", "kg"), "mm is a unit of length; the unit must be one of kg, g, mg, t");
    EXPECT_THAT(message("stone", "kg"), ::testing::HasSubstr("stone is no unit that is known"));
}

} // namespace
} // namespace demens::ensemble
