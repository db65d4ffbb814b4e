#include "demens/shape/packing.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "demens/shape/placed_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

namespace demens::shape {
namespace {

//! The order in which spheres are placed: small ones find the gaps.
std::vector<std::size_t> largest_first(std::vector<double> const& diameters)
{
    std::vector<std::size_t> order(diameters.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return diameters[a] > diameters[b]; });
    return order;
}

Vector3 random_point(BoxRegion const& box, RandomStream& random)
{
    return {random.uniform(box.lower.x, box.upper.x), random.uniform(box.lower.y, box.upper.y),
            random.uniform(box.lower.z, box.upper.z)};
}

//! Cells for spheres in a box: no narrower than the largest, and not many more than there are spheres.
double cell_width(Vector3 const& extent, double largest, std::size_t spheres)
{
    return std::max(largest,
                    std::cbrt(extent.x * extent.y * extent.z / (4.0 * static_cast<double>(spheres) + 64)));
}

} // namespace

std::vector<Vector3> loose_packing(std::vector<double> const& diameters, Vector3 const& lower, double width_x,
                                   double width_y, double solid_fraction, RandomStream& random)
{
    if (diameters.empty())
        return {};
    DEMENS_EXPECT(std::all_of(diameters.begin(), diameters.end(), [](double d) { return d > 0; }),
                  "spheres have a size");
    DEMENS_EXPECT(solid_fraction > 0 && solid_fraction < 1, "a part of the space");
    double const largest = *std::max_element(diameters.begin(), diameters.end());
    if (largest >= std::min(width_x, width_y))
        throw InputError(
            fmt::format("no room for the particles: the largest sphere, {:.4g} mm, does not fit into a box "
                        "{:.4g} mm by {:.4g} mm",
                        1e3 * largest, 1e3 * width_x, 1e3 * width_y));
    double volume = 0;
    for (double const d : diameters)
        volume += std::numbers::pi / 6 * d * d * d;
    // Centres fill the box less half a sphere at the walls.
    double const room_x = width_x - largest, room_y = width_y - largest;
    double height = largest + volume / (solid_fraction * (room_x + 0.5 * largest) * (room_y + 0.5 * largest));

    auto const order = largest_first(diameters);
    PlacedSpheres placed(lower, {width_x, width_y, 4 * height}, largest);
    std::vector<Vector3> places(diameters.size());
    for (std::size_t const k : order) {
        double const r = 0.5 * diameters[k];
        Vector3 p;
        int tries = 0;
        do {
            if (++tries % 200 == 0)
                height *= 1.02; // crowded: a little more height
            p = lower + Vector3{random.uniform(r, width_x - r), random.uniform(r, width_y - r),
                                random.uniform(r, height - r)};
        } while (placed.overlaps(p, r));
        placed.add(p, r);
        places[k] = p;
    }
    return places;
}

std::vector<Vector3> fill_region(std::vector<double> const& diameters, Region const& region,
                                 std::vector<Sphere> const& obstacles, FreeTest const& is_free,
                                 RandomStream& random)
{
    if (diameters.empty())
        return {};
    DEMENS_EXPECT(std::all_of(diameters.begin(), diameters.end(), [](double d) { return d > 0; }),
                  "spheres have a size");
    double const largest = *std::max_element(diameters.begin(), diameters.end());
    auto const box = bounds(region);
    Vector3 const extent = box.upper - box.lower;
    PlacedSpheres placed(box.lower, extent, cell_width(extent, largest, diameters.size()));
    std::vector<Sphere> large; // too large for the cells
    for (auto const& [centre, radius] : obstacles) {
        double const reach = radius + largest;
        if (!contains(
                BoxRegion{box.lower - Vector3{reach, reach, reach}, box.upper + Vector3{reach, reach, reach}},
                centre))
            continue;
        if (2 * radius > largest)
            large.push_back({centre, radius});
        else
            placed.add(centre, radius);
    }
    auto const fits = [&](Vector3 const& p, double r) {
        for (auto const& [centre, radius] : large)
            if (norm_squared(p - centre) < (r + radius) * (r + radius))
                return false;
        return contains(region, p, r) && !placed.overlaps(p, r) && is_free(p, r);
    };
    constexpr int most_tries = 20000;
    std::vector<Vector3> places(diameters.size());
    std::size_t done = 0;
    for (std::size_t const k : largest_first(diameters)) {
        double const r = 0.5 * diameters[k];
        Vector3 p = random_point(box, random);
        for (int tries = 0; !fits(p, r); p = random_point(box, random))
            if (++tries == most_tries)
                throw InputError(fmt::format("no room for the particles: only {} of {} were placed in the "
                                             "region, of {:.4g} mm^3; a loose "
                                             "packing fills at most about 0.3 of it",
                                             done, diameters.size(), 1e9 * volume(region)));
        placed.add(p, r);
        places[k] = p;
        ++done;
    }
    return places;
}

double free_volume(Region const& region, double radius, FreeTest const& is_free)
{
    constexpr int samples = 2000;
    auto const box = bounds(region);
    RandomStream random(1);
    int free = 0;
    for (int k = 0; k < samples; ++k) {
        Vector3 const p = random_point(box, random);
        free += contains(region, p) && is_free(p, radius);
    }
    return volume(box) * free / samples;
}

} // namespace demens::shape
