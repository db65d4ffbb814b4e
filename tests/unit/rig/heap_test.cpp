#include "demens/base/error.hpp"
#include "demens/rig/programme/programme.hpp"
#include "demens/rig/rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace {

using namespace demens;

//! Some 500 soft spheres of 2 mm in a cylinder of 10 mm.
rig::RunInput small_heap(double friction = 0.6, double rolling = 0.2)
{
    rig::RunInput input;
    input.model.materials = {{"grain", 2500, 1e6, 0.3}, {"steel", 7850, 1e6, 0.3}};
    for (auto const* other : {"grain", "steel"}) {
        contact::PairProperties pair{
            .first = "grain", .second = other, .rolling = contact::RollingLaw::epsd2};
        pair.restitution = 0.3;
        pair.static_friction = pair.kinetic_friction = friction;
        pair.rolling_friction = rolling;
        input.model.pairs.push_back(pair);
    }
    input.size_distributions.emplace("narrow", shape::SizeDistribution({1.9e-3, 2.1e-3}, {0, 1}));
    auto& options = input.experiment;
    options = defaults_of(rig::find_rig("heap")->options);
    options.set("material", std::string("grain"));
    options.set("wall_material", std::string("steel"));
    options.set("size_distribution", std::string("narrow"));
    options.set("mass_kg", 5e-3);
    options.set("radius_mm", 10.0);
    options.set("lift_speed_m_s", 0.05);
    input.seed = 1;
    return input;
}

rig::RunInput funnel()
{
    auto input = small_heap();
    input.experiment.set("feed", std::string("fixed_funnel"));
    input.experiment.set("outlet_radius_mm", 6.0);
    input.experiment.set("outlet_height_mm", 25.0);
    return input;
}

rig::RunResult run(rig::RunInput const& input)
{
    auto const& heap = *rig::find_rig("heap");
    heap.check(input);
    return heap.run(input, {});
}

std::map<std::string, double> responses(rig::RunResult const& result)
{
    EXPECT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    std::map<std::string, double> named;
    for (std::size_t k = 0; k < result.responses.size(); ++k)
        named[rig::find_rig("heap")->responses.at(k).name] = result.responses[k];
    return named;
}

std::string refusal(rig::RunInput input, std::string const& key, double value)
{
    input.experiment.set(key, value);
    try {
        rig::find_rig("heap")->check(input);
    } catch (InputError const& error) {
        return error.what();
    }
    return "";
}

TEST(Heap, IsWhatTheLiftedCylinderLeaves)
{
    auto const result = run(small_heap());
    auto const named = responses(result);
    double const angle = named.at("angle_of_repose_deg");
    EXPECT_GT(angle, 10);
    EXPECT_LT(angle, 45);
    EXPECT_NEAR(named.at("mass_on_plate_kg"), 5e-3, 5e-5); // nothing is lost on a plate without an edge
    // Height and radius of a cone of that angle; the tip is rounded and a layer of grains lies around it.
    EXPECT_NEAR(named.at("height_mm"), named.at("radius_mm") * std::tan(angle * std::numbers::pi / 180), 2.5);
    ASSERT_EQ(result.profiles.size(), 1u);
    auto const& z = result.profiles[0].curve.columns[1];
    EXPECT_GT(z.front(), 0.6e-3 * named.at("height_mm"));
    EXPECT_LT(z.back(), 1e-3);
    // The cylinder was emptied: the heap grew wider as it was lifted.
    auto const& radius = result.series.column("radius_mm");
    EXPECT_GT(radius.back(), 12);
    EXPECT_EQ(result.series.column("angle_of_repose_deg").back(), angle);
}

// One heap of 500 grains is crooked: left less right scatters by 5 degrees from one to the next.
TEST(Heap, LeansToNoSideInTheMean)
{
    constexpr int heaps = 8;
    double left = 0, right = 0, angle = 0;
    auto input = small_heap();
    for (int seed = 1; seed <= heaps; ++seed) {
        input.seed = static_cast<std::uint64_t>(seed);
        auto const named = responses(run(input));
        left += named.at("left_angle_deg") / heaps;
        right += named.at("right_angle_deg") / heaps;
        angle += named.at("angle_of_repose_deg") / heaps;
    }
    EXPECT_NEAR(left, right, 3 * 5 / std::sqrt(heaps));
    EXPECT_NEAR(0.5 * (left + right), angle, 5); // of the sides of its shadow, and of all around it
}

TEST(Heap, IsFlatterWithoutFriction)
{
    auto const rough = responses(run(small_heap())), smooth = responses(run(small_heap(0.1, 0.01)));
    EXPECT_LT(smooth.at("angle_of_repose_deg"), rough.at("angle_of_repose_deg") - 4);
    EXPECT_LT(smooth.at("height_mm"), rough.at("height_mm"));
}

TEST(Heap, OfAFunnelIsFlatterTheHigherItStands)
{
    auto input = funnel();
    auto const low = responses(run(input));
    EXPECT_NEAR(low.at("mass_on_plate_kg"), 5e-3, 5e-5);
    EXPECT_GT(low.at("angle_of_repose_deg"), 8);
    input.experiment.set("outlet_height_mm", 80.0); // the stream digs into the heap and throws grains off
    auto const high = responses(run(input));
    EXPECT_LT(high.at("angle_of_repose_deg"), low.at("angle_of_repose_deg") - 1);
    EXPECT_LT(high.at("height_mm"), low.at("height_mm"));
}

TEST(Heap, WhatFallsOffAPlateIsNotOnIt)
{
    auto input = funnel();
    input.experiment.set("plate_radius_mm", 12.0);
    auto const bare = responses(run(input));
    EXPECT_LT(bare.at("mass_on_plate_kg"), 4.5e-3);
    input.experiment.set("lip_mm", 4.0);
    EXPECT_GT(responses(run(input)).at("mass_on_plate_kg"), bare.at("mass_on_plate_kg"));
}

TEST(Heap, AnOutletThatIsBlockedIsAFailedRun)
{
    auto input = funnel();
    input.experiment.set("outlet_radius_mm", 2.0);
    auto const result = run(input);
    EXPECT_EQ(result.status, rig::RunStatus::timed_out);
    EXPECT_NE(result.reason.find("an arch blocks the outlet"), std::string::npos) << result.reason;
}

TEST(Heap, RefusesWhatCannotBeRun)
{
    EXPECT_EQ(refusal(small_heap(), "mass_kg", 5e-3), "");
    EXPECT_NE(refusal(small_heap(), "radius_mm", 1).find("radius_mm"), std::string::npos);
    EXPECT_NE(refusal(small_heap(), "plate_radius_mm", 5).find("must be at least radius_mm"),
              std::string::npos);
    EXPECT_NE(refusal(small_heap(), "lip_mm", 2).find("is a plate without one"), std::string::npos);
    EXPECT_NE(refusal(small_heap(), "toe_share", 0.65).find("leave less than a fifth"), std::string::npos);
    EXPECT_NE(refusal(funnel(), "outlet_radius_mm", 10).find("must be smaller than radius_mm"),
              std::string::npos);
    EXPECT_NE(refusal(funnel(), "outlet_height_mm", 5).find("may reach the funnel"), std::string::npos);
}

} // namespace
