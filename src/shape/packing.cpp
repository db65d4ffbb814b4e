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

//! The order in which groups are placed: small ones find the gaps.
std::vector<std::size_t> largest_first(std::vector<SphereGroup> const& groups)
{
    std::vector<std::size_t> order(groups.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return groups[a].size > groups[b].size; });
    return order;
}

constexpr Sphere unit_sphere{{}, 1};

std::vector<SphereGroup> spheres_of(std::vector<double> const& diameters)
{
    DEMENS_EXPECT(std::all_of(diameters.begin(), diameters.end(), [](double d) { return d > 0; }),
                  "spheres have a size");
    std::vector<SphereGroup> groups;
    for (double const d : diameters)
        groups.push_back({{&unit_sphere, 1}, 0.5 * d});
    return groups;
}

std::vector<Vector3> centres_of(std::vector<GroupPlace> const& places)
{
    std::vector<Vector3> centres;
    for (auto const& place : places)
        centres.push_back(place.centre);
    return centres;
}

//! The largest value of a group.
double largest_of(std::vector<SphereGroup> const& groups, double (SphereGroup::*value)() const)
{
    double largest = 0;
    for (auto const& group : groups)
        largest = std::max(largest, (group.*value)());
    return largest;
}

//! The spheres of a group where it is put.
void put(SphereGroup const& group, GroupPlace const& place, std::vector<Sphere>& spheres)
{
    spheres.clear();
    if (group.is_sphere()) {
        spheres.push_back({place.centre, group.size * group.spheres.front().radius});
        return;
    }
    Rotation const turn = place.orientation.rotation();
    for (auto const& [centre, radius] : group.spheres)
        spheres.push_back({place.centre + turn(group.size * centre), group.size * radius});
}

//! A place at random; no numbers are drawn for the orientation of a sphere.
GroupPlace turned(SphereGroup const& group, Vector3 const& centre, RandomStream& random)
{
    return {centre, group.is_sphere() ? Quaternion{} : random_orientation(random)};
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

double SphereGroup::reach() const
{
    double furthest = 0;
    for (auto const& [centre, radius] : spheres)
        furthest = std::max(furthest, norm(centre) + radius);
    return size * furthest;
}

double SphereGroup::largest() const
{
    double radius = 0;
    for (Sphere const& sphere : spheres)
        radius = std::max(radius, sphere.radius);
    return 2 * size * radius;
}

Quaternion random_orientation(RandomStream& random)
{
    constexpr double whole = 2 * std::numbers::pi;
    double const u = random.uniform(), a = random.uniform(0, whole), b = random.uniform(0, whole);
    double const s = std::sqrt(1 - u), t = std::sqrt(u);
    return {t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b)};
}

std::vector<Vector3> loose_packing(std::vector<double> const& diameters, Vector3 const& lower, double width_x,
                                   double width_y, double solid_fraction, RandomStream& random)
{
    return centres_of(place_loosely(spheres_of(diameters), lower, width_x, width_y, solid_fraction, random));
}

std::vector<GroupPlace> place_loosely(std::vector<SphereGroup> const& groups, Vector3 const& lower,
                                      double width_x, double width_y, double solid_fraction,
                                      RandomStream& random)
{
    if (groups.empty())
        return {};
    DEMENS_EXPECT(solid_fraction > 0 && solid_fraction < 1, "a part of the space");
    double const widest = 2 * largest_of(groups, &SphereGroup::reach);
    if (widest >= std::min(width_x, width_y))
        throw InputError(
            fmt::format("no room for the particles: the largest particle, {:.4g} mm, does not fit into a box "
                        "{:.4g} mm by {:.4g} mm",
                        1e3 * widest, 1e3 * width_x, 1e3 * width_y));
    double volume = 0;
    for (auto const& group : groups) {
        double const d = 2 * group.size;
        volume += std::numbers::pi / 6 * d * d * d;
    }
    // Centres fill the box less half a particle at the walls.
    double const room_x = width_x - widest, room_y = width_y - widest;
    double height = widest + volume / (solid_fraction * (room_x + 0.5 * widest) * (room_y + 0.5 * widest));

    PlacedSpheres placed(lower, {width_x, width_y, 4 * height}, largest_of(groups, &SphereGroup::largest));
    std::vector<GroupPlace> places(groups.size());
    std::vector<Sphere> spheres;
    auto const overlaps = [&](Sphere const& s) { return placed.overlaps(s.centre, s.radius); };
    for (std::size_t const k : largest_first(groups)) {
        double const r = groups[k].reach();
        int tries = 0;
        do {
            if (++tries % 200 == 0)
                height *= 1.02; // crowded: a little more height
            Vector3 const p = lower + Vector3{random.uniform(r, width_x - r), random.uniform(r, width_y - r),
                                              random.uniform(r, height - r)};
            places[k] = turned(groups[k], p, random);
            put(groups[k], places[k], spheres);
        } while (std::any_of(spheres.begin(), spheres.end(), overlaps));
        for (auto const& [centre, radius] : spheres)
            placed.add(centre, radius);
    }
    return places;
}

std::vector<Vector3> fill_region(std::vector<double> const& diameters, Region const& region,
                                 std::vector<Sphere> const& obstacles, FreeTest const& is_free,
                                 RandomStream& random)
{
    return centres_of(place_in_region(spheres_of(diameters), region, obstacles, is_free, random));
}

std::vector<GroupPlace> place_in_region(std::vector<SphereGroup> const& groups, Region const& region,
                                        std::vector<Sphere> const& obstacles, FreeTest const& is_free,
                                        RandomStream& random)
{
    if (groups.empty())
        return {};
    double const largest = largest_of(groups, &SphereGroup::largest);
    auto const box = bounds(region);
    Vector3 const extent = box.upper - box.lower;
    PlacedSpheres placed(box.lower, extent, cell_width(extent, largest, groups.size()));
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
    auto const fits = [&](Sphere const& sphere) {
        auto const& [p, r] = sphere;
        for (auto const& [centre, radius] : large)
            if (norm_squared(p - centre) < (r + radius) * (r + radius))
                return false;
        return contains(region, p, r) && !placed.overlaps(p, r) && is_free(p, r);
    };
    constexpr int most_tries = 20000;
    std::vector<GroupPlace> places(groups.size());
    std::vector<Sphere> spheres;
    std::size_t done = 0;
    for (std::size_t const k : largest_first(groups)) {
        auto const try_anywhere = [&] {
            Vector3 const p = random_point(box, random);
            places[k] = turned(groups[k], p, random);
            put(groups[k], places[k], spheres);
        };
        try_anywhere();
        for (int tries = 0; !std::all_of(spheres.begin(), spheres.end(), fits); try_anywhere())
            if (++tries == most_tries)
                throw InputError(fmt::format("no room for the particles: only {} of {} were placed in the "
                                             "region, of {:.4g} mm^3; a loose "
                                             "packing fills at most about 0.3 of it",
                                             done, groups.size(), 1e9 * volume(region)));
        for (auto const& [centre, radius] : spheres)
            placed.add(centre, radius);
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
