// One contact evaluated in three ways: by the blocks of the CPU engine, by the functors one contact at a
// time, and by these as the device's compiler makes them, on the host and, where there is one, on a device.
// All laws with all others, with and without the ledger, among spheres and with walls.
#include "tests/parity/block_path.hpp"

#include <gtest/gtest.h>

#include <map>

namespace {

using namespace demens;
using namespace demens::parity;

//! Coefficients for all laws, and one law of each kind.
contact::PairProperties properties(std::array<std::string, 4> const& laws, bool cohesion_in_limit,
                                   std::string const& friction_limit, bool with_all = false)
{
    auto values = defaults_of(contact::pair_options());
    for (auto const& [key, value] : {std::pair{"restitution", 0.4},
                                     {"static_friction", 0.5},
                                     {"kinetic_friction", 0.4},
                                     {"rolling_friction", 0.1},
                                     {"rolling_viscosity", 1e-3},
                                     {"rolling_damping", 0.3},
                                     {"surface_energy", 0.05},
                                     {"cohesion_energy_density", 1e4},
                                     {"surface_tension", 0.07},
                                     {"hamaker_constant", 4e-13},
                                     {"bridge_volume", 1e-14}})
        values.set(key, value);
    values.set("normal", laws[0]);
    values.set("cohesion", laws[1]);
    values.set("tangential", laws[2]);
    values.set("rolling", laws[3]);
    values.set("cohesion_in_limit", cohesion_in_limit);
    values.set("friction_limit", friction_limit);
    if (with_all && laws[0] == "hertz")
        values.set("viscoelastic_time", 1e-6);
    if (with_all)
        for (auto const& [key, value] : {std::pair{"added_energy_density", 2e4},
                                         {"added_surface_energy", 0.02},
                                         {"added_surface_gap", 2e-6},
                                         {"added_surface_tension", 0.05},
                                         {"added_bridge_volume", 1e-6},
                                         {"added_charge_pressure", 30.0},
                                         {"friction_weakening", 0.6},
                                         {"friction_weakening_speed", 0.02}})
            values.set(key, value);
    return contact::make_pair("grain", "grain", values);
}

std::vector<std::string> choices(std::string const& key)
{
    for (auto const& spec : contact::pair_options())
        if (spec.key == key)
            return spec.choices;
    return {};
}

//! Every combination of laws in all four ways to use it, with its name.
struct Cases
{
    std::vector<std::string> names{};
    std::vector<Case> cases{};

    Cases()
    {
        contact::Material const grain{"grain", 2500, 5e6, 0.3};
        for (auto const& normal : choices("normal"))
            for (auto const& cohesion : choices("cohesion"))
                for (auto const& tangential : choices("tangential"))
                    for (auto const& rolling : choices("rolling"))
                        for (Partner const partner : {Partner::sphere, Partner::wall})
                            for (bool const ledger : {false, true}) {
                                contact::LawSet const laws(
                                    grain, grain,
                                    properties({normal, cohesion, tangential, rolling}, ledger,
                                               partner == Partner::wall ? "whole" : "elastic"));
                                names.push_back(normal + " + " + cohesion + " + " + tangential + " + " +
                                                rolling + (partner == Partner::wall ? ", wall" : "") +
                                                (ledger ? ", ledger" : ""));
                                cases.push_back({laws, contact::state_layout(laws, ledger), partner});
                            }
        // With the coefficients of which most pairs have none.
        for (auto const& normal : choices("normal"))
            for (auto const& cohesion : choices("cohesion"))
                for (auto const& tangential : choices("tangential"))
                    for (Partner const partner : {Partner::sphere, Partner::wall})
                        for (bool const ledger : {false, true}) {
                            contact::LawSet const laws(
                                grain, grain,
                                properties({normal, cohesion, tangential, "epsd"}, ledger, "elastic", true));
                            names.push_back(normal + " + " + cohesion + " + " + tangential + " + epsd, all" +
                                            (partner == Partner::wall ? ", wall" : "") +
                                            (ledger ? ", ledger" : ""));
                            cases.push_back({laws, contact::state_layout(laws, ledger), partner});
                        }
    }
};

Results evaluate_one_by_one(Scene const& scene, Case const& the_case)
{
    Results results(contacts * moments);
    for (int i = 0; i < contacts; ++i)
        evaluate_all_moments(scene, the_case, i, results.data() + i * moments);
    return results;
}

double const* numbers(Results const& results)
{
    return reinterpret_cast<double const*>(results.data());
}

//! Every number within `tolerance` of the largest of its place in the result, over all contacts and moments.
void expect_equal(Results const& found, Results const& expected, double tolerance)
{
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t c = 0; c < numbers_per_result; ++c) {
        double largest = 0, difference = 0;
        for (std::size_t k = c; k < found.size() * numbers_per_result; k += numbers_per_result) {
            double const a = numbers(found)[k], b = numbers(expected)[k];
            ASSERT_TRUE(std::isfinite(a) && std::isfinite(b)) << "number " << c;
            largest = std::max(largest, std::abs(b));
            difference = std::max(difference, std::abs(a - b));
        }
        EXPECT_LE(difference, tolerance * largest) << "number " << c;
    }
}

//! The functors leave out what the CPU engine adds up over a wall.
void expect_wall_sums(BlockResults const& found, Results const& expected)
{
    for (std::size_t moment = 0; moment < moments; ++moment) {
        BlockResults::WallSum sums[walls] = {};
        for (std::size_t c = 0; c < contacts; ++c) {
            Result const& one = expected[c * moments + moment];
            auto& sum = sums[c < contacts_of_first_wall ? 0 : 1];
            sum.force -= one.force;
            sum.torque += one.torque_j;
        }
        for (std::size_t w = 0; w < walls; ++w) {
            EXPECT_EQ(found.wall_sums[moment * walls + w].force, sums[w].force);
            EXPECT_EQ(found.wall_sums[moment * walls + w].torque, sums[w].torque);
        }
    }
}

TEST(Parity, BlocksAndOneByOne)
{
    Scene const scene = make_scene();
    auto const [names, cases] = Cases();
    for (std::size_t k = 0; k < cases.size(); ++k) {
        SCOPED_TRACE(names[k]);
        BlockResults const found = evaluate_in_blocks(scene, cases[k]);
        Results expected = evaluate_one_by_one(scene, cases[k]);
        if (cases[k].partner == Partner::wall) {
            expect_wall_sums(found, expected);
            for (Result& result : expected)
                result.torque_j = {};
        }
        expect_equal(found.results, expected, 0);
        if (HasFailure())
            return;
    }
}

TEST(Parity, EverySetOfLawsActsInItsOwnWay)
{
    Scene const scene = make_scene();
    auto const [names, cases] = Cases();
    std::map<double, std::string> sums;
    std::size_t sets = 0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        Case const& one = cases[k];
        if (one.layout.ledger || one.partner == Partner::wall)
            continue;
        double sum = 0;
        for (Result const& result : evaluate_one_by_one(scene, one))
            sum += norm(result.force) + 1e3 * norm(result.torque_i);
        auto const [same, is_new] = sums.insert({sum, names[k]});
        EXPECT_TRUE(is_new) << names[k] << " acts as " << same->second;
        ++sets;
    }
    EXPECT_EQ(sets, 2u * 7 * 5 * 5 + 2u * 7 * 5);
}

TEST(Parity, DeviceCompilerOnTheHost)
{
    Scene const scene = make_scene();
    auto const [names, cases] = Cases();
    Results found;
    for (std::size_t k = 0; k < cases.size(); ++k) {
        SCOPED_TRACE(names[k]);
        evaluate_by_device_compiler(scene, cases[k], found);
        expect_equal(found, evaluate_one_by_one(scene, cases[k]), 1e-13);
        if (HasFailure())
            return;
    }
}

TEST(Parity, Device)
{
    if (!device_is_there())
        GTEST_SKIP() << "no CUDA device here: the kernels were compiled only";
    Scene const scene = make_scene();
    auto const [names, cases] = Cases();
    std::vector<Results> found;
    evaluate_on_device(scene, cases, found);
    for (std::size_t k = 0; k < cases.size(); ++k) {
        SCOPED_TRACE(names[k]);
        expect_equal(found[k], evaluate_one_by_one(scene, cases[k]), 1e-11);
        if (HasFailure())
            return;
    }
}

} // namespace
