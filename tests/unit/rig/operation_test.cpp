// How a rig is operated: it leans, it shakes, a gas fills it. Keys that all rigs have.
#include "demens/base/error.hpp"
#include "demens/rig/programme/programme.hpp"
#include "src/rig/common.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/support/small_drawdown.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace demens;
using demens::test::small_drawdown;

constexpr double degree = std::numbers::pi / 180;

dem::SimulationOptions built(rig::RunInput const& input)
{
    return rig::find_rig("drawdown")->describe(input).build().options;
}

std::string refusal(rig::RunInput const& input)
{
    return test::fault_of([&] { rig::find_rig("drawdown")->check(input); });
}

TEST(Operation, ARigLeansInAnyDirectionAndKeepsTheStrengthOfGravity)
{
    for (double const x : {-7.0, 0.0, 3.0})
        for (double const y : {-5.0, 0.0, 2.0}) {
            auto input = small_drawdown(1);
            input.experiment.set("lean_x_deg", x);
            input.experiment.set("lean_y_deg", y);
            EXPECT_EQ(refusal(input), "");
            Vector3 const g = built(input).gravity;
            EXPECT_NEAR(norm(g), 9.81, 1e-12);
            EXPECT_NEAR(g.x, 9.81 * std::sin(x * degree), 1e-12);
            EXPECT_NEAR(g.y, 9.81 * std::cos(x * degree) * std::sin(y * degree), 1e-12);
            EXPECT_LT(g.z, -9.6);
        }
    EXPECT_EQ(built(small_drawdown(1)).gravity, (Vector3{0, 0, -9.81})); // without rounding
}

TEST(Operation, EveryRigHasTheKeysAndNothingOfThemByDefault)
{
    for (auto const& rig : rig::all_rigs()) {
        if (!rig.describe)
            continue; // another program's simulations
        auto const options = defaults_of(rig.options);
        for (auto const* key : {"lean_x_deg", "lean_y_deg", "gas_viscosity_Pa_s", "gas_density_kg_m3"})
            EXPECT_EQ(options.number(key), 0) << rig.name << " " << key;
        EXPECT_EQ(norm(options.vector("vibration_m_s2")), 0) << rig.name;
    }
    EXPECT_FALSE(built(small_drawdown(1)).surroundings.is_any());
}

TEST(Operation, SizesScaleAndGetATailOrStayBitForBit)
{
    auto input = small_drawdown(1);
    auto const sizes = rig::size_distribution_of(input);
    EXPECT_EQ(sizes.diameters(), input.size_distributions.at("gravel").diameters());
    EXPECT_EQ(sizes.fractions(), input.size_distributions.at("gravel").fractions());
    input.experiment.set("tail_mm", 8.0); // no share: none
    EXPECT_EQ(rig::size_distribution_of(input).diameters(), sizes.diameters());
    input.experiment.set("tail_mass_fraction", 0.1);
    input.experiment.set("size_factor", 0.5);
    auto const changed = rig::size_distribution_of(input);
    EXPECT_EQ(changed.diameters(), (std::vector{0.008, 0.008, 0.008, 0.012}));
    EXPECT_NEAR(changed.quantile(0.05), 0.008, 1e-12);
    EXPECT_NEAR(changed.quantile(0.55), 0.010, 1e-12);
    input.experiment.set("tail_mm", 0.0);
    EXPECT_NE(refusal(input).find("tail_mm"), std::string::npos) << refusal(input);
}

TEST(Operation, ABedMayRestBeforeWhatIsMeasured)
{
    auto const stages_with = [](double rest) {
        auto input = small_drawdown(1);
        input.experiment.set("rest_s", rest);
        return rig::find_rig("drawdown")->describe(input).stages;
    };
    auto const without = stages_with(0), with = stages_with(0.25);
    ASSERT_EQ(with.size(), without.size() + 1);
    auto const rest = std::find_if(with.begin(), with.end(), [](auto const& s) { return s.name == "rest"; });
    ASSERT_NE(rest, with.end());
    EXPECT_EQ(rest->shortest, 0.25);
    EXPECT_EQ((rest + 1)->name, "open");
    auto input = small_drawdown(1);
    auto const at_once = rig::find_rig("drawdown")->run(input, {});
    input.experiment.set("rest_s", 0.25);
    auto const later = rig::find_rig("drawdown")->run(input, {});
    ASSERT_EQ(later.status, rig::RunStatus::finished) << later.reason;
    EXPECT_NEAR(later.responses[4], at_once.responses[4], 1e-9); // the bed is what it was
}

TEST(Operation, GasAndVibrationReachTheSimulation)
{
    auto input = small_drawdown(1);
    input.experiment.set("gas_viscosity_Pa_s", 1.8e-5);
    input.experiment.set("gas_density_kg_m3", 1.2);
    input.experiment.set("vibration_m_s2", Vector3{0, 0, 2});
    input.experiment.set("vibration_hz", 80.0);
    dem::Surroundings const expected{
        .viscosity = 1.8e-5, .density = 1.2, .vibration = {0, 0, 2}, .frequency = 80};
    EXPECT_EQ(built(input).surroundings, expected);
    input.engine = rig::EngineChoice::cuda_on_host;
    auto const result = rig::find_rig("drawdown")->run(input, {});
    EXPECT_EQ(result.status, rig::RunStatus::finished) << result.reason; // devices know both
}

TEST(Operation, AVibrationThatTheTimeStepCannotFollowIsRefused)
{
    auto input = small_drawdown(1);
    input.experiment.set("vibration_hz", 1e6);
    EXPECT_EQ(refusal(input), ""); // nothing shakes
    input.experiment.set("vibration_m_s2", Vector3{1, 0, 0});
    EXPECT_NE(refusal(input).find("vibration_hz = 1e+06 is too fast"), std::string::npos) << refusal(input);
}

} // namespace
