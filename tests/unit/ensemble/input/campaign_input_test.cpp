#include "ensemble/input/campaign_input.hpp"

#include "tests/support/fault_of.hpp"
#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ensemble::CampaignInput;
using testing::HasSubstr;

TEST(CampaignInput, HoldsWhatTheAuthorWrote)
{
    auto const input = read(good_campaign());
    EXPECT_EQ(input.name, "test");
    EXPECT_EQ(input.seed, 7u);
    EXPECT_EQ(input.text(), good_campaign());

    ASSERT_EQ(input.experiments.size(), 2u);
    auto const& bench = input.experiments[0];
    EXPECT_EQ(bench.name, "bench");
    EXPECT_EQ(bench.rig, &rigs()[0]);
    EXPECT_EQ(bench.replicates, 2);
    ASSERT_EQ(bench.targets.size(), 2u);
    EXPECT_EQ(bench.targets[0].response, "angle_deg");
    EXPECT_EQ(bench.targets[0].sd, 0.8);
    EXPECT_EQ(bench.targets[0].tolerance, 1.0);
    EXPECT_EQ(bench.targets[1].response_index, 1);
    EXPECT_EQ(bench.targets[1].value, 4.83);
    EXPECT_TRUE(std::isnan(bench.targets[1].sd));
    EXPECT_TRUE(std::isnan(bench.targets[1].tolerance));

    ASSERT_EQ(input.factors.size(), 3u);
    EXPECT_EQ(input.factors[0].name, "static_friction");
    EXPECT_EQ(input.factors[1].name, "mu_k");
    EXPECT_EQ(input.factors[2].upper, 1e8);
    EXPECT_TRUE(input.factors[2].log_scale);
    ASSERT_EQ(input.constraints.size(), 1u);
    EXPECT_EQ(input.constraints[0].coefficients, (std::vector<double>{-1, 1, 0}));
    EXPECT_EQ(input.constraints[0].bound, 0);

    EXPECT_EQ(input.design.points, 12);
    EXPECT_EQ(input.solver.starts, 10);
    EXPECT_EQ(input.stop.wmse, 0.05);
    EXPECT_FALSE(input.stop.within_tolerance);
    EXPECT_EQ(input.stop.confirmation, 2);
    EXPECT_EQ(input.run.run_wall_time_s, 180);
}

TEST(CampaignInput, NamesAnEngine)
{
    EXPECT_EQ(read(good_campaign()).run.engine, rig::EngineChoice::cpu);
    auto const with = [](std::string const& engine, int ranks) {
        return replaced(good_campaign(), "ranks_per_group = 1",
                        fmt::format("engine = \"{}\"\nranks_per_group = {}", engine, ranks));
    };
    EXPECT_EQ(read(with("auto", 2)).run.engine, rig::EngineChoice::automatic);
    auto const refusal = [&](std::string const& text) -> std::string {
        try {
            read(text);
        } catch (InputError const& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_THAT(refusal(with("cuda", 2)), HasSubstr("run.engine = \"cuda\": a device has a run to itself"));
    EXPECT_THAT(refusal(with("gpu", 1)), HasSubstr("must be one of cpu, cuda, "));
}

TEST(CampaignInput, SharesARunAmongAsManyRanksAsPay)
{
    std::ifstream file(DEMENS_SOURCE_DIR "/inputs/heap/campaign.toml");
    std::string const heap(std::istreambuf_iterator<char>(file), {});
    auto const ranks = [](std::string const& text) {
        return CampaignInput::from_text(text, "heap.toml").run.ranks_per_group;
    };
    EXPECT_EQ(ranks(heap), 1); // by default
    auto const open = heap + "\n[run]\nranks_per_group = 0\n";
    EXPECT_EQ(ranks(open), 1); // 2,800 grains
    auto const large = replaced(open, "mass_kg = 0.03\nradius_mm = 15", "mass_kg = 0.35\nradius_mm = 45");
    EXPECT_EQ(ranks(large), 3); // 33,000 grains
    EXPECT_EQ(ranks(replaced(large, "[run]", "[run]\nengine = \"auto\"")), 1);
}

TEST(CampaignInput, AbsentKeysHaveTheirDefaults)
{
    auto const input = read(replaced(good_campaign(), "wmse = 0.05\nwithin_tolerance = false\n", ""));
    EXPECT_EQ(input.stop.wmse, ensemble::StopOptions{}.wmse);
    EXPECT_TRUE(input.stop.within_tolerance);
}

TEST(CampaignInput, ARunHasTheModelAndItsFactors)
{
    auto const run = read(good_campaign()).run_input({0.5, 0.25, 2e6}, 3, 0, 1);
    ASSERT_EQ(run.model.materials.size(), 2u);
    EXPECT_EQ(run.model.materials[0].name, "quartz");
    EXPECT_EQ(run.model.materials[0].youngs_modulus, 2e6);
    EXPECT_EQ(run.model.materials[1].youngs_modulus, 1e7);
    ASSERT_EQ(run.model.pairs.size(), 2u);
    EXPECT_EQ(run.model.pairs[0].static_friction, 0.5);
    EXPECT_EQ(run.model.pairs[0].kinetic_friction, 0.25);
    EXPECT_EQ(run.model.pairs[0].normal, contact::NormalLaw::hysteretic_spring);
    EXPECT_EQ(run.model.pairs[1].first, "wood_dry");
    EXPECT_EQ(run.model.pairs[1].second, "quartz");
    EXPECT_FALSE(run.model.pairs[1].allow_attraction);
    EXPECT_EQ(run.size_distributions.at("half_inch").largest(), 0.0254);
    EXPECT_EQ(run.size_distributions.at("two").fractions(), (std::vector<double>{0, 0.25, 0.25, 1}));
    EXPECT_EQ(run.experiment.number("mass_kg"), 25.75);
    EXPECT_EQ(run.experiment.integer("layers"), 3);
    EXPECT_TRUE(run.experiment.flag("periodic"));
    EXPECT_FALSE(run.experiment.has("replicates"));
}

TEST(CampaignInput, SeedsDifferInPointExperimentAndReplicate)
{
    auto const input = read(good_campaign());
    auto const seed = input.run_seed(3, 0, 1);
    EXPECT_EQ(input.run_input({0.5, 0.25, 2e6}, 3, 0, 1).seed, seed);
    EXPECT_NE(seed, input.run_seed(4, 0, 1));
    EXPECT_NE(seed, input.run_seed(3, 1, 1));
    EXPECT_NE(seed, input.run_seed(3, 0, 0));
    EXPECT_NE(seed, input.run_seed(3, 1, 0));
    EXPECT_NE(seed, read(replaced(good_campaign(), "seed = 7", "seed = 8")).run_seed(3, 0, 1));
}

TEST(CampaignInput, KineticFrictionFollowsTheStaticOneUnlessGiven)
{
    auto text = replaced(good_campaign(), "path = \"contact.quartz_quartz.static_friction\"",
                         "path = \"contact.quartz_wood_dry.static_friction\"");
    text = replaced(text, "[[constraint]]\nexpression = \"mu_k <= static_friction\"\n", "");
    text = replaced(text, "lower = 0.1\nupper = 1.2\n\n[[factor]]\npath = \"material",
                    "lower = 0.1\nupper = 0.9\n\n[[factor]]\npath = \"material");
    auto const input = read(text);
    EXPECT_EQ(input.factors[0].path, "contact.wood_dry_quartz.static_friction");
    auto const run = input.run_input({0.45, 0.2, 1e7}, 0, 0, 0);
    EXPECT_EQ(run.model.pairs[1].static_friction, 0.45);
    EXPECT_EQ(run.model.pairs[1].kinetic_friction, 0.45);
    EXPECT_EQ(run.model.pairs[0].kinetic_friction, 0.2);
    EXPECT_NE(input.resolved_text().find("kinetic_friction = -1.0"), std::string::npos);
}

TEST(CampaignInput, APathWithoutAnExperimentSetsAllThatHaveTheKey)
{
    auto const text =
        replaced(good_campaign(), "path = \"material.quartz.youngs_modulus\"\nlower = 1e6\nupper = 1e8",
                 "path = \"experiment.mass_kg\"\nlower = 10\nupper = 30");
    auto const input = read(text);
    EXPECT_EQ(input.run_input({0.5, 0.5, 12.5}, 0, 0, 0).experiment.number("mass_kg"), 12.5);
    EXPECT_EQ(input.run_input({0.5, 0.5, 12.5}, 0, 1, 0).experiment.number("speed_m_s"), 2.5);
    auto const of_one = read(replaced(text, "experiment.mass_kg", "experiment.bench.mass_kg"));
    EXPECT_EQ(of_one.run_input({0.5, 0.5, 12.5}, 0, 0, 0).experiment.number("mass_kg"), 12.5);
}

TEST(CampaignInput, ARunThatTheRigRefusesIsAnError)
{
    auto const input =
        read(replaced(good_campaign(), "path = \"material.quartz.youngs_modulus\"\nlower = 1e6\nupper = 1e8",
                      "path = \"experiment.mass_kg\"\nlower = 10\nupper = 30"));
    EXPECT_THROW(input.run_input({0.5, 0.5, 101}, 0, 0, 0), InputError);
    EXPECT_THROW(input.run_input({0.5, 0.6, 12}, 0, 0, 0), InputError) << "kinetic above static friction";
}

TEST(CampaignInput, FactorsWithTheSameKeyHaveDistinctNames)
{
    auto text =
        replaced(good_campaign(), "path = \"material.quartz.youngs_modulus\"\nlower = 1e6\nupper = 1e8",
                 "path = \"contact.quartz_wood_dry.static_friction\"\nlower = 0.1\nupper = 1");
    text = replaced(text, "mu_k <= static_friction", "mu_k <= quartz_quartz_static_friction");
    auto const input = ensemble::CampaignInput::from_text(text, "test.toml", rigs());
    EXPECT_EQ(input.factors[0].name, "quartz_quartz_static_friction");
    EXPECT_EQ(input.factors[2].name, "quartz_wood_dry_static_friction");
}

TEST(CampaignInput, LevelsBoundAFactor)
{
    auto const input = read(replaced(good_campaign(), "name = \"mu_k\"\nlower = 0.1\nupper = 1.2",
                                     "name = \"mu_k\"\nlevels = [0.2, 0.4, 0.8]"));
    EXPECT_EQ(input.factors[1].levels, (std::vector<double>{0.2, 0.4, 0.8}));
    EXPECT_EQ(input.factors[1].lower, 0.2);
    EXPECT_EQ(input.factors[1].upper, 0.8);
    EXPECT_EQ(read(input.resolved_text()).factors[1].levels, input.factors[1].levels);
}

TEST(CampaignInput, ADesignTableIsReadRowByRow)
{
    auto const input = read(replaced(good_campaign(), "kind = \"latin_hypercube\"\npoints = 12",
                                     "kind = \"table\"\ntable = [[0.5, 0.4, 1e7], [1, 1, 1e6]]"));
    EXPECT_EQ(input.design.table, (std::vector<std::vector<double>>{{0.5, 0.4, 1e7}, {1, 1, 1e6}}));
    EXPECT_EQ(read(input.resolved_text()).design.table, input.design.table);
}

//! Of the good campaign.
std::vector<std::string> good_factor_names()
{
    std::vector<std::string> names;
    for (auto const& factor : read(good_campaign()).factors)
        names.push_back(factor.name);
    return names;
}

//! The good campaign with its design in a CSV file of that content.
CampaignInput with_design_file(std::string const& csv)
{
    return CampaignInput::from_text(replaced(good_campaign(), "kind = \"latin_hypercube\"\npoints = 12",
                                             "kind = \"table\"\ntable_file = \"points.csv\""),
                                    "test.toml", rigs(), [&](std::string const&) { return csv; });
}

std::string refusal_of_design_file(std::string const& csv)
{
    return test::fault_of([&] { with_design_file(csv); });
}

TEST(CampaignInput, ADesignTableIsReadFromAFileInAnyDialect)
{
    auto const names = good_factor_names();
    auto const header = names[0] + ";" + names[1] + ";operator;" + names[2] + "\r\n";
    auto const input = with_design_file("\xEF\xBB\xBF" + header + "0,5;0,4;Ann;+1e7\r\n1;1;Bob;1e6\r\n");
    EXPECT_EQ(input.design.table, (std::vector<std::vector<double>>{{0.5, 0.4, 1e7}, {1, 1, 1e6}}));
    ASSERT_EQ(input.warnings().size(), 1u);
    EXPECT_EQ(input.warnings()[0],
              "design.table_file: points.csv: `operator` names no factor and is not used");
    EXPECT_EQ(input.files().count("points.csv"), 1u);
    EXPECT_EQ(read(input.resolved_text()).design.table, input.design.table);
}

TEST(CampaignInput, ADesignFileIsRefusedByRowAndColumn)
{
    using ::testing::AllOf;
    using ::testing::HasSubstr;
    auto const names = good_factor_names();
    auto const header = names[0] + "," + names[1] + "," + names[2] + "\n";
    EXPECT_THAT(
        refusal_of_design_file(header + "0.5,0.4,1e7\n0.5,,1e7\n"),
        AllOf(HasSubstr("design.table_file"), HasSubstr("points.csv:3: column `" + names[1] + "` has no")));
    EXPECT_THAT(refusal_of_design_file(header + "0.5,x,1e7\n"), HasSubstr("points.csv:2"));
    EXPECT_THAT(
        refusal_of_design_file(header + "0.5,77,1e7\n"),
        HasSubstr("points.csv:2: row 1 (0.5, 77, 10000000): " + names[1] + " = 77 is outside its bounds"));
    EXPECT_THAT(refusal_of_design_file(header), HasSubstr("holds no rows"));
    EXPECT_THAT(refusal_of_design_file(names[0] + "," + names[1] + "\n0.5,0.4\n"),
                HasSubstr("has no column `" + names[2] + "`"));
}

TEST(ResolvedText, ReadAgainGivesTheSameCampaign)
{
    auto const input = read(good_campaign());
    auto const again = read(input.resolved_text());
    EXPECT_EQ(again.resolved_text(), input.resolved_text());
    EXPECT_EQ(again.run_seed(5, 1, 0), input.run_seed(5, 1, 0));
    auto const run = input.run_input({0.5, 0.25, 2e6}, 3, 1, 0);
    auto const run_again = again.run_input({0.5, 0.25, 2e6}, 3, 1, 0);
    EXPECT_EQ(run.experiment.all(), run_again.experiment.all());
    for (std::size_t pair = 0; pair < run.model.pairs.size(); ++pair) {
        EXPECT_EQ(run.model.pairs[pair].first, run_again.model.pairs[pair].first);
        EXPECT_EQ(run.model.pairs[pair].restitution, run_again.model.pairs[pair].restitution);
        EXPECT_EQ(run.model.pairs[pair].kinetic_friction, run_again.model.pairs[pair].kinetic_friction);
    }
    EXPECT_EQ(run.size_distributions.at("half_inch").diameters(),
              run_again.size_distributions.at("half_inch").diameters());
    EXPECT_EQ(again.factors[2].log_scale, true);
    EXPECT_EQ(again.constraints[0].coefficients, input.constraints[0].coefficients);
}

TEST(ResolvedText, KeepsEveryDigitAndEveryLetter)
{
    auto text = replaced(good_campaign(), "density = 2604.1", "density = 2604.1000000000004");
    text = replaced(text, "name = \"test\"", "name = \"a \\\"b\\\" \\\\ c\\nd\"");
    auto const again = read(read(text).resolved_text());
    EXPECT_EQ(again.name, "a \"b\" \\ c\nd");
    EXPECT_EQ(again.run_input({0.5, 0.25, 2e6}, 0, 0, 0).model.materials[0].density, 2604.1000000000004);
}

TEST(ResolvedText, WritesOutDefaults)
{
    auto const text = read(good_campaign()).resolved_text();
    EXPECT_NE(text.find("\ntangential_stiffness_ratio = 1.0 # "), std::string::npos);
    EXPECT_NE(text.find("\nyoungs_modulus = 10000000.0 # Young's modulus [Pa]"), std::string::npos);
}

} // namespace
} // namespace demens::test
