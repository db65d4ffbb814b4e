#include "tests/unit/report/sample_campaign.hpp"

#include <cmath>
#include <limits>

namespace demens::report::test {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t slice_points = 41;

rig::RigInfo const& sample_rig()
{
    static rig::RigInfo const info{.name = "heap",
                                   .doc = "a rig for tests",
                                   .options = {},
                                   .responses = {{"angle_of_repose_deg", "deg", "slope of the heap"},
                                                 {"mass_flow_kg_s", "kg/s", "slope of the mass over time"},
                                                 {"porosity", "1", "without a target"}},
                                   .check = {},
                                   .predict_cost = {},
                                   .run = {}};
    return info;
}

ensemble::CampaignInput sample_input()
{
    auto input = ensemble::CampaignInput{};
    input.name = "heap <of> \"sand\" & </script>";
    input.seed = 7;
    input.experiments = {{.name = "slow",
                          .rig = &sample_rig(),
                          .replicates = 2,
                          .responses = sample_rig().responses,
                          .targets = {{"angle_of_repose_deg", 0, 30.0, 2.0, 0.5, 1.0},
                                      {"mass_flow_kg_s", 1, 5.0, 0.3, unknown, unknown}}},
                         {.name = "fast",
                          .rig = &sample_rig(),
                          .replicates = 2,
                          .responses = sample_rig().responses,
                          .targets = {{"angle_of_repose_deg", 0, 28.0, 2.0, unknown, 2.0}}}};
    input.factors = {
        {.path = "contact.a_a.static_friction", .name = "static_friction", .lower = 0.1, .upper = 1.2},
        {.path = "contact.a_a.rolling_friction", .name = "rolling_friction", .lower = 0.0, .upper = 0.6},
        {.path = "contact.a_a.cohesion",
         .name = "cohesion",
         .lower = 1.0,
         .upper = 1000.0,
         .log_scale = true}};
    input.constraints = {{"rolling_friction <= static_friction", {-1, 1, 0}, 0}};
    input.stop.wmse = 0.02;
    return input;
}

std::vector<std::vector<double>> const& design()
{
    static std::vector<std::vector<double>> const points = {{0.2, 0.1, 2.0},   {0.5, 0.3, 20.0},
                                                            {0.8, 0.5, 200.0}, {1.1, 0.2, 900.0},
                                                            {0.6, 0.25, 30.0}, {0.7, 0.35, 60.0}};
    return points;
}

//! Responses that grow with friction; replicates differ by 0.2 degrees.
std::vector<double> responses_of(std::vector<double> const& factors, int experiment, int replicate)
{
    double const angle = 20 + 12 * factors[0] + 8 * factors[1] - 2 * experiment + 0.2 * replicate;
    return {angle, 7 - 2.5 * factors[0], 0.4 + 0.01 * replicate};
}

ensemble::Wave wave_of(int number, ensemble::WavePurpose purpose, int first_point, int points, int first_run,
                       int replicates = 2)
{
    ensemble::Wave wave{
        .number = number, .purpose = purpose, .runs = {}, .analysis = {}, .wall_time = 0, .groups = 3};
    for (int point = first_point; point < first_point + points; ++point)
        for (int experiment = 0; experiment < 2; ++experiment)
            for (int replicate = 0; replicate < replicates; ++replicate) {
                ensemble::RunRecord run;
                run.run = first_run + static_cast<int>(wave.runs.size());
                run.wave = number;
                run.point = point;
                run.experiment = experiment;
                run.replicate = replicate;
                run.factors = design().at(static_cast<std::size_t>(point));
                run.responses = {unknown, unknown, unknown};
                wave.runs.push_back(run);
            }
    return wave;
}

//! Ends a run after 10 s on one of three groups.
void finish(ensemble::RunRecord& run, int place)
{
    run.status = rig::RunStatus::finished;
    run.responses = responses_of(run.factors, run.experiment, run.replicate);
    run.wall_time = 10;
    run.group = place % 3;
    run.start_time = 10.0 * (place / 3);
    run.particles = 600;
    run.steps = 1000;
}

void fail(ensemble::RunRecord& run)
{
    run.status = rig::RunStatus::escaped;
    run.reason = "3 particles left the domain at 0.2 s, the first near (0.1, 0, -1) m <b>";
    run.responses = {unknown, unknown, unknown};
}

void finish_all(ensemble::Wave& wave)
{
    for (std::size_t i = 0; i < wave.runs.size(); ++i)
        finish(wave.runs[i], static_cast<int>(i));
    wave.wall_time = 10.0 * std::ceil(static_cast<double>(wave.runs.size()) / 3);
}

ensemble::NamedArray array(std::string const& path, std::vector<std::size_t> shape, std::vector<double> data)
{
    return {path, std::move(shape), std::move(data), "mixed", ""};
}

std::vector<ensemble::NamedArray> sample_analysis()
{
    std::vector<double> values, slices, sd;
    auto const input = sample_input();
    for (auto const& factor : input.factors)
        for (std::size_t i = 0; i < slice_points; ++i) {
            double const t = static_cast<double>(i) / (slice_points - 1);
            values.push_back(factor.log_scale ? factor.lower * std::pow(factor.upper / factor.lower, t)
                                              : factor.lower + t * (factor.upper - factor.lower));
        }
    for (int target = 0; target < 3; ++target)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t i = 0; i < slice_points; ++i) {
                auto factors = design()[4];
                factors[j] = values[j * slice_points + i];
                slices.push_back(responses_of(factors, target / 2, 0)[target == 1 ? 1 : 0]);
                sd.push_back(0.3);
            }
    std::vector<double> history(24, 0.9);
    for (std::size_t i = 0; i < 4; ++i)
        history[i] = unknown;
    for (std::size_t i = 20; i < 24; ++i)
        history[i] = 0.031;
    return {array("surrogate/locations", {1}, {5}),
            array("surrogate/complete_locations", {1}, {9}),
            array("surrogate/kind", {3}, {4, 4, 4}),
            array("surrogate/leave_one_out_rmse", {3}, {0.6, 0.2, 0.7}),
            array("surrogate/leave_one_out_r2", {3}, {0.9, 0.8, 0.9}),
            array("surrogate/replicate_sd", {3}, {0.14, unknown, 0.14}),
            array("surrogate/slice_values", {3, slice_points}, values),
            array("surrogate/slices", {3, 3, slice_points}, slices),
            array("surrogate/slice_sd", {3, 3, slice_points}, sd),
            array("optimum/best_point", {3}, design()[4]),
            array("optimum/best_point_number", {1}, {4}),
            array("optimum/best_run", {1}, {16}),
            array("optimum/best_repetitions", {1}, {1}),
            array("optimum/best_responses", {3}, {29.3, 5.5, 27.3}),
            array("optimum/best_residuals", {3}, {-0.35, 1.6666666666666667, -0.35}),
            array("optimum/wmse", {1}, {0.031}),
            array("optimum/mean_square_residual", {1}, {1.0075925925925926}),
            array("optimum/predicted_point", {3}, {0.65, 0.24, 33.0}),
            array("optimum/predicted_responses", {3}, {29.7, 5.4, 27.7}),
            array("optimum/predicted_sd", {3}, {0.6, 0.2, 0.7}),
            array("optimum/predicted_wmse", {1}, {0.02}),
            array("optimum/factor_standard_error", {3}, {0.05, 0.1, 200}),
            array("optimum/factor_interval", {3, 2}, {0.55, 0.74, 0.05, 0.5, 1.0, 1000.0}),
            array("optimum/factor_correlation", {3, 3}, {1, -0.82, 0.05, -0.82, 1, 0.1, 0.05, 0.1, 1}),
            array("optimum/factor_verdict", {3}, {0, 1, 2}),
            array("optimum/factor_spread", {3}, {0.146, 0.4, unknown}),
            array("optimum/factor_on_bound", {3}, {0, 0, 1}),
            array("optimum/estimate", {3}, {0.651, 0.241, 33.1}),
            array("optimum/estimate_responses", {3}, {29.7, 5.4, 27.7}),
            array("optimum/estimate_sd", {3}, {0.6, 0.2, 0.7}),
            array("optimum/least_misfit", {1}, {3.1}),
            array("optimum/degrees", {1}, {3}),
            array("optimum/p_value", {1}, {0.376}),
            array("optimum/noise_inflation", {1}, {1}),
            array("optimum/objective", {1}, {0.031}),
            array("optimum/out_of_reach", {3}, {0, 0, -0.4}),
            array("region/by_tolerance", {1}, {1}),
            array("region/share", {1}, {0.08}),
            array("region/part_shares", {2}, {0.7, 0.3}),
            array("region/part_lower", {2, 3}, {0.5, 0.1, 2, 0.9, 0.05, 10}),
            array("region/part_upper", {2, 3}, {0.7, 0.4, 900, 1.0, 0.1, 800}),
            array("tradeoff/factors", {2, 2}, {0, 1, 1, 2}),
            array("tradeoff/correlation", {2}, {-0.82, 0.75}),
            array("tradeoff/response", {2, 2}, {0, 2, -1, -1}),
            array("tradeoff/variance_removed", {2}, {0.64, 0}),
            array("screening/active", {3}, {1, 1, 0}),
            array("screening/fixed_value", {3}, {unknown, unknown, 30}),
            array("screening/effects", {3, 3}, {9, 4, 0.1, -2.7, 0.1, 0.05, 8, 4, 0.2}),
            array("screening/p_values", {3, 3}, {1e-5, 0.002, 0.7, 1e-4, 0.6, 0.8, 2e-5, 0.003, 0.5}),
            array("screening/error_sd", {3}, {0.5, 0.1, 0.5}),
            array("screening/error_degrees", {3}, {16, 16, 16}),
            array("screening/error_from_replicates", {1}, {1}),
            array("history/wmse", {24}, history),
            array("history/point_wmse", {6}, {1.9, unknown, 0.9, 2.4, 0.031, 0.12})};
}

} // namespace

ensemble::Campaign sample_campaign()
{
    ensemble::Campaign campaign;
    campaign.input = sample_input();
    campaign.waves = {wave_of(0, ensemble::WavePurpose::design, 0, 4, 0),
                      wave_of(1, ensemble::WavePurpose::search, 4, 2, 16)};
    for (auto& wave : campaign.waves)
        finish_all(wave);
    fail(campaign.waves[0].runs[5]);
    campaign.waves[1].analysis = sample_analysis();
    campaign.ended = "no better point in 4 waves";
    return campaign;
}

ensemble::Campaign campaign_under_way()
{
    ensemble::Campaign campaign;
    campaign.input = sample_input();
    campaign.waves = {wave_of(0, ensemble::WavePurpose::design, 0, 4, 0)};
    for (std::size_t i = 0; i < 5; ++i)
        finish(campaign.waves[0].runs[i], static_cast<int>(i));
    fail(campaign.waves[0].runs[3]);
    return campaign;
}

ensemble::Campaign new_campaign()
{
    ensemble::Campaign campaign;
    campaign.input = sample_input();
    return campaign;
}

ensemble::Campaign campaign_of_many_runs(int replicates)
{
    ensemble::Campaign campaign;
    campaign.input = sample_input();
    campaign.input.experiments[0].replicates = campaign.input.experiments[1].replicates = replicates;
    auto wave = wave_of(0, ensemble::WavePurpose::design, 0, 4, 0, replicates);
    finish_all(wave);
    campaign.waves = {wave};
    return campaign;
}

ensemble::RunDetails sample_details(int run)
{
    ensemble::RunDetails details;
    for (char const* name : {"settled", "final"}) {
        bool const final = std::string(name) == "final";
        rig::Snapshot snapshot;
        snapshot.name = name;
        snapshot.time = final ? 2.5 : 0;
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 5; ++j)
                for (int k = 0; k < 10; ++k) {
                    snapshot.x.push_back(0.05 + 0.1 * i);
                    snapshot.y.push_back(0.05 + 0.1 * j);
                    snapshot.z.push_back(0.05 + 0.1 * k - (final ? 0.02 * i : 0));
                    snapshot.radius.push_back(0.05);
                    snapshot.vx.push_back(final ? 0.1 * k : 0);
                    for (auto* still : {&snapshot.vy, &snapshot.vz, &snapshot.wx, &snapshot.wy, &snapshot.wz})
                        still->push_back(0);
                }
        snapshot.walls = {{0, 0, 0, 0, 0.5, 1.2},
                          {1.2, 0, 0, 1.2, 0.5, 1.2},
                          {0, 0, 0, 1.2, 0.5, 0},
                          {0, 0, 0, 1.2, 0, 1.2}};
        snapshot.wall_lines = {{0, 0.25, 0, 0.6, 0.25, 0.3}, {0.6, 0.25, 0.3, 1.2, 0.25, 0}};
        details.snapshots.push_back(snapshot);
    }
    details.series = {{"time_s", "upper_mass_kg"}, {"s", "kg"}, {{}, {}}};
    for (int i = 0; i <= 1200; ++i) {
        details.series.columns[0].push_back(0.002 * i);
        details.series.columns[1].push_back(25.0 - 0.01 * i + 0.001 * run);
    }
    details.profiles = {
        {"heap", "surface of the heap", {{"x", "height"}, {"m", "m"}, {{0, 0.1, 0.2}, {0.3, 0.2, 0.1}}}}};
    return details;
}

} // namespace demens::report::test
