#include "demens/grain/sizes.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace demens::grain {
namespace {

//! Distance of the two planes across a unit vector that touch the balls [m].
double width(std::span<Ball const> balls, Vector3 const& along)
{
    double upper = -std::numeric_limits<double>::infinity(), lower = -upper;
    for (Ball const& ball : balls) {
        double const at = dot(ball.place, along);
        upper = std::max(upper, at + ball.radius);
        lower = std::min(lower, at - ball.radius);
    }
    return upper - lower;
}

//! Radius of the smallest circle around circles, seen along z: the centre goes towards the farthest one, less
//! each time (Badoiu & Clarkson 2003), which comes near; then it slides downhill.
double enclosing_diameter(std::span<Ball const> balls, Rotation const& axes)
{
    std::vector<Vector3> circles;
    Vector3 centre;
    for (Ball const& ball : balls) {
        circles.push_back({dot(ball.place, axes.x), dot(ball.place, axes.y), ball.radius});
        centre += circles.back() / static_cast<double>(balls.size());
    }
    auto const reach = [&](double x, double y) {
        double most = 0;
        for (Vector3 const& c : circles)
            most = std::max(most, std::hypot(c.x - x, c.y - y) + c.z);
        return most;
    };
    double x = centre.x, y = centre.y, best = reach(x, y);
    constexpr double pi = std::numbers::pi;
    int turn = 0;
    for (double step = 0.5 * best; step > 1e-8 * best; step *= 0.6)
        for (int k = 0; k < 5; ++k, ++turn) { // directions that do not repeat: the function has kinks
            double const angle = 2 * pi * 0.6180339887498949 * turn;
            double const nx = x + step * std::cos(angle), ny = y + step * std::sin(angle);
            if (double const there = reach(nx, ny); there < best) {
                x = nx, y = ny, best = there;
                k = -1; // as long as it helps
            }
        }
    return 2 * best;
}

//! Side of the smallest square with sides along x and y around what is seen along z.
double square_side(std::span<Ball const> balls, Rotation const& axes)
{
    return std::max(width(balls, axes.x), width(balls, axes.y));
}

//! The view for which a measure is least: the best of many spread over all of them, each then turned by less
//! and less as long as that helps.
class LeastView
{
  public:
    template <class Measure>
    static double find(Measure&& measure, int directions, int turns)
    {
        std::vector<std::pair<double, Rotation>> views;
        for (Rotation const& view : spread(directions, turns))
            views.emplace_back(measure(view), view);
        std::size_t const tried = std::min<std::size_t>(most_tried, views.size());
        std::partial_sort(views.begin(), views.begin() + static_cast<std::ptrdiff_t>(tried), views.end(),
                          [](auto const& a, auto const& b) { return a.first < b.first; });
        double least = views[0].first;
        for (std::size_t k = 0; k < tried; ++k)
            least = std::min(least, refine(measure, views[k]));
        return least;
    }

  private:
    static constexpr std::size_t most_tried = 6;

    //! Looking along points of a spiral over half of the sphere, with turns of up to a right angle.
    static std::vector<Rotation> spread(int directions, int turns)
    {
        constexpr double pi = std::numbers::pi, golden = 0.6180339887498949;
        std::vector<Rotation> views;
        for (int k = 0; k < directions; ++k) {
            double const height = (k + 0.5) / directions, angle = 2 * pi * golden * k;
            double const radius = std::sqrt(1 - height * height);
            Vector3 const z{radius * std::cos(angle), radius * std::sin(angle), height};
            Vector3 const x = any_normal_to(z);
            for (int t = 0; t < turns; ++t)
                views.push_back(rotation_about(z, 0.5 * pi * t / turns) * Rotation{x, cross(z, x), z});
        }
        return views;
    }

    //! Steps in directions that do not repeat, since the measures have kinks in which fixed ones would stick.
    template <class Measure>
    static double refine(Measure& measure, std::pair<double, Rotation> best)
    {
        constexpr double pi = std::numbers::pi, golden = 0.6180339887498949, other = 0.7548776662466927;
        int number = 0;
        for (double step = 0.1; step > 1e-8; step *= 0.7)
            for (int k = 0; k < 12; ++k, ++number) {
                double const height = 2 * std::fmod(golden * number, 1.0) - 1;
                double const angle = 2 * pi * std::fmod(other * number, 1.0);
                double const radius = std::sqrt(1 - height * height);
                Vector3 const axis{radius * std::cos(angle), radius * std::sin(angle), height};
                Rotation const view = rotation_about(axis, step) * best.second;
                if (double const there = measure(view); there < best.first) {
                    best = {there, view};
                    k = -1;
                }
            }
        return best.first;
    }
};

double largest_feret(std::span<Ball const> balls)
{
    double most = 0;
    for (std::size_t i = 0; i < balls.size(); ++i)
        for (std::size_t j = i; j < balls.size(); ++j)
            most = std::max(most, norm(balls[i].place - balls[j].place) + balls[i].radius + balls[j].radius);
    return most;
}

} // namespace

Sizes sizes(std::span<Ball const> balls)
{
    DEMENS_EXPECT(!balls.empty(), "there is a grain");
    if (balls.size() == 1) {
        double const d = 2 * balls[0].radius;
        return {d, d, d, d};
    }
    return {largest_feret(balls),
            LeastView::find([&](Rotation const& view) { return width(balls, view.z); }, 1000, 1),
            LeastView::find([&](Rotation const& view) { return square_side(balls, view); }, 200, 12),
            LeastView::find([&](Rotation const& view) { return enclosing_diameter(balls, view); }, 100, 1)};
}

double size_by(SizeMeasure measure, MassProperties const& properties, Sizes const& sizes)
{
    switch (measure) {
    case SizeMeasure::equivalent:
        return properties.equivalent_diameter();
    case SizeMeasure::largest_feret:
        return sizes.largest_feret;
    case SizeMeasure::smallest_feret:
        return sizes.smallest_feret;
    case SizeMeasure::square_sieve:
        return sizes.square_sieve;
    case SizeMeasure::round_sieve:
        break;
    }
    return sizes.round_sieve;
}

} // namespace demens::grain
