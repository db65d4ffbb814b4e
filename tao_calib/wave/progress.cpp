#include "tao_calib/wave/progress.hpp"

#include <algorithm>
#include <cmath>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;
using ensemble::NamedArray;
namespace stored = ensemble::stored;

constexpr double noticed_per_target = 0.1, noticed_share = 0.02; // of chi2
constexpr double met_within = 0.1;                               // standard deviations of the measurement
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

NamedArray const* find_in(std::vector<NamedArray> const& arrays, stored::ArrayName const& name)
{
    auto const found = std::find_if(arrays.begin(), arrays.end(),
                                    [&](auto const& array) { return array.path == std::string(name.path); });
    return found == arrays.end() ? nullptr : &*found;
}

//! Waves whose results are there; the last one may be on its way.
std::size_t known_waves(ensemble::Campaign const& campaign)
{
    auto const& waves = campaign.waves;
    return waves.size() - (waves.empty() || ensemble::is_complete(waves.back()) ? 0 : 1);
}

std::vector<NamedArray> const& last_analysis(ensemble::Campaign const& campaign,
                                             std::vector<NamedArray> const& latest)
{
    auto const& stored = campaign.waves.at(known_waves(campaign) - 1).analysis;
    return stored.empty() ? latest : stored;
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
    for (std::size_t w = 0; w < known_waves(campaign); ++w) {
        double const noticed =
            std::max(noticed_per_target * static_cast<double>(targets.size()), noticed_share * record);
        if (!std::isfinite(record) ? std::isfinite(least[w]) : least[w] < record - noticed)
            in_vain = 0;
        else if (campaign.waves[w].purpose == ensemble::WavePurpose::search &&
                 campaign.waves[w].number >= campaign.first_counted_wave())
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

bool best_is_as_good_as_can_be(ensemble::Campaign const& campaign, Assessment const& assessment,
                               std::vector<NamedArray> const& latest)
{
    auto const& analysis = last_analysis(campaign, latest);
    auto const* estimated = find_in(analysis, stored::optimum::estimate_responses);
    auto const* estimated_sd = find_in(analysis, stored::optimum::estimate_sd);
    auto const* best = assessment.locations().best();
    Eigen::Index const m = assessment.objective().size();
    if (!best || !estimated || !estimated_sd)
        return false;
    auto const responses = VectorXd::Map(estimated->data.data(), m),
               sd = VectorXd::Map(estimated_sd->data.data(), m);
    VectorXd const measured = assessment.objective().measurement_sd(),
                   targets = target_values(assessment.objective());
    auto chi_square = [&](VectorXd const& deviations) {
        return deviations.cwiseQuotient(measured).squaredNorm();
    };
    double const noticed = met_within * met_within * static_cast<double>(m);
    bool const gains_nothing =
        chi_square(best->responses - targets) <= chi_square(responses - targets) + noticed;
    bool const is_the_optimum =
        chi_square(best->responses - assessment.predict(assessment.minima().front().point)) <= noticed;
    bool const predictions_are_sure =
        (sd.array() <= met_within * measured.array()).all(); // not where sd is NaN
    return (gains_nothing || is_the_optimum) && predictions_are_sure;
}

bool intervals_settled(ensemble::Campaign const& campaign, std::vector<NamedArray> const& latest)
{
    auto const known = known_waves(campaign);
    if (known < 2)
        return false;
    auto const* last = find_in(last_analysis(campaign, latest), stored::optimum::factor_interval);
    auto const* before = find_in(campaign.waves[known - 2].analysis, stored::optimum::factor_interval);
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
