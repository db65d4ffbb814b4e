#include "demens/grain/grains.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "demens/shape/sample_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::grain {
namespace {

std::vector<shape::Sphere> outline_of(GrainShape const& shape)
{
    if (!shape.shape)
        return {{{}, 1}};
    if (shape.is_hull())
        return {{{}, shape.shape->reach()}};
    std::vector<shape::Sphere> outline;
    for (Ball const& ball : shape.shape->balls)
        outline.push_back({ball.place, ball.radius});
    return outline;
}

//! The grains of several kinds one after another, shuffled where there are several.
template <class SampleKind>
std::vector<Grain> joined(std::size_t kinds, RandomStream& random, SampleKind const& sample)
{
    std::vector<Grain> grains;
    for (std::uint32_t k = 0; k < kinds; ++k)
        for (double const diameter : sample(k))
            grains.push_back({diameter, k});
    if (kinds > 1)
        for (std::size_t i = grains.size(); i > 1; --i)
            std::swap(grains[i - 1], grains[random.below(i)]);
    return grains;
}

} // namespace

GrainShape grain_shape(std::string name, std::span<Ball const> clump, SizeMeasure measured)
{
    auto const shape = std::make_shared<BodyShape const>(body_shape(clump, name));
    if (shape->is_sphere())
        return {std::move(name), nullptr, 1};
    auto const properties = mass_properties(clump);
    double const size = measured == SizeMeasure::equivalent ? properties.equivalent_diameter()
                                                            : size_by(measured, properties, sizes(clump));
    return {std::move(name), shape, properties.equivalent_diameter() / size};
}

GrainShape grain_shape(std::string name, RoundedHull const& hull, SizeMeasure measured)
{
    auto const shape = std::make_shared<BodyShape const>(body_shape(hull, name));
    auto const properties = mass_properties(hull);
    double const size = size_by(measured, properties, sizes(corner_balls(hull)));
    return {std::move(name), shape, properties.equivalent_diameter() / size};
}

Grains::Grains(shape::SizeDistribution const& sizes) : Grains(sizes, {{{"sphere", nullptr, 1}}, {1}}) {}

Grains::Grains(shape::SizeDistribution const& sizes, ShapeMixture mixture)
{
    auto& shapes = mixture.shapes;
    auto const& shares = mixture.shares;
    auto const share_of = mixture.share_of;
    if (shapes.empty() || shapes.size() != shares.size())
        throw InputError(
            fmt::format("{} shapes need as many shares, and there are {}", shapes.size(), shares.size()));
    double sum = 0, weights = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        if (!(shares[k] > 0))
            throw InputError(fmt::format("the share of the shape {} must be greater than 0, not {}",
                                         shapes[k].name, shares[k]));
        sum += shares[k];
    }
    if (std::abs(sum - 1) > 1e-6)
        throw InputError(fmt::format("the shares of the shapes must sum to 1, not {}", sum));
    // Grains of one size have volumes as the cubes of their equivalent diameters.
    auto const weight = [&](std::size_t k) {
        return share_of == ShareOf::mass ? shares[k] : shares[k] * std::pow(shapes[k].equivalent_per_size, 3);
    };
    for (std::size_t k = 0; k < shares.size(); ++k)
        weights += weight(k);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        double const factor = shapes[k].equivalent_per_size;
        auto outline = outline_of(shapes[k]);
        kinds_.push_back({std::move(shapes[k]), shares.size() > 1 ? weight(k) / weights : 1.0,
                          factor == 1 ? sizes : sizes.scaled(factor), std::move(outline)});
    }
}

bool Grains::are_spheres() const
{
    return std::all_of(kinds_.begin(), kinds_.end(), [](Kind const& k) { return k.shape.is_sphere(); });
}

bool Grains::have_hulls() const
{
    return std::any_of(kinds_.begin(), kinds_.end(), [](Kind const& k) { return k.shape.is_hull(); });
}

double Grains::smallest() const
{
    double diameter = kinds_.front().sizes.smallest();
    for (Kind const& kind : kinds_)
        diameter = std::min(diameter, kind.sizes.smallest());
    return diameter;
}

double Grains::largest() const
{
    double diameter = 0;
    for (Kind const& kind : kinds_)
        diameter = std::max(diameter, kind.sizes.largest());
    return diameter;
}

double Grains::quantile(double mass_fraction) const
{
    if (kinds_.size() == 1)
        return kinds_.front().sizes.quantile(mass_fraction);
    auto const below = [&](double diameter) { // share of the mass
        double sum = 0;
        for (Kind const& kind : kinds_)
            sum += kind.share * kind.sizes.fraction_below(diameter);
        return sum;
    };
    double lower = smallest(), upper = largest();
    for (int k = 0; k < 60; ++k) {
        double const middle = 0.5 * (lower + upper);
        (below(middle) < mass_fraction ? lower : upper) = middle;
    }
    return upper;
}

double Grains::per_volume() const
{
    double sum = 0;
    for (Kind const& kind : kinds_)
        sum += kind.share * kind.sizes.spheres_per_volume();
    return sum;
}

double Grains::balls_per_volume() const
{
    double sum = 0;
    for (Kind const& kind : kinds_)
        sum += kind.share * kind.sizes.spheres_per_volume() * static_cast<double>(kind.outline.size());
    return sum;
}

double Grains::mean_volume_diameter() const
{
    return std::cbrt(6 / (std::numbers::pi * per_volume()));
}

double Grains::smallest_ball() const
{
    double diameter = smallest();
    for (Kind const& kind : kinds_)
        diameter = std::min(diameter, kind.shape.smallest_ball() * kind.sizes.smallest());
    return diameter;
}

double Grains::widest() const
{
    double diameter = 0;
    for (Kind const& kind : kinds_)
        diameter = std::max(diameter, kind.shape.reach() * kind.sizes.largest());
    return diameter;
}

double Grains::looseness() const
{
    double sum = 0;
    for (Kind const& kind : kinds_) {
        double const reach = kind.shape.reach();
        sum += kind.share / (kind.shape.is_hull() ? reach * reach * reach : reach);
    }
    return sum;
}

double Grains::work_per_grain() const
{
    double work = 0, number = 0;
    for (Kind const& kind : kinds_) {
        double const of_kind = kind.share * kind.sizes.spheres_per_volume();
        number += of_kind;
        work += of_kind * step_work(kind.shape.shape.get());
    }
    return work / number;
}

std::vector<Grain> Grains::sample_mass(double mass, double density, RandomStream& random) const
{
    return joined(kinds_.size(), random, [&](std::uint32_t k) {
        return kinds_[k].sizes.sample_mass(kinds_[k].share * mass, density, random);
    });
}

std::vector<Grain> Grains::sample_whole(double mass, double density, RandomStream& random) const
{
    return joined(kinds_.size(), random, [&](std::uint32_t k) {
        try {
            return shape::sample_whole(kinds_[k].sizes, kinds_[k].share * mass, density, random);
        } catch (InputError const& error) {
            if (are_spheres())
                throw;
            throw InputError(fmt::format("{} (diameters of spheres of the same volume; shape {})",
                                         error.what(), kinds_[k].shape.name));
        }
    });
}

std::string Grains::sample_warning(double mass, double density) const
{
    std::string all;
    for (Kind const& kind : kinds_) {
        auto const warning = shape::sample_warning(kind.sizes, kind.share * mass, density);
        if (!warning.empty())
            all += (all.empty() ? "" : "; ") +
                   (are_spheres() ? warning : fmt::format("{} (shape {})", warning, kind.shape.name));
    }
    return all;
}

std::vector<shape::SphereGroup> Grains::outlines(std::vector<Grain> const& grains) const
{
    std::vector<shape::SphereGroup> groups;
    groups.reserve(grains.size());
    for (Grain const& grain : grains)
        groups.push_back({kinds_[grain.kind].outline, 0.5 * grain.diameter});
    return groups;
}

} // namespace demens::grain
