#pragma once

#include "demens/grain/body_shape.hpp"

#include <cmath>
#include <memory>
#include <vector>

namespace demens::test {

//! Balls apart from each other, or that touch: their mass and moments are sums. The places must have their
//! centre of mass at the origin and be along principal axes.
inline std::shared_ptr<grain::BodyShape const> shape_of_apart(std::vector<grain::Ball> balls)
{
    double volume = 0; // over 4/3 pi
    for (auto const& ball : balls)
        volume += std::pow(ball.radius, 3);
    double const size = std::cbrt(volume);
    Vector3 inertia;
    for (auto& [place, radius] : balls) {
        place = place / size, radius /= size;
        double const share = std::pow(radius, 3), own = 0.4 * radius * radius;
        Vector3 const& c = place;
        inertia += share * Vector3{own + c.y * c.y + c.z * c.z, own + c.x * c.x + c.z * c.z,
                                   own + c.x * c.x + c.y * c.y};
    }
    return std::make_shared<grain::BodyShape>(grain::BodyShape{std::move(balls), inertia});
}

//! Balls of one size that touch, in a row along x.
inline std::shared_ptr<grain::BodyShape const> rod_of(int balls)
{
    std::vector<grain::Ball> row;
    for (int k = 0; k < balls; ++k)
        row.push_back({{2.0 * k - (balls - 1), 0, 0}, 1});
    return shape_of_apart(std::move(row));
}

//! Six balls on three axes, with three different moments of inertia.
inline std::shared_ptr<grain::BodyShape const> jack()
{
    return shape_of_apart({{{2, 0, 0}, 1},
                           {{-2, 0, 0}, 1},
                           {{0, 1.6, 0}, 0.7},
                           {{0, -1.6, 0}, 0.7},
                           {{0, 0, 1.4}, 0.5},
                           {{0, 0, -1.4}, 0.5}});
}

} // namespace demens::test
