#include "ensemble/fit_quality.hpp"

#include "ensemble/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::ensemble {
namespace {

//! First number of an array; NaN where there is none.
double number_in(Wave const& wave, stored::ArrayName const& name)
{
    auto const* array = wave.find(name);
    return array && !array->data.empty() ? array->data.front() : std::numeric_limits<double>::quiet_NaN();
}

std::string known(double value, int digits)
{
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "not known";
}

std::vector<Target> all_targets(CampaignInput const& input)
{
    std::vector<Target> all;
    for (auto const& experiment : input.experiments)
        all.insert(all.end(), experiment.targets.begin(), experiment.targets.end());
    return all;
}

} // namespace

FitQuality fit_quality(CampaignInput const& input, std::vector<double> const& responses)
{
    auto const targets = all_targets(input);
    bool const by_tolerance = std::none_of(targets.begin(), targets.end(), [](Target const& target) {
        return std::isnan(target.tolerance) || target.tolerance == 0;
    });
    FitQuality quality{.yardstick = by_tolerance ? Yardstick::tolerance : Yardstick::scale};
    std::size_t t = 0;
    double sum = 0;
    for (auto const& experiment : input.experiments)
        for (auto const& target : experiment.targets) {
            double const deviation = std::abs(responses.at(t++) - target.value),
                         units = deviation / (by_tolerance ? target.tolerance : target.scale);
            sum += deviation * deviation / (target.scale * target.scale);
            if (quality.worst.empty() || units > quality.largest) {
                quality.largest = units;
                quality.worst = experiment.name + "." + target.response;
            }
        }
    quality.targets = static_cast<int>(t);
    quality.root_mean_square = t > 0 ? std::sqrt(sum / static_cast<double>(t)) : 0;
    return quality;
}

std::string headline(FitQuality const& quality)
{
    auto const unit = quality.yardstick == Yardstick::tolerance ? "tolerance" : "scale";
    // Rounded up, so that it stays true.
    auto const up = [](double value) {
        double const digit = std::pow(10.0, std::max(-2.0, std::floor(std::log10(value)) - 1));
        return digit * std::ceil(value / digit * (1 - 1e-9));
    };
    if (quality.largest <= 1)
        return quality.largest < 0.01 ? fmt::format("within a hundredth of a {} of {}", unit,
                                                    quality.targets == 1 ? "the target" : "all targets")
                                      : fmt::format("within {:.2g} {}s of {}", up(quality.largest), unit,
                                                    quality.targets == 1 ? "the target" : "all targets");
    return fmt::format("up to {:.3g} {}s off the target{}: {}", quality.largest, unit,
                       quality.targets == 1 ? "" : "s", quality.worst);
}

double noise_inflation(Wave const& wave)
{
    double const inflation = number_in(wave, stored::optimum::noise_inflation);
    return inflation > 1 ? inflation : 1;
}

std::string targets_text(Wave const& wave)
{
    if (!wave.find(stored::optimum::p_value))
        return {};
    auto const* estimate = wave.find(stored::optimum::estimate);
    if (estimate && std::any_of(estimate->data.begin(), estimate->data.end(),
                                [](double value) { return std::isnan(value); }))
        return "whether the targets can be met is not known: the surrogates come nearest to them where no "
               "run supports it";
    double const p = number_in(wave, stored::optimum::p_value);
    return fmt::format("the targets {} together, chi2 {} on {:g} degrees of freedom, p {}",
                       misses_targets(p) ? "cannot be met" : "can be met",
                       known(number_in(wave, stored::optimum::least_misfit), 4),
                       number_in(wave, stored::optimum::degrees), known(p, 2));
}

} // namespace demens::ensemble
