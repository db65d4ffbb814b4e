#include "tao_calib/wave/completing_waves.hpp"

#include "tao_calib/design/design.hpp"
#include "tao_calib/wave/plan.hpp"
#include "tao_calib/wave/simulated_extent.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;
using ensemble::Campaign, ensemble::WavePlan, ensemble::WavePurpose;

//! Locations at which something was simulated or is planned, and experiments that were there.
struct Kept
{
    explicit Kept(Campaign const& campaign, UnitCube const& cube)
    {
        std::set<std::vector<double>> seen;
        for (auto const& wave : campaign.waves)
            if (calibrates(wave.purpose))
                for (auto const& run : wave.runs) {
                    experiments.insert(run.experiment);
                    if (seen.insert(run.factors).second) {
                        points.push_back(run.factors);
                        units.push_back(cube.to_unit(VectorXd::Map(
                            run.factors.data(), static_cast<Eigen::Index>(run.factors.size()))));
                    }
                }
    }

    std::vector<std::vector<double>> points; //!< own units
    std::vector<VectorXd> units;             //!< of them
    std::set<int> experiments;
};

//! So many points, each as far as can be from those before it; the first one is the first.
std::vector<std::vector<double>> spread(Kept const& kept, std::size_t count)
{
    std::vector<double> distances(kept.units.size(), std::numeric_limits<double>::infinity());
    std::vector<std::vector<double>> chosen;
    for (std::size_t next = 0; chosen.size() < std::min(count, kept.points.size());
         next = static_cast<std::size_t>(std::max_element(distances.begin(), distances.end()) -
                                         distances.begin())) {
        chosen.push_back(kept.points[next]);
        for (std::size_t i = 0; i < distances.size(); ++i)
            distances[i] = std::min(distances[i], (kept.units[i] - kept.units[next]).norm());
    }
    return chosen;
}

//! Fitted experiments that have no runs.
std::vector<int> missing_experiments(Campaign const& campaign, Kept const& kept)
{
    std::vector<int> missing;
    for (int e = 0; e < static_cast<int>(campaign.input.experiments.size()); ++e)
        if (campaign.input.experiments[static_cast<std::size_t>(e)].role ==
                ensemble::ExperimentRole::calibrate &&
            !kept.experiments.contains(e))
            missing.push_back(e);
    return missing;
}

std::vector<std::vector<double>> rows_of(Eigen::MatrixXd const& points)
{
    std::vector<std::vector<double>> rows;
    for (VectorXd const row : points.rowwise())
        rows.emplace_back(row.begin(), row.end());
    return rows;
}

} // namespace

std::vector<WavePlan> completing_waves(Campaign const& campaign,
                                       std::vector<std::vector<double>> const& starts)
{
    auto const& input = campaign.input;
    UnitCube const cube(input.factors, input.constraints);
    Kept const kept(campaign, cube);
    if (kept.points.empty()) {
        auto const first = first_wave(input);
        auto points = first.points;
        points.insert(points.end(), starts.begin(), starts.end());
        return {{.purpose = first.purpose, .points = std::move(points)}};
    }
    auto const design = rows_of(make_design(input.design, input.factors, input.constraints, input.seed));
    std::vector<WavePlan> waves;
    if (auto missing = missing_experiments(campaign, kept); !missing.empty())
        waves.push_back({.purpose = WavePurpose::design,
                         .points = spread(kept, design.size()),
                         .experiments = std::move(missing)});
    SimulatedExtent const extent(cube, kept.units);
    std::vector<std::vector<double>> beyond;
    for (auto const& point : design)
        if (!extent.holds(cube.to_unit(VectorXd::Map(point.data(), static_cast<Eigen::Index>(point.size())))))
            beyond.push_back(point);
    if (!beyond.empty())
        waves.push_back({.purpose = WavePurpose::design, .points = std::move(beyond)});
    return waves;
}

} // namespace demens::tao_calib
