#include "src/dem/cpu/hulls/flat_seams.hpp"

#include <cmath>
#include <type_traits>

namespace demens::dem {

template <class Shape>
std::optional<FlatSeams::Flat> FlatSeams::flat_of(Shape const& shape)
{
    if constexpr (std::is_same_v<Shape, Rectangle>)
        return Flat{shape.centre, shape.axis_u, shape.axis_v, cross(shape.axis_u, shape.axis_v),
                    shape.half_u, shape.half_v};
    else if constexpr (std::is_same_v<Shape, Disc>)
        return Flat{shape.centre, {}, {}, shape.axis, shape.radius, -1};
    else
        return {};
}

bool FlatSeams::Flat::covers(Vector3 const& place, double tolerance) const
{
    Vector3 const from = place - centre;
    if (half_v < 0) {
        double const height = dot(from, across), reach = half_u + tolerance;
        return norm_squared(from) - height * height <= reach * reach;
    }
    return std::abs(dot(from, axis_u)) <= half_u + tolerance &&
           std::abs(dot(from, axis_v)) <= half_v + tolerance;
}

void FlatSeams::begin(double rounding)
{
    walls_.clear();
    rounding_ = rounding;
    tolerance_ = 1e-4 * rounding;
}

void FlatSeams::add(WallShape const& shape)
{
    walls_.push_back(std::visit([](auto const& of) { return flat_of(of); }, shape));
}

bool FlatSeams::are_of_one_plane(std::size_t a, std::size_t b) const
{
    auto const &one = walls_[a], &other = walls_[b];
    return one && other && std::abs(dot(one->across, other->across)) > 1 - 1e-9 &&
           std::abs(dot(other->centre - one->centre, one->across)) < tolerance_;
}

bool FlatSeams::is_of_another(std::size_t wall, grain::FeatureContact const& contact) const
{
    if (!walls_[wall])
        return false;
    constexpr std::uint32_t kind = 24; // its bits, see grain::feature_id
    bool const is_vertex =
        contact.feature >> kind == static_cast<std::uint32_t>(grain::ContactFeature::vertex_of_a);
    // A vertex above the inside of the wall is one of it, unless the first of both has it.
    Vector3 const& across = walls_[wall]->across;
    Vector3 const aside = contact.normal - dot(contact.normal, across) * across;
    bool const is_inside = is_vertex && (rounding_ - contact.overlap) * norm(aside) <= tolerance_;
    Vector3 const place = contact.point - 0.5 * contact.overlap * contact.normal;
    std::size_t const others = is_inside ? wall : walls_.size();
    for (std::size_t k = 0; k < others; ++k)
        if (k != wall && are_of_one_plane(wall, k) && walls_[k]->covers(place, tolerance_))
            return true;
    return false;
}

} // namespace demens::dem
