#include "demens/grain/clump.hpp"

#include "demens/base/error.hpp"
#include "src/grain/exposed_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

namespace demens::grain {
namespace {

//! Whether all of a is in b, by rounded numbers.
bool lies_in(Ball const& a, Ball const& b)
{
    return norm(a.place - b.place) + a.radius <= b.radius;
}

//! Without the spheres that lie in others; of equal ones the first stays.
Clump without_hidden(std::span<Ball const> clump)
{
    Clump kept;
    for (std::size_t i = 0; i < clump.size(); ++i) {
        bool hidden = false;
        for (std::size_t j = 0; j < clump.size() && !hidden; ++j)
            hidden = j != i && lies_in(clump[i], clump[j]) && (j < i || !lies_in(clump[j], clump[i]));
        if (!hidden)
            kept.push_back(clump[i]);
    }
    return kept;
}

//! What the other spheres cover of one, none of which holds it.
std::vector<Cap> caps_on(Clump const& clump, std::size_t number)
{
    std::vector<Cap> caps;
    Ball const& ball = clump[number];
    for (std::size_t j = 0; j < clump.size(); ++j) {
        Vector3 const apart = clump[j].place - ball.place;
        double const distance = norm(apart), r = clump[j].radius;
        if (j == number || distance == 0)
            continue;
        double const level =
            ((ball.radius - r) * (ball.radius + r) + distance * distance) / (2 * ball.radius * distance);
        if (level < 1)
            caps.push_back({apart / distance, std::max(level, -1.0)});
    }
    return caps;
}

//! The normal's moments as vectors and tensors.
struct Moments
{
    explicit Moments(NormalMoments const& m)
        : zeroth(m.at(0, 0, 0)), first{m.at(1, 0, 0), m.at(0, 1, 0), m.at(0, 0, 1)},
          second{second_times(m, 0, 0, 0)}, third{second_times(m, 1, 0, 0), second_times(m, 0, 1, 0),
                                                  second_times(m, 0, 0, 1)}
    {
    }
    double zeroth;
    Vector3 first;
    SymmetricTensor second;
    SymmetricTensor third[3]; //!< the normal's products times each of its components

  private:
    static SymmetricTensor second_times(NormalMoments const& m, int x, int y, int z)
    {
        return {m.at(2 + x, y, z),     m.at(x, 2 + y, z),     m.at(x, y, 2 + z),
                m.at(1 + x, 1 + y, z), m.at(1 + x, y, 1 + z), m.at(x, 1 + y, 1 + z)};
    }
};

//! What a sphere's exposed surface contributes: div(f p) = (k + 3) f for f homogeneous of degree k, so that
//! the integral of f is that of f (p . n) over the surface, divided by k + 3; p = place + radius n.
VolumeMoments of_surface(Ball const& ball, NormalMoments const& exposed)
{
    Moments const m(exposed);
    Vector3 const& c = ball.place;
    double const r = ball.radius, area = r * r;
    // Integrals of p . n, n (p . n) and n n (p . n).
    double const flux = dot(c, m.first) + r * m.zeroth;
    Vector3 const normal_flux = m.second * c + r * m.first;
    SymmetricTensor const product_flux =
        c.x * m.third[0] + c.y * m.third[1] + c.z * m.third[2] + r * m.second;
    return {area / 3 * flux, area / 4 * (flux * c + r * normal_flux),
            area / 5 * (flux * products(c) + 2 * r * products(c, normal_flux) + r * r * product_flux)};
}

VolumeMoments of_ball(Ball const& ball)
{
    double const r = ball.radius, volume = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    double const second = 0.2 * volume * r * r;
    return VolumeMoments{volume, {}, {second, second, second}}.shifted(ball.place);
}

} // namespace

void check(std::span<Ball const> clump, std::string const& origin)
{
    if (clump.empty())
        throw InputError(origin + ": a clump needs at least one sphere");
    for (std::size_t k = 0; k < clump.size(); ++k) {
        auto const& [p, r] = clump[k];
        if (!std::isfinite(p.x + p.y + p.z + r))
            throw InputError(
                fmt::format("{}: a number of sphere {} of {} is not finite", origin, k + 1, clump.size()));
        if (r <= 0)
            throw InputError(fmt::format("{}: sphere {} of {} has the radius {:.6g} m: it must be above 0",
                                         origin, k + 1, clump.size(), r));
    }
    std::vector<int> const part = parts(clump);
    auto const other = std::find_if(part.begin(), part.end(), [](int p) { return p != 0; });
    if (other != part.end())
        throw InputError(fmt::format(
            "{}: the spheres do not hang together, they make {} parts: sphere {} neither touches nor "
            "overlaps "
            "those that hang together with sphere 1. Move or enlarge spheres, or make the parts shapes of "
            "their own",
            origin, 1 + *std::max_element(part.begin(), part.end()), other - part.begin() + 1));
}

std::vector<int> parts(std::span<Ball const> clump)
{
    std::vector<int> part(clump.size(), -1);
    int count = 0;
    for (std::size_t first = 0; first < clump.size(); ++first) {
        if (part[first] >= 0)
            continue;
        part[first] = count;
        std::vector<std::size_t> open = {first};
        while (!open.empty()) {
            Ball const& a = clump[open.back()];
            open.pop_back();
            for (std::size_t j = 0; j < clump.size(); ++j)
                if (part[j] < 0 &&
                    norm(a.place - clump[j].place) <= (1 + 1e-9) * (a.radius + clump[j].radius)) {
                    part[j] = count;
                    open.push_back(j);
                }
        }
        ++count;
    }
    return part;
}

VolumeMoments volume_moments(std::span<Ball const> clump)
{
    Clump seen = without_hidden(clump);
    if (seen.size() == 1)
        return of_ball(seen[0]);
    Vector3 origin;
    for (Ball const& ball : seen)
        origin += ball.place / static_cast<double>(seen.size());
    for (Ball& ball : seen)
        ball.place -= origin;
    VolumeMoments moments;
    for (std::size_t k = 0; k < seen.size(); ++k)
        moments += of_surface(seen[k], exposed_moments(caps_on(seen, k)));
    return moments.shifted(origin);
}

MassProperties mass_properties(std::span<Ball const> clump)
{
    return mass_properties_of(volume_moments(clump));
}

Clump scaled(std::span<Ball const> clump, double factor)
{
    Clump result(clump.begin(), clump.end());
    for (Ball& ball : result)
        ball = {factor * ball.place, factor * ball.radius};
    return result;
}

Clump in_principal_axes(std::span<Ball const> clump, MassProperties const& properties)
{
    Clump result(clump.begin(), clump.end());
    for (Ball& ball : result)
        ball.place = properties.axes.inverse(ball.place - properties.centre);
    return result;
}

} // namespace demens::grain
