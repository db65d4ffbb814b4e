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
        for (auto const& run : wave.runs)
            add(run);
}

Location& Locations::at(ensemble::RunRecord const& run)
{
    VectorXd const factors =
        Eigen::Map<VectorXd const>(run.factors.data(), static_cast<Eigen::Index>(run.factors.size()));
    auto found = std::find_if(locations_.begin(), locations_.end(),
                              [&](auto const& location) { return location.factors == factors; });
    if (found == locations_.end()) {
        int const m = objective_->size();
        locations_.push_back({factors,
                              cube_->to_unit(factors),
                              {},
                              run.wave,
                              -1,
                              VectorXd::Constant(m, std::numeric_limits<double>::quiet_NaN()),
                              VectorXd::Zero(m),
                              VectorXd::Zero(m)});
        found = locations_.end() - 1;
    }
    if (std::find(found->points.begin(), found->points.end(), run.point) == found->points.end())
        found->points.push_back(run.point);
    return *found;
}

void Locations::add(ensemble::RunRecord const& run)
{
    Location& location = at(run);
    if (run.status == rig::RunStatus::not_run)
        return;
    if (run.status != rig::RunStatus::finished) {
        ++failed_runs_;
        ++location.failed_runs;
        return;
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
}

int Locations::complete() const
{
    return static_cast<int>(std::count_if(locations_.begin(), locations_.end(),
                                          [](auto const& location) { return location.complete(); }));
}

std::vector<Location const*> Locations::ranked() const
{
    std::vector<Location const*> result;
    for (auto const& location : locations_)
        if (location.complete())
            result.push_back(&location);
    std::stable_sort(result.begin(), result.end(), [&](auto const* a, auto const* b) {
        return objective_->value(a->responses) < objective_->value(b->responses);
    });
    return result;
}

Location const* Locations::best() const
{
    Location const* best = nullptr;
    for (auto const& location : locations_)
        if (location.complete() &&
            (!best || objective_->value(location.responses) < objective_->value(best->responses)))
            best = &location;
    return best;
}

Samples Locations::samples(int target) const
{
    std::vector<Location const*> used;
    for (auto const& location : locations_)
        if (location.runs[target] > 0)
            used.push_back(&location);
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
