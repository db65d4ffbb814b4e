#include "ensemble/input/whole_checks.hpp"

#include "demens/rig/programme/programme.hpp"
#include "ensemble/input/design_table.hpp"
#include "ensemble/input/input_options.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::ensemble::input {
namespace {

using Point = std::vector<double>;

std::string joined_words(std::vector<DesignKind> const& kinds)
{
    std::vector<std::string> words;
    for (auto const kind : kinds)
        words.emplace_back(word_for(kind));
    return fmt::format("{}", fmt::join(words, ", "));
}

void check_design(InputTable const& design, CampaignInput const& input)
{
    for (auto const& key : design.keys()) {
        auto const kinds = design_kinds_using(key);
        if (!kinds.empty() && std::find(kinds.begin(), kinds.end(), input.design.kind) == kinds.end())
            throw design.error(key, fmt::format("is not used by kind = \"{}\", only by {}; leave it out",
                                                word_for(input.design.kind), joined_words(kinds)));
    }
    if (input.design.kind == DesignKind::table && input.design.table.empty())
        throw design.error(
            "kind", "needs table = [[...], ...] with one row of factor values for each design point, or "
                    "table_file = \"FILE.csv\"");
}

void check_budget(InputTable const& design, InputTable const& stop, CampaignInput const& input)
{
    int runs_per_point = 0;
    std::size_t targets = 0;
    for (auto const& experiment : input.experiments) {
        if (experiment.role == ExperimentRole::calibrate)
            runs_per_point += experiment.replicates;
        targets += experiment.targets.size();
    }
    if (targets == 0 && input.stop.waves > 0)
        throw stop.error("no experiment has a target, so that there is nothing to search for; give "
                         "target.RESPONSE = { value = ..., scale = ... } or, to run the design alone, "
                         "waves = 0 in [stop]");
    long const screened =
        input.screening.points > 0 ? input.screening.points + input.screening.centre_repetitions : 0;
    if (screened * runs_per_point > input.stop.runs)
        throw stop.error(
            fmt::format("the screening needs {} runs ({} points, {} runs each), but runs = {}; raise "
                        "it or screen with fewer points",
                        screened * runs_per_point, screened, runs_per_point, input.stop.runs));
    int const points = input.design.kind == DesignKind::table ? static_cast<int>(input.design.table.size())
                                                              : input.design.points;
    if (static_cast<long>(points) * runs_per_point > input.stop.runs)
        throw design.error(
            input.design.kind != DesignKind::table ? "points"
            : input.design.table_file.empty()      ? "table"
                                                   : "table_file",
            fmt::format("{} design points need {} runs ({} each), but [stop] runs = {}; raise one or "
                        "lower the other",
                        points, static_cast<long>(points) * runs_per_point, runs_per_point, input.stop.runs));
}

//! A two-level fraction needs a power of two, and a following design that can be made in fewer factors.
void check_screening(InputTable const& screening, CampaignInput const& input)
{
    int const points = input.screening.points;
    if (points == 0) {
        if (screening.has("generators"))
            throw screening.error("generators", "needs points > 0, the number of points to screen with");
        return;
    }
    if (points < 4 || (points & (points - 1)) != 0)
        throw screening.error("points", "must be a power of 2 from 4 on, such as 16");
    if (points <= static_cast<int>(input.factors.size()))
        throw screening.error("points",
                              fmt::format("cannot tell the {} factors apart; it must be more than {}",
                                          input.factors.size(), input.factors.size()));
    if (!input.design.table.empty())
        throw screening.error("points",
                              "cannot go before a [design] with a table, whose rows are made for all "
                              "factors; leave one of them out");
}

void check_objective(InputTable const& objective, CampaignInput const& input)
{
    if (input.objective.kind != ObjectiveKind::relative_deviations)
        return;
    for (auto const& experiment : input.experiments)
        for (auto const& target : experiment.targets)
            if (target.value == 0)
                throw objective.error(
                    "kind", fmt::format("relative deviations need targets other than 0, but that of "
                                        "{}.{} is 0",
                                        experiment.name, target.response));
}

//! POUNDERS that works on the simulation itself is the solver already.
void check_search(InputTable const& solver, CampaignInput const& input)
{
    if (input.search.kind == SearchKind::pounders_direct && input.solver.kind != SolverKind::pounders)
        throw solver.error("kind", "does not go with [search] kind = \"pounders_direct\"; leave it out");
}

//! Corners of the box of factors; of many factors only a few points on its faces.
std::vector<Point> extreme_points(std::vector<Factor> const& factors)
{
    constexpr std::size_t most_factors_for_all_corners = 8;
    std::vector<Point> points;
    if (factors.size() <= most_factors_for_all_corners) {
        for (std::size_t corner = 0; corner < std::size_t{1} << factors.size(); ++corner) {
            Point point;
            for (std::size_t f = 0; f < factors.size(); ++f)
                point.push_back(corner >> f & 1 ? factors[f].upper : factors[f].lower);
            points.push_back(std::move(point));
        }
        return points;
    }
    Point lower, upper, middle;
    for (auto const& factor : factors) {
        lower.push_back(factor.lower);
        upper.push_back(factor.upper);
        middle.push_back(0.5 * (factor.lower + factor.upper));
    }
    points = {lower, upper};
    for (std::size_t f = 0; f < factors.size(); ++f) {
        for (double bound : {lower[f], upper[f]}) {
            points.push_back(middle);
            points.back()[f] = bound;
        }
    }
    return points;
}

//! What a rig has against an experiment at a point (empty: at the base values); empty when nothing.
std::string refusal(CampaignInput const& input, BaseInput const& base, std::size_t experiment,
                    Point const& point)
{
    try {
        check_run(*input.experiments[experiment].rig,
                  make_run_input(base, point, static_cast<int>(experiment), input.seed),
                  input.run.ranks_per_group);
    } catch (InputError const& error) {
        return error.what();
    }
    return {};
}

double constexpr particles_a_rank = 1e4;

//! Ranks among which the run of an experiment can be shared, no more than asked for.
int ranks_that_can_share(CampaignInput const& input, BaseInput const& base, std::size_t experiment, int asked)
{
    auto const& rig = *input.experiments[experiment].rig;
    if (!rig.describe)
        return 1;
    auto const run = make_run_input(base, {}, static_cast<int>(experiment), input.seed);
    for (int ranks = asked; ranks > 1; --ranks)
        try {
            rig::programme_of(rig, run, ranks);
            return ranks;
        } catch (InputError const&) { // fewer, then
        }
    return 1;
}

} // namespace

void check_run(rig::RigInfo const& rig, rig::RunInput const& run, int ranks)
{
    if (rig.check)
        rig.check(run);
    if (rig.describe && ranks > 1)
        rig::programme_of(rig, run, ranks);
}

int ranks_that_pay(CampaignInput const& input, BaseInput const& base)
{
    if (input.run.engine != rig::EngineChoice::cpu)
        return 1;
    double most = 0;
    for (std::size_t e = 0; e < input.experiments.size(); ++e) {
        try {
            if (auto const& describe = input.experiments[e].rig->describe)
                most = std::max(
                    most,
                    describe(make_run_input(base, {}, static_cast<int>(e), input.seed)).expected_particles);
        } catch (InputError const&) {
            return 1; // check_rigs() says what is wrong
        }
    }
    int ranks = std::max(1, static_cast<int>(most / particles_a_rank));
    for (std::size_t e = 0; e < input.experiments.size() && ranks > 1; ++e)
        ranks = ranks_that_can_share(input, base, e, ranks);
    return ranks;
}

void check_sections(InputTable const& file, CampaignInput const& input)
{
    bool const on_device =
        input.run.engine == rig::EngineChoice::cuda || input.run.engine == rig::EngineChoice::cuda_on_host;
    if (on_device && input.run.ranks_per_group > 1)
        throw file.table("run").error("engine",
                                      "a device has a run to itself; give ranks_per_group = 1, or the "
                                      "engine \"cpu\" or \"auto\"");
    if (input.run.engine == rig::EngineChoice::cpu && input.run.runs_together > 0)
        throw file.table("run").error("runs_together",
                                      "processors do the runs of a group one after another; leave it out, or "
                                      "give the engine \"cuda\" or \"auto\"");
    auto const design = file.table("design");
    check_screening(file.table("screening"), input);
    check_objective(file.table("objective"), input);
    check_design(design, input);
    check_search(file.table("solver"), input);
    check_budget(design, file.table("stop"), input);
}

void check_rigs(CampaignInput const& input, BaseInput const& base,
                std::vector<InputTable> const& experiment_tables)
{
    auto const points = extreme_points(input.factors);
    for (std::size_t e = 0; e < input.experiments.size(); ++e) {
        auto const& rig = input.experiments[e].rig->name;
        if (auto const reason = refusal(input, base, e, {}); !reason.empty())
            throw experiment_tables[e].error(fmt::format("the rig {} cannot run this: {}", rig, reason));
        for (auto const& point : points) {
            if (!broken_constraint(input, point).empty())
                continue;
            auto const reason = refusal(input, base, e, point);
            if (reason.empty())
                continue;
            std::string values;
            for (std::size_t f = 0; f < point.size(); ++f)
                values += fmt::format("{}{} = {}", f ? ", " : "", input.factors[f].name, point[f]);
            throw experiment_tables[e].error(fmt::format(
                "the rig {} cannot run this where the factors are {}: {}; narrow the bounds of these "
                "factors or add a [[constraint]]",
                rig, values, reason));
        }
    }
}

} // namespace demens::ensemble::input
