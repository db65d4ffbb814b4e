// What a model may lack: effects with amplitudes, and experiments that are held out.
#include "ensemble/input/campaign_input.hpp"

#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ensemble::CampaignInput, ensemble::ExperimentRole;
using testing::HasSubstr;

constexpr char const* effects = R"(
[gap]
held_out = ["drop"]
effects = ["wet", "fill"]
form_floor = 0.03
typical = { drum_speed = 0.01, fill_mass = 0.15 }

[[effect]]
name = "wet"
typical = 0.5
sign = "positive"
doc = "water on quartz"
set = [{ path = "contact.quartz_quartz.cohesion", value = "dmt" },
       { path = "contact.quartz_quartz.surface_energy", value = 0 },
       { path = "contact.quartz_quartz.surface_energy", per_unit = 1e-3 },
       { path = "experiment.bench.layers", value = 4 }]

[[effect]]
name = "fill"
set = [{ path = "experiment.mass_kg", relative = 0.1 },
       { path = "contact.quartz_quartz.kinetic_friction", value_of = "contact.quartz_quartz.static_friction" }]
)";

//! The input of a run of the first experiment with these amplitudes.
rig::RunInput run_with(std::vector<double> const& amplitudes)
{
    auto const input = read(good_campaign() + effects);
    return input.run_input({0.5, 0.25, 2e6}, 3, 0, 1, overrides_of(input.effects, amplitudes));
}

TEST(EffectInput, ChangesNumbersAndWordsInProportionToItsAmplitude)
{
    auto const run = run_with({2, -1});
    auto const& pair = run.model.pairs[0];
    EXPECT_EQ(pair.cohesion, contact::CohesionLaw::dmt);
    EXPECT_EQ(pair.surface_energy, 2e-3);
    EXPECT_EQ(run.experiment.integer("layers"), 4);
    EXPECT_DOUBLE_EQ(run.experiment.number("mass_kg"), 25.75 * 0.9);
    EXPECT_EQ(pair.kinetic_friction, 0.5) << "that of the factor static friction, which was set before";
}

TEST(EffectInput, AnAmplitudeOfZeroIsTheBaseModel)
{
    auto const run = run_with({0, 0}), base = run_with({});
    EXPECT_EQ(run.seed, base.seed);
    EXPECT_EQ(run.model.pairs[0].cohesion, contact::CohesionLaw::none);
    EXPECT_EQ(run.model.pairs[0].surface_energy, base.model.pairs[0].surface_energy);
    EXPECT_EQ(run.model.pairs[0].kinetic_friction, 0.25);
    EXPECT_EQ(run.experiment.all(), base.experiment.all());
}

TEST(EffectInput, AValueBeyondItsRangeIsTheRunsFailure)
{
    EXPECT_THROW(run_with({-1, 0}), InputError) << "a negative surface energy";
    EXPECT_THROW(run_with({0, 100}), InputError) << "more than the hopper holds";
}

TEST(EffectInput, ExperimentsThatAreHeldOutKeepTheirTargetsApart)
{
    auto const input = read(good_campaign() + effects);
    EXPECT_EQ(input.experiments[0].role, ExperimentRole::calibrate);
    EXPECT_EQ(input.experiments[0].targets.size(), 2u);
    EXPECT_EQ(input.experiments[1].role, ExperimentRole::hold_out);
    EXPECT_TRUE(input.experiments[1].targets.empty());
    ASSERT_EQ(input.experiments[1].held_out.size(), 1u);
    EXPECT_EQ(input.experiments[1].held_out[0].value, 0.4);
    EXPECT_EQ(input.gap->form_floor, 0.03);
    EXPECT_EQ(input.gap->typical, (std::map<std::string, double>{{"drum_speed", 0.01}, {"fill_mass", 0.15}}));
    EXPECT_EQ(input.gap->packings, ensemble::GapOptions{}.packings);
}

TEST(EffectInput, OnlyExperimentsToBeConsideredMayHaveNoValue)
{
    auto const unmeasured =
        replaced(good_campaign(), "target.rebound = { value = 0.4, ", "target.rebound = { ");
    EXPECT_THAT(message_about(unmeasured),
                HasSubstr("experiment.drop.target.rebound: the key \"value\" is missing"));
    EXPECT_THAT(message_about(unmeasured + effects), HasSubstr("the key \"value\" is missing"));
    auto const input = read(unmeasured + replaced(effects, "held_out", "candidates"));
    EXPECT_EQ(input.experiments[1].role, ExperimentRole::consider);
    EXPECT_TRUE(std::isnan(input.experiments[1].held_out.at(0).value));
    EXPECT_EQ(CampaignInput::from_text(input.resolved_text(), "resolved", rigs()).resolved_text(),
              input.resolved_text());
}

TEST(EffectInput, IsWrittenOutAndReadAgain)
{
    auto const input = read(good_campaign() + effects);
    auto const again = CampaignInput::from_text(input.resolved_text(), "resolved", rigs());
    EXPECT_EQ(again.resolved_text(), input.resolved_text());
    EXPECT_EQ(toml_text(again.effects), toml_text(input.effects));
    EXPECT_EQ(again.experiments[1].held_out.size(), 1u);
    EXPECT_EQ(toml_text(input.effects_of(toml_text(input.effects), "a wave")), toml_text(input.effects));
    EXPECT_EQ(input.effects[0].doc, "water on quartz");
}

TEST(EffectInput, WhatIsWrongIsToldWithItsPlace)
{
    auto const with = [](std::string const& part, std::string const& by) {
        return good_campaign() + replaced(effects, part, by);
    };
    EXPECT_THAT(message_about(with("surface_energy\", per", "surface_enrgy\", per")),
                HasSubstr("effect.wet.set[3].path = \"contact.quartz_quartz.surface_enrgy\": names nothing"));
    EXPECT_THAT(message_about(with("value = \"dmt\"", "value = \"glue\"")),
                HasSubstr("must be one of none, "));
    EXPECT_THAT(message_about(with("value = \"dmt\"", "per_unit = 1.0")), HasSubstr("is no number"));
    EXPECT_THAT(message_about(with("relative = 0.1", "relative = 0.1, per_unit = 1.0")),
                HasSubstr("needs one of"));
    EXPECT_THAT(message_about(with("name = \"fill\"", "name = \"wet\"")),
                HasSubstr("two effects have this name"));
    EXPECT_THAT(
        message_about(with("held_out = [\"drop\"]", "held_out = [\"drip\"]")),
        HasSubstr("gap.held_out = [ 'drip' ]: there is no experiment \"drip\"; did you mean \"drop\"?"));
    EXPECT_THAT(message_about(with("held_out = [\"drop\"]", "held_out = [\"drop\", \"bench\"]")),
                HasSubstr("none is left to calibrate on"));
    EXPECT_THAT(message_about(with("fill_mass = 0.15", "fill_mass = 0")),
                HasSubstr("gap.typical.fill_mass = 0: "));
    EXPECT_THAT(message_about(with("fill_mass = 0.15", "fill_mass = \"much\"")),
                HasSubstr("must be a number"));
    EXPECT_THAT(message_about(good_campaign() + "\n[[effect]]\nname = \"a\"\n"),
                HasSubstr("\"set\" is missing"));
    std::string const set = "set = [{ path = \"experiment.mass_kg\", per_unit = 1.0 }]\n";
    EXPECT_THAT(message_about(good_campaign() + "\n[[effect]]\nname = \"a\"\n" + set +
                              "\n[[effect]]\nname = \"b\"\n" + set),
                HasSubstr("the same as that of the effect a"));
}

} // namespace
} // namespace demens::test
