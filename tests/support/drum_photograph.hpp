#pragma once

#include "demens/observe/picture/picture.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace demens::test {

//! A photograph of a drum against the light that is made from what is known: a flat surface, as a camera may
//! show it. Darkness from 0 to 1.
struct DrumPhotograph
{
    int columns = 312, rows = 308;
    observe::Circle circle{155.3, 153.8, 150}; //!< the drum's
    double angle_deg = 30;           //!< of the surface, in the picture: positive when it climbs to the right
    double height = -20;             //!< of the surface above the drum's axis, over it [pixels]
    double blur = 1.5;               //!< standard deviation of the passage from bed to light [pixels]
    double noise = 0;                //!< standard deviation
    double bed = 0.92, light = 0.05; //!< darkness
    double ring = 2, ring_darkness = 0.7; //!< width of the rim that is seen [pixels], inside the circle
    double outside = 0.03;
    //! Darkness that is added to the light at a place in radii, to the right and up.
    std::function<double(double, double)> shade = [](double, double) { return 0.0; };

    double slope() const { return std::tan(angle_deg * std::numbers::pi / 180); }
    //! Height of the surface over a place, both from the axis [pixels].
    double surface(double x) const { return height + slope() * x; }

    observe::GreyImage image() const
    {
        observe::GreyImage image(columns, rows);
        std::mt19937 random(7);
        std::normal_distribution<double> scatter(0, 1);
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                double const x = column + 0.5 - circle.x, z = circle.y - row - 0.5;
                double const above = (z - surface(x)) / std::sqrt(1 + slope() * slope());
                double const lit = 0.5 * std::erfc(-above / (std::sqrt(2.0) * blur));
                double darkness = bed + lit * (light + shade(x / circle.radius, z / circle.radius) - bed);
                double const from_rim = circle.radius - std::hypot(x, z);
                auto const share = [](double distance) { return std::clamp(distance + 0.5, 0.0, 1.0); };
                if (ring > 0)
                    darkness += (1 - share(from_rim - ring)) * std::max(0.0, ring_darkness - darkness);
                darkness += (1 - share(from_rim)) * (outside - darkness);
                image.at(column, row) =
                    static_cast<float>(std::clamp(darkness + noise * scatter(random), 0.0, 1.0));
            }
        return image;
    }
};

} // namespace demens::test
