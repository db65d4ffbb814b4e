#include "demens/rig/programme/plausible.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::rig {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Plausible, MaterialsOfAWrongUnitAreWarnedOf)
{
    EXPECT_THAT(unit_warnings(contact::Model{{{"glass", 2500, 1e7, 0.2}}, {}}), IsEmpty());
    EXPECT_THAT(unit_warnings(contact::Model{{{"soft", 2500, 200, 0.2}, {"light", 2.5, 6e10, 0.2}}, {}}),
                ElementsAre(HasSubstr("material.soft.youngs_modulus = 200 Pa is softer than a gel"),
                            HasSubstr("material.light.density = 2.5 kg/m^3 is as light as a gas")));
}

TEST(Plausible, LengthsOfAWrongUnitAreWarnedOf)
{
    Apparatus apparatus{.model = {}, .options = {}};
    apparatus.bodies = {{.position = {}, .radius = 2e-3}};
    apparatus.walls = {{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1e6, 1e6}}}; // a plane
    EXPECT_THAT(unit_warnings(apparatus), IsEmpty());
    apparatus.bodies[0].radius = 2;
    apparatus.walls.push_back({.shape = dem::Disc{{}, {0, 0, 1}, 60}});
    EXPECT_THAT(unit_warnings(apparatus), ElementsAre(HasSubstr("a sphere is 4 m wide"),
                                                      HasSubstr("a wall reaches 60 m from its middle")));
}

} // namespace
} // namespace demens::rig
