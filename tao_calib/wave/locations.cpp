#include "tao_calib/wave/locations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::tao_calib {

using Eigen::VectorXd;

Locations::Locations(Objective const& objective, UnitCube const& cube, ensemble::Campaign const& campaign)
    : Locations(objective, cube)
{
    for (auto const& wave : campaign.waves)
        if (ensemble::calibrates(wave.purpose))
            for (auto const& run : wave.runs)
                add(run);
}

Location& Locations::at(ensemble::RunRecord const& run)
{
    auto const [found, is_new] = place_.try_emplace(run.factors, locations_.size());
    if (is_new) {
        int const m = objective_->size();
        VectorXd const factors =
            Eigen::Map<VectorXd const>(run.factors.data(), static_cast<Eigen::Index>(run.factors.size()));
        locations_.push_back({factors,
                              cube_->to_unit(factors),
                              {},
                              run.wave,
                              -1,
                              VectorXd::Constant(m, std::numeric_limits<double>::quiet_NaN()),
                              VectorXd::Zero(m),
                              VectorXd::Zero(m)});
    }
    auto& location = locations_[found->second];
    if (std::find(location.points.begin(), location.points.end(), run.point) == location.points.end())
        location.points.push_back(run.point);
    return location;
}

Location const& Locations::add(ensemble::RunRecord const& run)
{
    Location& location = at(run);
    if (run.status == rig::RunStatus::not_run || run.status == rig::RunStatus::dropped)
        return location;
    if (rig::has_failed(run.status)) {
        ++failed_runs_;
        ++location.failed_runs;
        return location;
    }
    ++finished_runs_;
    ++location.finished_runs;
    if (location.first_finished_run < 0)
        location.first_finished_run = run.run;
    for (int t = 0; t < objective_->size(); ++t) {
        auto const& target = objective_->targets()[t];
        if (target.experiment != run.experiment)
            continue;
        double const value = run.responses.at(target.target.response_index);
        if (!std::isfinite(value))
            continue;
        double const before = location.runs[t] > 0 ? location.responses[t] : value;
        location.runs[t] += 1;
        location.responses[t] = before + (value - before) / location.runs[t];
        location.squared_deviations[t] += (value - before) * (value - location.responses[t]);
    }
    return location;
}

int Locations::complete() const
{
    return static_cast<int>(std::count_if(locations_.begin(), locations_.end(),
                                          [](auto const& location) { return location.complete(); }));
}

std::vector<Location const*> Locations::ranked() const
{
    std::vector<std::pair<double, Location const*>> valued;
    for (auto const& location : locations_)
        if (location.complete())
            valued.push_back({objective_->value(location.responses), &location});
    std::stable_sort(valued.begin(), valued.end(),
                     [](auto const& a, auto const& b) { return a.first < b.first; });
    std::vector<Location const*> result;
    for (auto const& [value, location] : valued)
        result.push_back(location);
    return result;
}

Location const* Locations::best() const
{
    Location const* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (auto const& location : locations_)
        if (location.complete())
            if (double const value = objective_->value(location.responses); !best || value < least)
                best = &location, least = value;
    return best;
}

std::vector<std::size_t> Locations::best_and_spread(int most) const
{
    if (complete() <= most)
        return {};
    auto const best = ranked();
    auto const half = static_cast<std::size_t>(most) / 2;
    std::vector<Location const*> taken(best.begin(), best.begin() + static_cast<std::ptrdiff_t>(half));
    std::vector<Location const*> rest(best.begin() + static_cast<std::ptrdiff_t>(half), best.end());
    auto const apart = [](Location const* a, Location const* b) { return (a->unit - b->unit).squaredNorm(); };
    std::vector<double> distances(rest.size(), std::numeric_limits<double>::infinity());
    auto count_in = [&](Location const* other) {
        for (std::size_t i = 0; i < rest.size(); ++i)
            distances[i] = std::min(distances[i], apart(rest[i], other));
    };
    for (auto const* location : taken)
        count_in(location);
    while (taken.size() < static_cast<std::size_t>(most)) {
        auto const farthest = std::max_element(distances.begin(), distances.end()) - distances.begin();
        taken.push_back(rest[static_cast<std::size_t>(farthest)]);
        count_in(taken.back());
    }
    std::vector<std::size_t> numbers;
    for (auto const* location : taken)
        numbers.push_back(static_cast<std::size_t>(location - locations_.data()));
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

Samples Locations::samples(int target, std::vector<std::size_t> const& chosen) const
{
    std::vector<Location const*> used;
    auto consider = [&](Location const& location) {
        if (location.runs[target] > 0)
            used.push_back(&location);
    };
    for (std::size_t number : chosen)
        consider(locations_[number]);
    if (chosen.empty())
        std::for_each(locations_.begin(), locations_.end(), consider);
    auto const n = static_cast<Eigen::Index>(used.size());
    Samples samples{Eigen::MatrixXd(n, cube_->size()), VectorXd(n), VectorXd(n), VectorXd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        samples.points.row(i) = used[i]->unit.transpose();
        samples.values[i] = used[i]->responses[target];
        samples.weights[i] = used[i]->runs[target];
        samples.squared_deviations[i] = used[i]->squared_deviations[target];
    }
    return samples;
}

VectorXd Locations::replicate_sd() const
{
    VectorXd squares = VectorXd::Zero(objective_->size()), degrees = squares;
    for (auto const& location : locations_)
        for (int t = 0; t < objective_->size(); ++t)
            if (location.runs[t] > 1) {
                squares[t] += location.squared_deviations[t];
                degrees[t] += location.runs[t] - 1;
            }
    return squares.cwiseQuotient(degrees).cwiseSqrt(); // 0/0 is NaN: not known
}

} // namespace demens::tao_calib
