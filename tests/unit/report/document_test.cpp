#include "report/document.hpp"

#include "demens/base/error.hpp"
#include "report/page.hpp"
#include "report/picture.hpp"
#include "tests/unit/report/sample_campaign.hpp"

#include <gtest/gtest.h>

namespace demens::report {

using nlohmann::json;

namespace {

json sample_document()
{
    return document_of(test::sample_campaign(), test::sample_details);
}

} // namespace

TEST(Document, holds_every_run_with_its_status_and_reason)
{
    auto const document = sample_document();
    ASSERT_EQ(document["waves"].size(), 2u);
    EXPECT_EQ(document["waves"][0]["runs"].size(), 16u);
    EXPECT_EQ(document["waves"][1]["runs"].size(), 8u);
    auto const& failed = document["waves"][0]["runs"][5];
    EXPECT_EQ(failed["status"], rig::name_of(rig::RunStatus::escaped));
    EXPECT_EQ(failed["outcome"], "failed");
    EXPECT_EQ(failed["reason"], "3 particles left the domain at 0.2 s, the first near (0.1, 0, -1) m <b>");
    EXPECT_DOUBLE_EQ(document["waves"][1]["runs"][0]["responses"][0], 20 + 12 * 0.6 + 8 * 0.25);
}

TEST(Document, lists_targets_in_the_order_of_the_calibration)
{
    auto const targets = sample_document()["targets"];
    ASSERT_EQ(targets.size(), 3u);
    EXPECT_EQ(targets[1]["experiment"], 0);
    EXPECT_EQ(targets[1]["response"], 1);
    EXPECT_EQ(targets[2]["experiment"], 1);
    EXPECT_DOUBLE_EQ(targets[2]["value"], 28.0);
}

TEST(Document, nests_the_arrays_of_the_calibration)
{
    auto const document = sample_document();
    EXPECT_DOUBLE_EQ(document["optimum"]["wmse"], 0.031);
    EXPECT_DOUBLE_EQ(document["optimum"]["interval"][1][1], 0.5);
    EXPECT_DOUBLE_EQ(document["optimum"]["correlation"][1][0], -0.82);
    auto const& surrogate = document["surrogate"];
    EXPECT_DOUBLE_EQ(surrogate["slice_values"][2][40], 1000.0);
    // Target 1 (mass flow) along factor 0 at its lower bound: 7 - 2.5 * 0.1.
    EXPECT_DOUBLE_EQ(surrogate["slices"][1][0][0], 6.75);
}

TEST(Document, states_no_interval_that_no_run_supports)
{
    // Also where an earlier program stored one: null, and the reason in words.
    auto campaign = test::sample_campaign();
    for (auto& array : campaign.waves.back().analysis)
        if (array.path == "optimum/factor_verdict")
            array.data = {5, 1, 7};
    auto const optimum = nlohmann::json::parse(document_of(campaign, test::sample_details).dump())["optimum"];
    EXPECT_TRUE(optimum["interval"][0][0].is_null() && optimum["interval"][0][1].is_null());
    EXPECT_TRUE(optimum["estimate"][0].is_null() && optimum["standard_error"][0].is_null());
    EXPECT_TRUE(optimum["spread"][0].is_null() && optimum["interval"][2][0].is_null());
    EXPECT_EQ(optimum["verdict_text"][0], "not determined: extrapolated to where runs fail");
    EXPECT_EQ(optimum["verdict_text"][2], "not determined: extrapolated beyond all runs");
    EXPECT_DOUBLE_EQ(optimum["interval"][1][1], 0.5);
    EXPECT_DOUBLE_EQ(optimum["estimate"][1], 0.241);
}

TEST(Document, holds_where_targets_are_met_and_what_trades_off)
{
    auto const document = sample_document();
    auto const& findings = document["findings"];
    EXPECT_EQ(findings["by_tolerance"], true);
    EXPECT_EQ(findings["part_shares"].size(), 2u);
    EXPECT_DOUBLE_EQ(findings["part_upper"][0][1], 0.4);
    EXPECT_EQ(findings["separated_by"][0][1], 2); // porosity, which is simulated and no target
    EXPECT_DOUBLE_EQ(document["optimum"]["out_of_reach"][2], -0.4);
    EXPECT_DOUBLE_EQ(document["screening"]["p_values"][1][2], 0.8);
    EXPECT_DOUBLE_EQ(document["screening"]["fixed_value"][2], 30);
    EXPECT_TRUE(document_of(test::campaign_under_way(), test::sample_details)["findings"].is_null());
}

// What `new` warned of stays in sight: 13 g of spheres, half of which are of 10.47 g each.
TEST(Document, repeats_the_warnings_of_the_input)
{
    ensemble::Campaign campaign;
    campaign.input = ensemble::CampaignInput::from_text(R"(
[campaign]
name = "sizes"
[material.m]
density = 2500
youngs_modulus = 1e7
[contact.m_m]
restitution = 0.5
static_friction = 0.3
[size_distribution.d]
classes_mm = [2, 20]
mass_fraction = [0.5, 0.5]
[[experiment]]
name = "e"
rig = "custom"
gravity_m_s2 = [0, 0, 0]
[[experiment.region]]
name = "room"
shape = "box"
lower_mm = [0, 0, 0]
upper_mm = [60, 60, 200]
[[experiment.particles]]
name = "p"
source = "packing"
material = "m"
region = "room"
size_distribution = "d"
mass_kg = 0.013
[[experiment.stage]]
name = "t"
duration_s = 1e-5
[[experiment.response]]
name = "mass"
quantity = "mass"
[[factor]]
path = "contact.m_m.static_friction"
levels = [0.3, 0.5]
[design]
kind = "table"
table = [[0.3]]
[stop]
waves = 0
confirmation = 0
)",
                                                        "sizes.toml");
    auto const warnings = document_of(campaign, test::sample_details)["warnings"];
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(
        warnings[0].get<std::string>().substr(0, 95),
        "experiment.e: particles.p: the particles miss what is asked for, since they are whole spheres: ");
    EXPECT_EQ(sample_document()["warnings"], json::array());
}

TEST(Document, shows_a_run_at_the_best_point_of_each_experiment)
{
    auto const details = sample_document()["details"];
    ASSERT_EQ(details.size(), 2u);
    EXPECT_EQ(details[0]["run"], 16);
    EXPECT_EQ(details[1]["run"], 18);
    EXPECT_EQ(details[0]["is_best"], true);
}

TEST(Document, shows_the_last_finished_run_while_nothing_is_analysed)
{
    auto const document = document_of(test::campaign_under_way(), test::sample_details);
    EXPECT_TRUE(document["optimum"].is_null());
    EXPECT_TRUE(document["surrogate"].is_null());
    ASSERT_EQ(document["details"].size(), 2u);
    EXPECT_EQ(document["details"][0]["run"], 4);
    EXPECT_EQ(document["details"][1]["run"], 2); // run 3, of the same experiment, failed
    EXPECT_EQ(document["details"][0]["is_best"], false);
}

TEST(Document, says_why_a_run_has_no_picture)
{
    auto const document = document_of(test::sample_campaign(), [](int run) -> ensemble::RunDetails {
        throw InputError("run " + std::to_string(run) + " has no snapshots");
    });
    EXPECT_EQ(document["details"][0]["absent"], "run 16 has no snapshots");
}

TEST(Picture, draws_the_nearest_particle_last_and_keeps_proportions)
{
    auto const picture = pictures_of({test::sample_details(0).snapshots[0]})[0];
    auto const& particles = picture["particles"];
    ASSERT_EQ(particles["h"].size(), 600u);
    double const quantum = picture["quantum"];
    // 12 particles of 0.1 m across, 10 up, and 4 % of the larger on every side.
    EXPECT_DOUBLE_EQ(quantum, 1.2 * 1.08 / 8192);
    EXPECT_EQ(picture["axes"][0], "x");
    EXPECT_EQ(particles["depth"].front(), 90); // y = 0.45 of 0 to 0.5
    EXPECT_EQ(particles["depth"].back(), 10);
    EXPECT_NEAR(particles["r"][0].get<double>() * quantum, 0.05, quantum);
    EXPECT_NEAR(particles["h"].back().get<double>() * quantum, 1.15 + 0.048, quantum);
    EXPECT_NEAR(picture["walls"][1][0].get<double>() * quantum, 1.2 + 0.048, quantum);
    ASSERT_EQ(picture["lines"].size(), 2u);
    EXPECT_NEAR(picture["lines"][0][2].get<double>() * quantum, 0.6 + 0.048, quantum);
    EXPECT_NEAR(picture["lines"][0][3].get<double>() * quantum, 0.3 + 0.048, quantum);
}

TEST(Picture, draws_a_polyhedron_as_its_corners)
{
    rig::Snapshot snapshot; // a cube, with one more that fills it, and a sphere behind it
    for (double const x : {0.0, 1.0})
        for (double const y : {0.0, 1.0})
            for (double const z : {0.0, 1.0})
                snapshot.x.push_back(x), snapshot.y.push_back(y), snapshot.z.push_back(z);
    snapshot.radius.assign(8, 0.1), snapshot.hull.assign(8, 1);
    for (auto* column : {&snapshot.x, &snapshot.y, &snapshot.z, &snapshot.radius})
        column->insert(column->end(), {0.5, 2.0});
    snapshot.hull.insert(snapshot.hull.end(), {rig::Snapshot::within_a_hull, rig::Snapshot::no_hull});
    auto const picture = pictures_of({snapshot})[0];
    auto const& particles = picture["particles"];
    ASSERT_EQ(particles["h"].size(), 2u);
    ASSERT_EQ(particles["corners"].size(), 1u);
    auto const& corners = particles["corners"]["1"]; // in front of the sphere, so after it
    ASSERT_EQ(corners.size(), 24u);
    double const quantum = picture["quantum"];
    EXPECT_NEAR(particles["r"][1].get<double>() * quantum, 0.1, quantum);
    EXPECT_NEAR((corners[1].get<double>() - corners[4].get<double>()) * quantum, -1, 2 * quantum);
}

TEST(Picture, has_one_frame_for_all_snapshots_of_a_run)
{
    auto const pictures = pictures_of(test::sample_details(0).snapshots);
    // The last column of the second snapshot has sunk by 0.22 m below the floor; 4 % of the height of 1.22 m
    // are room.
    EXPECT_NEAR(pictures[0]["origin"][1].get<double>(), -0.22 - 0.04 * 1.22, 1e-12);
    EXPECT_EQ(pictures[0]["size"], pictures[1]["size"]);
}

TEST(Picture, a_film_is_coarse_and_of_the_particles_in_front)
{
    auto const moments = test::sample_details(0).snapshots;
    auto const film = film_of(moments);
    ASSERT_EQ(film.size(), moments.size());
    EXPECT_LE(film[0]["size"][1].get<int>(), 999);
    EXPECT_EQ(film[0]["particles"]["h"].size(), 600u);
    EXPECT_EQ(film[0]["size"], film[1]["size"]);
    std::vector<rig::Snapshot> const many(100, moments[0]); // 400 particles each make 40,000
    auto const long_film = film_of(many);
    EXPECT_EQ(long_film[99]["particles"]["h"].size(), 400u);
    EXPECT_EQ(long_film[99]["hidden"], 200);
    EXPECT_TRUE(film_of({}).empty());
}

TEST(Picture, marks_each_particle_with_its_height_in_the_first_snapshot)
{
    auto const pictures = pictures_of(test::sample_details(0).snapshots);
    for (auto const& picture : pictures) {
        ASSERT_EQ(picture["particles"]["layer"].size(), 600u);
        EXPECT_EQ(picture["particles"]["layer"].back(),
                  100);                                  // the last drawn is the top one of the last column
        EXPECT_EQ(picture["particles"]["layer"][1], 11); // second of ten in the first column
    }
}

TEST(Picture, leaves_out_particles_that_are_nowhere)
{
    auto snapshot = test::sample_details(0).snapshots[0];
    snapshot.x[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(pictures_of({snapshot})[0]["particles"]["h"].size(), 599u);
}

TEST(Picture, thins_a_long_series)
{
    auto const columns = columns_of(test::sample_details(0).series);
    ASSERT_EQ(columns.size(), 2u);
    EXPECT_EQ(columns[1]["units"], "kg");
    EXPECT_EQ(columns[1]["values"].size(), 601u); // every second of 1201
    EXPECT_DOUBLE_EQ(columns[1]["values"][600], 25.0 - 0.01 * 1200);
}

TEST(Page, no_text_of_the_campaign_can_break_out_of_it)
{
    auto const page = page_of(sample_document(), "a < b");
    EXPECT_NE(page.find("<title>a &lt; b</title>"), std::string::npos);
    std::size_t closings = 0;
    for (std::size_t at = page.find("</script>"); at != std::string::npos;
         at = page.find("</script>", at + 1))
        ++closings;
    EXPECT_EQ(closings, 3u);
}

TEST(Page, a_name_that_is_a_mark_of_the_template_stays_a_name)
{
    auto const page = page_of(sample_document(), "{{document}}");
    EXPECT_NE(page.find("<title>{{document}}</title>"), std::string::npos);
    EXPECT_NE(page.find("\"rows\":[["), std::string::npos);
}

TEST(Page, refers_to_nothing_outside_itself)
{
    auto const page = page_of(sample_document(), "title");
    for (char const* reference : {"<link", " src=", "@import", "url(http", "sourceMappingURL"})
        EXPECT_EQ(page.find(reference), std::string::npos) << reference;
}

} // namespace demens::report
