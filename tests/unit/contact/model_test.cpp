// A pair of materials from its table: what each law needs, and what no law may have.
#include "demens/base/error.hpp"
#include "demens/contact/model.hpp"
#include "tests/support/fault_of.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;

//! A table that gives only what every pair must give.
OptionValues smallest_table()
{
    OptionValues values = defaults_of(contact::pair_options());
    values.set("restitution", 0.5);
    values.set("static_friction", 0.3);
    return values;
}

std::string refusal(OptionValues const& values)
{
    return test::fault_of([&] { contact::make_pair("a", "b", values); });
}

TEST(PairTable, LawsNameTheKeyThatTheyLack)
{
    struct Case
    {
        std::string kind, law;
        std::vector<std::string> keys;
    };
    for (auto const& [kind, law, keys] :
         {Case{"rolling", "constant_torque", {"rolling_friction"}},
          Case{"rolling", "viscous", {"rolling_viscosity"}}, Case{"rolling", "epsd", {"rolling_friction"}},
          Case{"rolling", "epsd2", {"rolling_friction"}},
          Case{"cohesion", "linear_cohesion", {"cohesion_energy_density"}},
          Case{"cohesion", "sjkr2", {"cohesion_energy_density"}},
          Case{"cohesion", "van_der_waals", {"surface_energy"}}, Case{"cohesion", "dmt", {"surface_energy"}},
          Case{"cohesion", "jkr", {"surface_energy"}},
          Case{"cohesion", "capillary", {"surface_tension", "bridge_volume"}}}) {
        auto values = smallest_table();
        values.set(kind, law);
        for (auto const& key : keys) {
            auto const message = refusal(values);
            EXPECT_NE(message.find(kind + " = \"" + law + "\" needs the key " + key), std::string::npos)
                << law << ": " << message;
            values.set(key, 0.0);
        }
        EXPECT_EQ(refusal(values), "") << law;
    }
}

TEST(PairTable, WhatNoLawNeedsIsZero)
{
    auto const pair = contact::make_pair("a", "b", smallest_table());
    EXPECT_EQ(pair.rolling_friction, 0);
    EXPECT_EQ(pair.rolling_viscosity, 0);
    EXPECT_EQ(pair.surface_energy, 0);
    EXPECT_EQ(pair.bridge_volume, 0);
    EXPECT_EQ(pair.kinetic_friction, 0.3);
    EXPECT_FALSE(pair.cohesion_in_limit);
}

TEST(Drift, CoefficientsChangeLinearlyInTimeAndNothingElseDoes)
{
    auto values = smallest_table();
    values.set("added_surface_energy", 0.02);
    values.set("added_charge_pressure", 3.0);
    values.set("surface_energy", 0.05);
    contact::Model model{{}, {contact::make_pair("a", "b", values)}};
    EXPECT_FALSE(contact::drifts(model));
    values.set("friction_drift_per_s", -0.1);
    values.set("cohesion_drift_per_s", 0.5);
    model.pairs.push_back(contact::make_pair("a", "a", values));
    EXPECT_TRUE(contact::drifts(model));
    auto const later = contact::drifted(model, 4);
    EXPECT_DOUBLE_EQ(later.pairs[1].static_friction, 0.6 * 0.3);
    EXPECT_DOUBLE_EQ(later.pairs[1].kinetic_friction, 0.6 * 0.3);
    EXPECT_DOUBLE_EQ(later.pairs[1].surface_energy, 3 * 0.05);
    EXPECT_DOUBLE_EQ(later.pairs[1].added_surface_energy, 3 * 0.02);
    EXPECT_EQ(later.pairs[1].added_charge_pressure, 3);
    EXPECT_EQ(later.pairs[1].restitution, 0.5);
    EXPECT_EQ(later.pairs[0].static_friction, 0.3);
    EXPECT_EQ(later.pairs[0].added_surface_energy, 0.02);
    // It ends at a thousandth, not below 0.
    EXPECT_DOUBLE_EQ(contact::drifted(model, 1000).pairs[1].static_friction, 0.3e-3);
}

TEST(PairTable, KineticFrictionIsAtMostStatic)
{
    auto values = smallest_table();
    values.set("kinetic_friction", 0.31);
    EXPECT_NE(refusal(values).find("kinetic_friction 0.31"), std::string::npos) << refusal(values);
}

} // namespace
