#include "tao_calib/wave/plan.hpp"

#include "tao_calib/design/design.hpp"
#include "tao_calib/wave/progress.hpp"
#include "tao_calib/wave/search.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace demens::tao_calib {
namespace {

using ensemble::Campaign;
using ensemble::RunRecord;
using ensemble::WavePurpose;

constexpr std::uint64_t search_stream = 0x736561726368; // "search"
constexpr int most_design_waves = 3;
constexpr int most_confirmations_in_a_row = 3;

int waves_of(Campaign const& campaign, WavePurpose purpose)
{
    return static_cast<int>(std::count_if(campaign.waves.begin(), campaign.waves.end(),
                                          [&](auto const& wave) { return wave.purpose == purpose; }));
}

//! Those that count against [stop].
int counted_waves_of(Campaign const& campaign, WavePurpose purpose)
{
    return static_cast<int>(
        std::count_if(campaign.waves.begin(), campaign.waves.end(), [&](auto const& wave) {
            return wave.purpose == purpose && wave.number >= campaign.first_counted_wave();
        }));
}

int confirmations_in_a_row(Campaign const& campaign)
{
    int count = 0;
    for (auto wave = campaign.waves.rbegin();
         wave != campaign.waves.rend() && wave->purpose == WavePurpose::confirmation; ++wave)
        ++count;
    return count;
}

//! What the stop options still allow.
struct Budget
{
    explicit Budget(Campaign const& campaign)
    {
        int per_point = 0;
        for (auto const& experiment : campaign.input.experiments)
            if (experiment.role == ensemble::ExperimentRole::calibrate)
                per_point += experiment.replicates;
        double wall_time = 0;
        for (auto const& wave : campaign.waves)
            if (wave.number >= campaign.first_counted_wave() && wave.taken_from.empty())
                wall_time += wave.wall_time;
        auto const& stop = campaign.input.stop;
        points = campaign.runs_left() / std::max(1, per_point);
        time_is_up = stop.wall_time_s > 0 && wall_time >= stop.wall_time_s;
    }
    int points;      //!< design points, all experiments and replicates each
    bool time_is_up; //!< of the wall time
};

//! For so many locations repetitions are kept back: the best one, and the one that may follow it.
constexpr std::size_t locations_kept_for = 2;

//! Design points kept back for the confirmation.
int reserve(Campaign const& campaign)
{
    return static_cast<int>(locations_kept_for) * campaign.input.stop.confirmation;
}

std::uint64_t wave_seed(Campaign const& campaign)
{
    return derive_seed(derive_seed(campaign.input.seed, search_stream), campaign.waves.size());
}

NextStep wave(WavePurpose purpose, std::vector<std::vector<double>> points)
{
    return {NextStep::Kind::simulate, purpose, std::move(points), {}};
}

int batch_size(Campaign const& campaign)
{
    auto const& search = campaign.input.search;
    int const batch =
        search.batch > 0 ? search.batch : std::max(4, 2 * static_cast<int>(campaign.input.factors.size()));
    // Two halves on their way at a time: each point is chosen without the results of as many others as in a
    // whole batch.
    return waves_overlap(campaign.input) ? (batch + 1) / 2 : batch;
}

//! The campaign as if no run of the last wave had ended.
Campaign without_last_results(Campaign campaign)
{
    auto& wave = campaign.waves.back();
    wave.analysis.clear();
    for (auto& run : wave.runs) {
        RunRecord plan;
        plan.run = run.run, plan.wave = run.wave, plan.point = run.point, plan.experiment = run.experiment;
        plan.replicate = run.replicate, plan.seed = run.seed, plan.factors = run.factors;
        plan.predicted_cost = run.predicted_cost;
        run = std::move(plan);
    }
    return campaign;
}

NextStep screening_wave(Campaign const& campaign)
{
    auto const design = screening_points(campaign.input);
    std::vector<std::vector<double>> points;
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        Eigen::VectorXd const row = design.row(i);
        points.emplace_back(row.begin(), row.end());
    }
    return wave(WavePurpose::screening, points);
}

NextStep design_wave(Campaign const& campaign, UnitCube const& cube, Budget const& budget)
{
    auto const& input = campaign.input;
    auto const design = cube.whole_points(
        make_design(input.design, cube.space().factors(), cube.space().constraints(), input.seed));
    std::vector<std::vector<double>> points;
    for (Eigen::Index i = 0; i < std::min<Eigen::Index>(design.rows(), budget.points); ++i) {
        Eigen::VectorXd const row = design.row(i);
        points.emplace_back(row.begin(), row.end());
    }
    if (points.empty())
        return {NextStep::Kind::give_up,
                {},
                {},
                fmt::format("stop.runs = {} does not allow a single design point", input.stop.runs)};
    return wave(WavePurpose::design, points);
}

std::string first_failure(Campaign const& campaign)
{
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs)
            if (rig::has_failed(run.status))
                return fmt::format("run {}: {}{}{}", run.run, rig::name_of(run.status),
                                   run.reason.empty() ? "" : ", ", run.reason);
    return "every run finished, but without a value for every target";
}

//! More points where too few runs finished to fit anything.
NextStep more_design(Campaign const& campaign, Assessment const& assessment, Budget const& budget)
{
    auto const& locations = assessment.locations();
    int const needed = Assessment::locations_needed(assessment.cube().size());
    auto give_up = [&](std::string const& why) {
        return NextStep{
            NextStep::Kind::give_up,
            {},
            {},
            fmt::format("{} of {} design points have a value for every target, {} are needed to fit "
                        "anything, and {}; the first failure is {}",
                        locations.complete(), locations.all().size(), needed, why, first_failure(campaign))};
    };
    if (locations.finished_runs() == 0)
        return give_up("no run has finished at all");
    if (counted_waves_of(campaign, WavePurpose::design) >= most_design_waves)
        return give_up("further points did not help");
    int const missing = needed - locations.complete();
    int const count = std::min(std::max(batch_size(campaign), 2 * missing), budget.points);
    auto points = filling_points(assessment, count, wave_seed(campaign));
    if (points.empty() || budget.time_is_up)
        return give_up("the budget is spent");
    return wave(WavePurpose::design, std::move(points));
}

//! Why the fit is good enough, if it is.
std::optional<std::string> goal_reached(Campaign const& campaign, Assessment const& assessment,
                                        Location const& best,
                                        std::vector<ensemble::NamedArray> const& analysis)
{
    if (!campaign.extensions.empty() && campaign.extensions.back().runs > 0)
        return std::nullopt; // more runs were asked for
    auto const& stop = campaign.input.stop;
    double const wmse = assessment.objective().wmse(best.responses);
    if (stop.wmse > 0 && wmse <= stop.wmse)
        return fmt::format("the weighted mean square error {:.4g} is at most {:.4g} (stop.wmse)", wmse,
                           stop.wmse);
    if (stop.within_tolerance && assessment.objective().within_tolerance(best.responses))
        return "every target with a tolerance is met within it";
    // POUNDERS on the simulation has an end of its own.
    if (stop.no_improvement_waves > 0 &&
        campaign.input.search.kind != ensemble::SearchKind::pounders_direct &&
        intervals_settled(campaign, analysis)) {
        if (met_within_noise(assessment))
            return "every target is met within a tenth of its standard deviation, and the intervals no "
                   "longer "
                   "change";
        if (best_is_as_good_as_can_be(campaign, assessment, analysis))
            return "the best run is as near to the targets as any can be, within what their standard "
                   "deviations "
                   "tell, and the intervals no longer change";
    }
    return std::nullopt;
}

//! Why the search cannot or need not go on, if so. Keeps points for the confirmation.
std::optional<std::string> search_exhausted(Campaign const& campaign, Assessment const& assessment,
                                            Budget const& budget)
{
    auto const& stop = campaign.input.stop;
    if (budget.time_is_up)
        return fmt::format("the wall time of {:g} s is spent (stop.wall_time_s)", stop.wall_time_s);
    if (budget.points <= reserve(campaign))
        return fmt::format("no further point fits into the budget of {} runs (stop.runs)", stop.runs);
    if (counted_waves_of(campaign, WavePurpose::search) >= stop.waves)
        return fmt::format("{} waves have searched (stop.waves)", stop.waves);
    if (stop.no_improvement_waves > 0 && waves_in_vain(campaign, assessment) >= stop.no_improvement_waves)
        return fmt::format("{} waves in a row found nothing better beyond noise (stop.no_improvement_waves)",
                           stop.no_improvement_waves);
    return std::nullopt;
}

//! Repetitions that the location lacks to be confirmed.
int missing_repetitions(Campaign const& campaign, Location const& location)
{
    return std::max(0, 1 + campaign.input.stop.confirmation - static_cast<int>(location.points.size()));
}

//! The end, or first the repetitions that are missing of the best location; of all that points are kept back
//! for where only those points are left, so that they run at once.
NextStep confirm_or_finish(Campaign const& campaign, Assessment const& assessment, Budget const& budget,
                           std::string const& reason)
{
    auto ranked = assessment.locations().ranked();
    bool const can_confirm = budget.points > 0 && !budget.time_is_up &&
                             confirmations_in_a_row(campaign) < most_confirmations_in_a_row;
    if (can_confirm && missing_repetitions(campaign, *ranked.front()) > 0) {
        ranked.resize(std::min(ranked.size(), budget.points > reserve(campaign) ? 1 : locations_kept_for));
        std::vector<std::vector<double>> points;
        for (auto const* location : ranked)
            points.insert(points.end(), static_cast<std::size_t>(missing_repetitions(campaign, *location)),
                          {location->factors.begin(), location->factors.end()});
        points.resize(std::min(points.size(), static_cast<std::size_t>(budget.points)));
        return wave(WavePurpose::confirmation, std::move(points));
    }
    return {NextStep::Kind::finish, {}, {}, reason};
}

//! Why the search has no further point.
std::string nothing_left(Campaign const& campaign, Assessment const& assessment)
{
    if (campaign.input.search.kind == ensemble::SearchKind::pounders_direct)
        return "POUNDERS on the simulation has come to its end";
    auto const& free = assessment.cube().free_factors();
    bool const counted = std::all_of(free.begin(), free.end(), [&](int factor) {
        return !assessment.cube().factor(factor).levels.empty();
    });
    if (assessment.locations().failed_runs() > 0)
        return fmt::format(
            "every point left is close to one that has been simulated, or lies where runs fail{}",
            counted ? ", on the levels of the factors" : "");
    return counted ? "every combination of the factors' levels has been simulated"
                   : "every point left is close to one that has been simulated";
}

} // namespace

NextStep first_wave(ensemble::CampaignInput const& input)
{
    Campaign const campaign{input, {}, {}};
    if (has_screening(input))
        return screening_wave(campaign);
    return design_wave(campaign, UnitCube(input.factors, input.constraints), Budget(campaign));
}

//! A single run of a packing scatters, and the best of many runs is a lucky one. So a campaign ends only when
//! its best location has been repeated with fresh packings and is still the best: every repetition enters the
//! mean of its location, and whichever location is best then is repeated in turn. At the end of the budget
//! the two best are repeated in one wave, so that no group waits: what is kept back is for them anyway.
NextStep plan_next_wave(Campaign const& campaign, Assessment const& assessment,
                        std::vector<ensemble::NamedArray> const& analysis)
{
    Budget const budget(campaign);
    if (campaign.waves.empty() && has_screening(campaign.input))
        return screening_wave(campaign);
    if (waves_of(campaign, WavePurpose::design) == 0)
        return design_wave(campaign, assessment.cube(), budget);
    if (assessment.objective().size() == 0)
        return {NextStep::Kind::finish,
                {},
                {},
                "the design is done, and without targets there is nothing to search"};
    if (campaign.input.stop.waves == 0)
        return {
            NextStep::Kind::finish, {}, {}, "the design is done, and no wave shall search (stop.waves = 0)"};
    if (!assessment.fitted())
        return more_design(campaign, assessment, budget);

    Location const& best = *assessment.locations().best();
    auto const goal = goal_reached(campaign, assessment, best, analysis);
    auto const exhausted = search_exhausted(campaign, assessment, budget);
    if (goal || exhausted) {
        auto step = confirm_or_finish(campaign, assessment, budget, goal ? *goal : *exhausted);
        if (step.kind == NextStep::Kind::simulate || exhausted || missing_repetitions(campaign, best) == 0)
            return step;
    }

    auto points =
        search_points(campaign, assessment, std::min(batch_size(campaign), budget.points - reserve(campaign)),
                      wave_seed(campaign));
    if (points.empty())
        return confirm_or_finish(campaign, assessment, budget, nothing_left(campaign, assessment));
    return wave(WavePurpose::search, std::move(points));
}

bool waves_overlap(ensemble::CampaignInput const& input)
{
    using ensemble::SearchKind;
    auto const kind = input.search.kind;
    // The others follow a path: a step without the result of the one before leads astray.
    return input.search.overlap && kind != SearchKind::pounders_direct &&
           kind != SearchKind::response_surface;
}

std::optional<NextStep> plan_overlapping_wave(Campaign const& campaign, LeastSquaresSolver const& solver)
{
    if (!waves_overlap(campaign.input) || campaign.waves.empty() ||
        campaign.waves.back().purpose != WavePurpose::search)
        return {};
    auto const known = without_last_results(campaign);
    auto step = plan_next_wave(known, Assessment(known, solver));
    if (step.kind != NextStep::Kind::simulate || step.purpose != WavePurpose::search)
        return {};
    return step;
}

} // namespace demens::tao_calib
