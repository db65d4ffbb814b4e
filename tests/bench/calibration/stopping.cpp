// How many runs campaigns take until they end by themselves, and how far from the truth they end, for every
// way of searching. Writes a table in Markdown.   stopping [SEEDS] [PROBLEM...]
#include "tests/bench/calibration/stopping_problems.hpp"
#include "tests/bench/calibration/with_petsc.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::bench {
namespace {

using namespace tao_calib;
using ensemble::SearchKind;
using ensemble::SolverKind;

struct Way
{
    SearchKind search = SearchKind::surrogate_minima;
    SolverKind solver = SolverKind::pounders;
    SurrogateChoice surrogate = SurrogateChoice::automatic;

    std::string name() const
    {
        std::string const text = search == SearchKind::surrogate_minima ? word_for(solver) : word_for(search);
        return surrogate == SurrogateChoice::automatic ? text : text + ", " + word_for(surrogate);
    }
};

std::vector<Way> ways()
{
    std::vector<Way> all;
    for (auto const& word : words_of<SolverKind>())
        all.push_back({.solver = word.value});
    for (auto const kind : {SearchKind::rbf_distance, SearchKind::response_surface,
                            SearchKind::expected_improvement, SearchKind::pounders_direct})
        all.push_back({.search = kind});
    all.push_back({.search = SearchKind::response_surface, .surrogate = SurrogateChoice::quadratic});
    return all;
}

struct Outcome
{
    int runs;
    double distance; //!< of the estimate's true responses from those of the truth, root mean square, in sd
};

Outcome outcome(Problem const& problem, Way const& way, std::uint64_t seed)
{
    auto const truth = problem.truth(seed);
    auto stand_in = campaign_of(problem, truth, seed);
    auto& input = stand_in.campaign.input;
    input.search.kind = way.search;
    input.solver.kind = way.solver;
    input.surrogate.kind = way.surrogate;
    stand_in.run_to_the_end();
    auto const found = problem.formula(stand_in.stored("optimum/estimate")), wanted = problem.formula(truth);
    double squares = 0;
    for (std::size_t t = 0; t < wanted.size(); ++t)
        squares += std::pow((found[t] - wanted[t]) / problem.sd(t, wanted[t]), 2);
    return {stand_in.runs(), std::sqrt(squares / static_cast<double>(wanted.size()))};
}

std::string cell(std::vector<Outcome> outcomes)
{
    double squares = 0;
    for (auto const& [runs, distance] : outcomes)
        squares += distance * distance;
    auto const n = outcomes.size();
    std::sort(outcomes.begin(), outcomes.end(), [](auto const& a, auto const& b) { return a.runs < b.runs; });
    return fmt::format("{:g} ({} to {}), {:.2g}", 0.5 * (outcomes[(n - 1) / 2].runs + outcomes[n / 2].runs),
                       outcomes.front().runs, outcomes.back().runs,
                       std::sqrt(squares / static_cast<double>(n)));
}

void main(std::vector<std::string> const& arguments)
{
    int const seeds = arguments.empty() ? 12 : std::stoi(arguments[0]);
    auto problems = stopping_problems();
    std::erase_if(problems, [&](auto const& problem) {
        return arguments.size() > 1 &&
               std::find(arguments.begin() + 1, arguments.end(), problem.name) == arguments.end();
    });
    fmt::print("| way |");
    for (auto const& problem : problems)
        fmt::print(" {} |", problem.name);
    fmt::print("\n|---|");
    for (std::size_t i = 0; i < problems.size(); ++i)
        fmt::print("---|");
    for (auto const& way : ways()) {
        fmt::print("\n| {} |", way.name());
        for (auto const& problem : problems) {
            std::vector<Outcome> outcomes;
            for (int seed = 1; seed <= seeds; ++seed)
                outcomes.push_back(outcome(problem, way, static_cast<std::uint64_t>(seed)));
            fmt::print(" {} |", cell(outcomes));
            std::fflush(stdout);
        }
    }
    fmt::print("\n");
}

} // namespace
} // namespace demens::bench

int main(int argc, char** argv)
{
    return demens::bench::with_petsc(argc, argv, [&] {
        demens::bench::main({argv + 1, argv + argc});
        return 0;
    });
}
