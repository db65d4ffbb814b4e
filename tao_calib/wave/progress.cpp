#include "tao_calib/wave/progress.hpp"

#include <algorithm>
#include <cmath>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;
using ensemble::NamedArray;
namespace stored = ensemble::stored;

constexpr double noticed_per_target = 0.1, noticed_share = 0.02; // of chi2
constexpr double met_within = 0.1;                               // standard deviations
constexpr double moved = 0.1;                                    // of an interval's width

VectorXd target_values(Objective const& objective)
{
    VectorXd values(objective.size());
    for (int t = 0; t < values.size(); ++t)
        values[t] = objective.targets()[static_cast<std::size_t>(t)].target.value;
    return values;
}

//! Measurement and, where it is known, the scatter between runs.
VectorXd noise_of_a_run(Assessment const& assessment)
{
    VectorXd scatter = assessment.locations().replicate_sd();
    for (double& sd : scatter)
        if (!std::isfinite(sd))
            sd = 0;
    return (assessment.objective().measurement_sd().cwiseAbs2() + scatter.cwiseAbs2()).cwiseSqrt();
}

NamedArray const* interval_in(std::vector<NamedArray> const& arrays)
{
    auto const found = std::find_if(arrays.begin(), arrays.end(), [](auto const& array) {
        return array.path == std::string(stored::optimum::factor_interval.path);
    });
    return found == arrays.end() ? nullptr : &*found;
}

} // namespace

int waves_in_vain(ensemble::Campaign const& campaign, Assessment const& assessment)
{
    VectorXd const targets = target_values(assessment.objective()), noise = noise_of_a_run(assessment);
    std::vector<double> least(campaign.waves.size(), HUGE_VAL); // of the locations that are new in a wave
    for (auto const& location : assessment.locations().all())
        if (location.complete()) {
            double& wave = least[static_cast<std::size_t>(location.first_wave)];
            wave = std::min(wave, (location.responses - targets).cwiseQuotient(noise).squaredNorm());
        }
    double record = HUGE_VAL;
    int in_vain = 0;
    for (std::size_t w = 0; w < least.size(); ++w) {
        double const noticed =
            std::max(noticed_per_target * static_cast<double>(targets.size()), noticed_share * record);
        if (!std::isfinite(record) ? std::isfinite(least[w]) : least[w] < record - noticed)
            in_vain = 0;
        else if (campaign.waves[w].purpose == ensemble::WavePurpose::search)
            ++in_vain;
        record = std::min(record, least[w]);
    }
    return in_vain;
}

bool met_within_noise(Assessment const& assessment)
{
    auto const* best = assessment.locations().best();
    auto const& objective = assessment.objective();
    return best && (best->responses - target_values(objective))
                           .cwiseQuotient(objective.measurement_sd())
                           .lpNorm<Eigen::Infinity>() <= met_within;
}

bool intervals_settled(ensemble::Campaign const& campaign, std::vector<NamedArray> const& latest)
{
    auto const& waves = campaign.waves;
    if (waves.size() < 2)
        return false;
    auto const* last = interval_in(waves.back().analysis.empty() ? latest : waves.back().analysis);
    auto const* before = interval_in(waves[waves.size() - 2].analysis);
    if (!last || !before || last->data.size() != before->data.size())
        return false;
    for (std::size_t i = 0; i + 1 < last->data.size(); i += 2) {
        double const width = last->data[i + 1] - last->data[i];
        for (std::size_t end : {i, i + 1})
            if (!(std::abs(last->data[end] - before->data[end]) <= moved * width))
                return false;
    }
    return true;
}

} // namespace demens::tao_calib
