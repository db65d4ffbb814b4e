#include "gap/campaign/simulated_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::gap {
namespace {

using ensemble::RunRecord;

//! Whether two numbers are one, but for the last bits of mathematical functions on different machines.
bool same(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b));
}

//! The effect that acts in a run; waves of the diagnosis let one act at a time.
std::pair<std::string, double> acting(RunRecord const& run)
{
    for (std::size_t k = 0; k < run.amplitudes.size(); ++k)
        if (run.amplitudes[k] != 0)
            return {run.effects->at(k).name, run.amplitudes[k]};
    return {"", 0.0};
}

} // namespace

double SimulatedPoint::mean(int experiment, int response) const
{
    auto const& of = runs[static_cast<std::size_t>(experiment)];
    if (of.empty())
        return std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    for (auto const& responses : of)
        sum += responses[response];
    return sum / static_cast<double>(of.size());
}

std::vector<SimulatedPoint> simulated_points(ensemble::Campaign const& campaign,
                                             ensemble::WavePurpose purpose)
{
    std::vector<SimulatedPoint> points;
    for (auto const& wave : campaign.waves) {
        if (wave.purpose != purpose)
            continue;
        for (auto const& run : wave.runs) {
            auto const [effect, amplitude] = acting(run);
            auto const* known = find_point(points, run.factors, effect, amplitude);
            auto const place = known ? static_cast<std::size_t>(known - points.data()) : points.size();
            if (!known) {
                points.push_back({run.factors, effect, amplitude, {}, {}});
                points.back().runs.resize(campaign.input.experiments.size());
            }
            auto& point = points[place];
            if (run.status == rig::RunStatus::finished)
                point.runs[static_cast<std::size_t>(run.experiment)].push_back(
                    Eigen::Map<Eigen::VectorXd const>(run.responses.data(),
                                                      static_cast<Eigen::Index>(run.responses.size())));
            else if (rig::has_failed(run.status) && point.failure.empty())
                point.failure =
                    fmt::format("run {} of {}: {}{}{}", run.run,
                                campaign.input.experiments[static_cast<std::size_t>(run.experiment)].name,
                                rig::name_of(run.status), run.reason.empty() ? "" : ", ", run.reason);
        }
    }
    return points;
}

std::vector<SimulatedRun> simulated_runs(ensemble::Campaign const& campaign)
{
    std::vector<SimulatedRun> runs;
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs) {
            if (run.status != rig::RunStatus::finished)
                continue;
            ensemble::Effect const* effect = nullptr;
            double amplitude = 0;
            int acting = 0;
            for (std::size_t k = 0; k < run.amplitudes.size(); ++k)
                if (run.amplitudes[k] != 0) {
                    effect = &run.effects->at(k);
                    amplitude = run.amplitudes[k];
                    ++acting;
                }
            if (acting <= 1)
                runs.push_back({run.factors, effect, amplitude, run.experiment, &run.responses});
        }
    return runs;
}

bool has_bank(ensemble::Campaign const& campaign)
{
    return std::any_of(campaign.waves.begin(), campaign.waves.end(),
                       [](auto const& wave) { return !wave.taken_from.empty(); });
}

bool is_at(SimulatedPoint const& point, std::vector<double> const& factors)
{
    return std::equal(factors.begin(), factors.end(), point.factors.begin(), point.factors.end(), same);
}

SimulatedPoint const* find_point(std::vector<SimulatedPoint> const& points,
                                 std::vector<double> const& factors, std::string const& effect,
                                 double amplitude)
{
    auto const found = std::find_if(points.begin(), points.end(), [&](auto const& point) {
        return point.effect == effect && same(point.amplitude, amplitude) && is_at(point, factors);
    });
    return found == points.end() ? nullptr : &*found;
}

} // namespace demens::gap
