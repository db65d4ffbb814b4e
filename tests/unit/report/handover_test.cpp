#include "demens/contact/law_words.hpp"
#include "demens/contact/pair_material.hpp"
#include "report/handover/counterpart.hpp"
#include "report/handover/lammps_damping.hpp"
#include "report/handover/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace demens::report {
namespace {

contact::Model model_with(contact::PairProperties pair)
{
    pair.first = pair.second = "sand";
    return {{{"sand", 2600, 1e7, 0.25}}, {pair}};
}

std::string match_of(std::vector<MappedItem> const& items, std::string const& key)
{
    auto const found = std::find_if(items.begin(), items.end(), [&](auto const& item) {
        return item.path == "contact.sand_sand." + key;
    });
    return found == items.end() ? "absent" : name_of(found->there.match);
}

TEST(Counterpart, EveryLawIsInTheTable)
{
    auto const check = [](char const* kind, auto const& words) {
        for (auto const& word : words)
            for (Code const code : all_codes)
                EXPECT_NE(counterpart_of_law(code, kind, word.text).note, "not known")
                    << kind << " " << word.text;
    };
    check("normal", contact::normal_laws);
    check("tangential", contact::tangential_laws);
    check("rolling", contact::rolling_laws);
    check("cohesion", contact::cohesion_laws);
}

TEST(Counterpart, SaysWhatHasNone)
{
    contact::PairProperties pair;
    pair.rolling = contact::RollingLaw::viscous;
    pair.rolling_viscosity = 1e-3;
    pair.kinetic_friction = 0.3;
    pair.friction_weakening = 0.5;
    auto const items = mapped(Code::liggghts, model_with(pair));
    EXPECT_EQ(match_of(items, "rolling"), "has no counterpart");
    EXPECT_EQ(match_of(items, "kinetic_friction"), "has no counterpart");
    EXPECT_EQ(match_of(items, "friction_weakening"), "has no counterpart");
    EXPECT_EQ(match_of(items, "friction_limit"), "nearest");
    EXPECT_EQ(match_of(items, "surface_energy"), "absent"); // no law uses it
    EXPECT_FALSE(has_all_laws(items));
    EXPECT_TRUE(has_all_laws(mapped(Code::liggghts, model_with({}))));
}

TEST(Counterpart, ConvertsTheSurfaceEnergyOfEdem)
{
    contact::PairProperties pair;
    pair.cohesion = contact::CohesionLaw::jkr;
    pair.surface_energy = 0.05;
    EXPECT_EQ(counterpart_of_coefficient(Code::edem, "surface_energy", pair).value, "0.1");
    EXPECT_EQ(counterpart_of_coefficient(Code::lammps, "surface_energy", pair).value, "0.05");
}

TEST(LammpsDamping, IsTheSameByItsPolynomial)
{
    for (double const e : {0.2, 0.5, 0.9}) {
        double const x = tsuji_restitution(e),
                     polynomial = 1.2728 - 4.2783 * x + 11.087 * x * x - 22.348 * std::pow(x, 3) +
                                  27.467 * std::pow(x, 4) - 18.022 * std::pow(x, 5) + 4.8218 * std::pow(x, 6),
                     wanted = std::sqrt(5) * -std::log(e) / std::hypot(std::log(e), std::numbers::pi);
        EXPECT_NEAR(polynomial, wanted, 1e-9) << e;
    }
    EXPECT_EQ(tsuji_restitution(1), 1);
    EXPECT_TRUE(std::isnan(tsuji_restitution(0.05)));
}

TEST(LammpsDamping, OneMaterialHasTheModuliOfAPair)
{
    contact::Material const glass{"glass", 2500, 6e7, 0.2}, steel{"steel", 7800, 2e8, 0.3};
    contact::PairMaterial const alike(glass, glass, {}), pair(glass, steel, {});
    auto const same = like_material(alike.effective_youngs_modulus, alike.effective_shear_modulus);
    EXPECT_NEAR(same.youngs_modulus, 6e7, 1);
    EXPECT_NEAR(same.poisson_ratio, 0.2, 1e-9);
    auto const like = like_material(pair.effective_youngs_modulus, pair.effective_shear_modulus);
    contact::Material const both{"", 1, like.youngs_modulus, like.poisson_ratio};
    contact::PairMaterial const again(both, both, {});
    EXPECT_NEAR(again.effective_youngs_modulus / pair.effective_youngs_modulus, 1, 1e-12);
    EXPECT_NEAR(again.effective_shear_modulus / pair.effective_shear_modulus, 1, 1e-12);
}

TEST(Parameters, OfLiggghtsHoldEveryPair)
{
    contact::PairProperties pair;
    pair.rolling = contact::RollingLaw::epsd2;
    pair.rolling_friction = 0.07;
    auto const text = liggghts_parameters(model_with(pair));
    EXPECT_NE(text.find("coefficientRollingFriction peratomtypepair 1 &\n  0.07\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("pair_style gran model hertz tangential history rolling_friction epsd2\n"),
              std::string::npos)
        << text;
}

} // namespace
} // namespace demens::report
