#include "demens/dem/wall.hpp"

namespace demens::dem {

std::array<Rectangle, 6> box_sides(Vector3 const& lower, Vector3 const& upper)
{
    Vector3 const middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
    Vector3 const x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    return {{{{lower.x, middle.y, middle.z}, y, z, half.y, half.z},
             {{upper.x, middle.y, middle.z}, y, z, half.y, half.z},
             {{middle.x, lower.y, middle.z}, z, x, half.z, half.x},
             {{middle.x, upper.y, middle.z}, z, x, half.z, half.x},
             {{middle.x, middle.y, lower.z}, x, y, half.x, half.y},
             {{middle.x, middle.y, upper.z}, x, y, half.x, half.y}}};
}

namespace {

//! Puts the numbers of a shape elsewhere.
struct Placer
{
    Placement const& to;

    void point(Vector3& p) const { p = to(p); }
    void direction(Vector3& v) const { v = to.rotation(v); }
    void placement(Placement& p) const { p = to * p; }
    void number(double const&) const {}
    void side(RoundSide const&) const {}
};

template <class Shape>
Vector3 centre_of(Shape const& shape)
{
    return shape.centre;
}
Vector3 centre_of(Mesh const& mesh)
{
    return mesh.placement(mesh.mesh->centre());
}

} // namespace

double extent(WallShape const& shape)
{
    return std::visit([](auto const& s) { return extent(s); }, shape);
}

WallShape placed(WallShape const& shape, Placement const& placement)
{
    WallShape result = shape;
    std::visit([&](auto& s) { fields(s, Placer{placement}); }, result);
    return result;
}

Vector3 centre(WallShape const& shape)
{
    return std::visit([](auto const& s) { return centre_of(s); }, shape);
}

Vector3 displacing_spin(WallShape const& shape, Vector3 const& spin)
{
    return std::visit(
        [&]<class Shape>(Shape const& s) {
            if constexpr (RoundShape<Shape>) {
                Vector3 const across = spin - dot(spin, s.axis) * s.axis;
                // What is left of a spin along a tilted axis is rounding.
                return norm_squared(across) > 1e-24 * norm_squared(spin) ? across : Vector3{};
            } else {
                return spin;
            }
        },
        shape);
}

double displacement_speed(Wall const& wall)
{
    double const size = extent(wall.shape), turning = norm(wall.spin);
    Vector3 const arm = centre(wall.shape) - wall.pivot;
    double const of_centre = norm(wall.velocity + cross(wall.spin, arm));
    double const rounding = 1e-12 * (norm(wall.velocity) + turning * (norm(arm) + size));
    double const speed = of_centre + norm(displacing_spin(wall.shape, wall.spin)) * size;
    return speed > rounding ? speed : 0;
}

void advance(Wall& wall, double duration)
{
    if (displacement_speed(wall) > 0) {
        Vector3 const shift = duration * wall.velocity;
        double const rate = norm(wall.spin);
        Placement to{{}, shift};
        if (rate > 0)
            to = to * turn_about(wall.pivot, wall.spin / rate, duration * rate);
        wall.shape = placed(wall.shape, to);
    }
    wall.pivot += duration * wall.velocity;
}

} // namespace demens::dem
