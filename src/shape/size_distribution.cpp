#include "demens/shape/size_distribution.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::shape {

SizeDistribution::SizeDistribution(std::vector<double> diameters,
                                   std::vector<double> cumulative_mass_fractions)
    : diameters_(std::move(diameters)), fractions_(std::move(cumulative_mass_fractions))
{
    if (diameters_.empty() || diameters_.size() != fractions_.size())
        throw InputError(
            "a size distribution needs as many cumulative mass fractions as diameters, and at least one");
    for (std::size_t i = 0; i < diameters_.size(); ++i) {
        if (!(diameters_[i] > 0) || !std::isfinite(diameters_[i]))
            throw InputError("a diameter must be positive, not " + std::to_string(diameters_[i]));
        if (i > 0 && diameters_[i] < diameters_[i - 1])
            throw InputError("the diameters must not decrease: " + std::to_string(diameters_[i]) +
                             " comes after " + std::to_string(diameters_[i - 1]));
        if (i > 0 && fractions_[i] < fractions_[i - 1])
            throw InputError(
                "the cumulative mass fractions must not decrease: " + std::to_string(fractions_[i]) +
                " comes after " + std::to_string(fractions_[i - 1]));
    }
    if (std::abs(fractions_.back() - 1.0) > 1e-9)
        throw InputError("the last cumulative mass fraction must be 1, not " +
                         std::to_string(fractions_.back()));
    if (!(fractions_.front() >= 0))
        throw InputError("the first cumulative mass fraction must be at least 0, not " +
                         std::to_string(fractions_.front()));
}

SizeDistribution SizeDistribution::from_classes(std::vector<double> const& diameters,
                                                std::vector<double> const& mass_fractions)
{
    if (diameters.empty() || diameters.size() != mass_fractions.size())
        throw InputError("size classes need as many mass fractions as diameters, and at least one");
    std::vector<double> steps, cumulative;
    double sum = 0;
    for (std::size_t i = 0; i < diameters.size(); ++i) {
        if (!(mass_fractions[i] >= 0))
            throw InputError("a mass fraction must be at least 0, not " + std::to_string(mass_fractions[i]));
        steps.insert(steps.end(), 2, diameters[i]);
        cumulative.push_back(sum);
        sum += mass_fractions[i];
        cumulative.push_back(sum);
    }
    if (std::abs(sum - 1.0) > 1e-6)
        throw InputError("the mass fractions of the size classes must sum to 1, not " + std::to_string(sum));
    cumulative.back() = 1.0;
    return {std::move(steps), std::move(cumulative)};
}

double SizeDistribution::quantile(double mass_fraction) const
{
    DEMENS_EXPECT(mass_fraction >= 0 && mass_fraction <= 1, "a fraction");
    auto const above = std::upper_bound(fractions_.begin(), fractions_.end(), mass_fraction);
    if (above == fractions_.end())
        return diameters_.back();
    if (above == fractions_.begin())
        return diameters_.front();
    auto const i = static_cast<std::size_t>(above - fractions_.begin());
    double const t = (mass_fraction - fractions_[i - 1]) / (fractions_[i] - fractions_[i - 1]);
    return diameters_[i - 1] + t * (diameters_[i] - diameters_[i - 1]);
}

double SizeDistribution::fraction_below(double diameter) const
{
    auto const above = std::upper_bound(diameters_.begin(), diameters_.end(), diameter);
    if (above == diameters_.end())
        return 1;
    if (above == diameters_.begin())
        return 0;
    auto const i = static_cast<std::size_t>(above - diameters_.begin());
    double const t = (diameter - diameters_[i - 1]) / (diameters_[i] - diameters_[i - 1]);
    return fractions_[i - 1] + t * (fractions_[i] - fractions_[i - 1]);
}

double SizeDistribution::spheres_per_volume() const
{
    // The share dF of the volume at d holds dF/(pi/6 d^3) spheres. F is linear between two points and may
    // begin with a step, so that the integral of dF/d^3 is exact.
    double sum = fractions_.front() / std::pow(diameters_.front(), 3);
    for (std::size_t i = 1; i < diameters_.size(); ++i) {
        double const a = diameters_[i - 1], b = diameters_[i];
        sum += (fractions_[i] - fractions_[i - 1]) * (a + b) / (2 * a * a * b * b);
    }
    return 6 / std::numbers::pi * sum;
}

double SizeDistribution::mean_volume_diameter() const
{
    return std::cbrt(6 / (std::numbers::pi * spheres_per_volume()));
}

SizeDistribution SizeDistribution::scaled(double factor) const
{
    auto diameters = diameters_;
    for (double& d : diameters)
        d *= factor;
    return {std::move(diameters), fractions_};
}

SizeDistribution SizeDistribution::with_class(double diameter, double mass_fraction) const
{
    if (!(mass_fraction >= 0 && mass_fraction < 1))
        throw InputError("one more class of sizes may have a mass fraction of 0 to less than 1, not " +
                         std::to_string(mass_fraction));
    double const kept = 1 - mass_fraction;
    std::vector<double> diameters, fractions;
    auto const add = [&](double d, double fraction) {
        diameters.push_back(d), fractions.push_back(fraction);
    };
    std::size_t const count = diameters_.size();
    std::size_t i = 0;
    for (; i < count && diameters_[i] <= diameter; ++i)
        add(diameters_[i], kept * fractions_[i]);
    double below = i > 0 ? fractions_[i - 1] : 0.0; // of the others
    if (i > 0 && i < count)
        below +=
            (fractions_[i] - below) * (diameter - diameters_[i - 1]) / (diameters_[i] - diameters_[i - 1]);
    add(diameter, kept * below);
    add(diameter, kept * below + mass_fraction);
    if (i == 0) // they may begin with a step
        add(diameters_[0], mass_fraction);
    for (; i < count; ++i)
        add(diameters_[i], kept * fractions_[i] + mass_fraction);
    fractions.back() = 1;
    return {std::move(diameters), std::move(fractions)};
}

std::vector<double> SizeDistribution::sample_mass(double mass, double density, RandomStream& random) const
{
    DEMENS_EXPECT(mass >= 0 && density > 0, "a mass of a material");
    // Walk along the cumulative mass curve, sphere by sphere: each sphere stands for its own stretch of the
    // curve, so that the sample follows the distribution by mass whatever the number of spheres.
    double const per_cubed = density * std::numbers::pi / 6;
    std::vector<double> sample;
    double placed = 0;
    while (placed < mass) {
        double const d_here = quantile(placed / mass);
        double const m_here = per_cubed * d_here * d_here * d_here;
        double const d = quantile(std::min(1.0, (placed + 0.5 * m_here) / mass));
        double const m = per_cubed * d * d * d;
        if (placed + 0.5 * m > mass)
            break;
        sample.push_back(d);
        placed += m;
    }
    for (std::size_t i = sample.size(); i > 1; --i)
        std::swap(sample[i - 1], sample[random.below(i)]);
    return sample;
}

} // namespace demens::shape
