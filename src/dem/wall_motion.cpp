#include "demens/dem/wall_motion.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::dem {
namespace {

//! Displacement of an oscillation since its start, and its rate of change.
struct Oscillation
{
    double displacement, rate;
};
Oscillation oscillation(double frequency, double phase, double since)
{
    double const angular = 2 * std::numbers::pi * frequency;
    return {std::sin(angular * since + phase) - std::sin(phase), angular * std::cos(angular * since + phase)};
}

//! Placement some time after the start of a motion.
struct PlacementAfter
{
    double since;

    Placement operator()(Translate const& m) const { return {{}, since * m.velocity}; }
    Placement operator()(Rotate const& m) const { return turn_about(m.point, m.axis, since * m.rate); }
    Placement operator()(Shake const& m) const
    {
        return {{}, oscillation(m.frequency, m.phase, since).displacement * m.amplitude};
    }
    Placement operator()(Swing const& m) const
    {
        return turn_about(m.point, m.axis,
                          m.amplitude * oscillation(m.frequency, m.phase, since).displacement);
    }
    Placement operator()(Convey const&) const { return {}; }
};

//! Velocities of a rigid body: of its point at the origin, and its spin.
struct Twist
{
    Vector3 at_origin, spin;
};

Twist about_line(Vector3 const& point, Vector3 const& axis, double rate)
{
    return {-rate * cross(axis, point), rate * axis};
}

struct TwistAfter
{
    double since;

    Twist operator()(Translate const& m) const { return {m.velocity, {}}; }
    Twist operator()(Rotate const& m) const { return about_line(m.point, m.axis, m.rate); }
    Twist operator()(Shake const& m) const
    {
        return {oscillation(m.frequency, m.phase, since).rate * m.amplitude, {}};
    }
    Twist operator()(Swing const& m) const
    {
        return about_line(m.point, m.axis, m.amplitude * oscillation(m.frequency, m.phase, since).rate);
    }
    Twist operator()(Convey const&) const { return {}; }
};

double time_into(WallMotion const& motion, double time)
{
    return std::clamp(time, motion.start, motion.end) - motion.start;
}

void normalise(Vector3& axis)
{
    double const length = norm(axis);
    if (!(length > 0))
        throw InputError("the axis of a wall's motion has no length; give a direction, e.g. 0, 1, 0");
    axis = axis / length;
}

//! Whether the line of a motion is the axis of the shape.
bool is_own_axis(WallShape const& shape, Vector3 const& point, Vector3 const& axis)
{
    Vector3 const arm = point - centre(shape);
    Vector3 const beside = arm - dot(arm, axis) * axis;
    return displacing_spin(shape, axis) == Vector3{} &&
           norm_squared(beside) <= 1e-24 * (norm_squared(arm) + extent(shape) * extent(shape));
}

bool maps_onto_itself(WallShape const& shape, WallMotion const& motion)
{
    return std::visit(
        [&]<class Law>(Law const& law) {
            if constexpr (requires { law.axis; })
                return is_own_axis(shape, law.point, law.axis);
            else
                return std::is_same_v<Law, Convey>;
        },
        motion.law);
}

} // namespace

MovedWall::MovedWall(Wall const& at_first, std::vector<WallMotion> motions, double now)
    : parts_{at_first.shape, at_first.pivot, std::move(motions)}
{
    for (WallMotion& motion : parts_.motions) {
        if (!(motion.end >= motion.start))
            throw InputError(fmt::format("a wall's motion ends at {} s, before its start at {} s", motion.end,
                                         motion.start));
        std::visit(
            []<class Law>(Law& law) {
                if constexpr (requires { law.axis; })
                    normalise(law.axis);
                if constexpr (requires { law.frequency; })
                    if (!(law.frequency >= 0))
                        throw InputError(fmt::format(
                            "frequency {} Hz of a wall's motion must not be negative", law.frequency));
            },
            motion.law);
        motion.start = std::max(motion.start, now);
        motion.end = std::max(motion.end, now);
    }
    auto& spinning = parts_.spinning;
    while (spinning < parts_.motions.size() && maps_onto_itself(parts_.shape, parts_.motions[spinning]))
        ++spinning;
}

void MovedWall::move(Wall& wall, double time, double velocity_time) const
{
    auto const& [shape, pivot, motions, spinning] = parts_;
    DEMENS_EXPECT(spinning <= motions.size(), "so many of the first motions");
    Placement place;
    Twist total{};
    Vector3 belt;
    for (std::size_t k = 0; k < motions.size(); ++k) {
        WallMotion const& motion = motions[k];
        if (k >= spinning)
            place = std::visit(PlacementAfter{time_into(motion, time)}, motion.law) * place;
        // What the motions before have given turns along with this one.
        double const since = time_into(motion, velocity_time);
        Placement const outer = std::visit(PlacementAfter{since}, motion.law);
        total.spin = outer.rotation(total.spin);
        total.at_origin = outer.rotation(total.at_origin) - cross(total.spin, outer.shift);
        if (velocity_time < motion.start || velocity_time > motion.end)
            continue;
        Twist const added = std::visit(TwistAfter{since}, motion.law);
        total.at_origin += added.at_origin;
        total.spin += added.spin;
        if (auto const* convey = std::get_if<Convey>(&motion.law))
            belt += convey->velocity;
    }
    wall.shape = spinning < motions.size() ? placed(shape, place) : shape;
    wall.pivot = place(pivot);
    wall.velocity = total.at_origin + cross(total.spin, wall.pivot);
    wall.spin = total.spin;
    wall.belt = belt;
}

} // namespace demens::dem
