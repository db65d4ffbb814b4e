#include "src/dem/cpu/mesh_contacts.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <cmath>

namespace demens::dem {

namespace {

//! When a triangle is due: bodies that have travelled so far are nearer by at most twice that.
float due_after(double travelled, double clearance)
{
    return static_cast<float>((1 - 1e-6) * (travelled + 0.5 * clearance));
}

} // namespace

void append_near_triangles(std::vector<NearTriangle>& near, shape::TriangleMesh const& mesh,
                           Vector3 const& position, double radius, double reach)
{
    auto const first = static_cast<std::ptrdiff_t>(near.size());
    mesh.tree().for_each_near(position, radius + reach, [&](std::uint32_t triangle) {
        shape::Facet const& facet = mesh.facets()[triangle];
        if (std::abs(dot(position - facet.corner, facet.normal)) >= radius + reach)
            return;
        double const squared = norm_squared(facet.nearest(position).offset);
        if (squared >= (radius + reach) * (radius + reach))
            return;
        double const clearance = std::sqrt(squared) - radius;
        if (clearance < reach)
            near.push_back({triangle, due_after(0, std::max(clearance, 0.0))});
    });
    std::sort(near.begin() + first, near.end(), [](NearTriangle const& a, NearTriangle const& b) {
        return a.due != b.due ? a.due < b.due : a.triangle < b.triangle;
    });
}

MeshContactFinder::InReach MeshContactFinder::look(shape::TriangleMesh const& mesh,
                                                   std::span<NearTriangle> near, double travelled,
                                                   Sphere const& sphere)
{
    InReach found{};
    double const now = travelled + 0.5 * (sphere.reach - sphere.radius);
    for (NearTriangle& entry : near) {
        if (entry.due > now)
            continue;
        Vector3 const offset = mesh.facets()[entry.triangle].nearest(sphere.position).offset;
        double const squared = norm_squared(offset);
        entry.due = due_after(travelled, std::max(std::sqrt(squared) - sphere.radius, 0.0));
        if (squared >= sphere.reach * sphere.reach)
            continue;
        // Where the centre is on a triangle its normal decides, as with several triangles.
        found.count += squared > 0 ? 1 : 2;
        found.offset = offset;
    }
    return found;
}

void MeshContactFinder::collect(shape::TriangleMesh const& mesh, std::span<NearTriangle> near,
                                double travelled, Sphere const& sphere)
{
    candidates_.clear();
    double const now = travelled + 0.5 * (sphere.reach - sphere.radius);
    for (NearTriangle& entry : near) {
        if (entry.due > now)
            continue;
        shape::Facet const& facet = mesh.facets()[entry.triangle];
        shape::Facet::Nearest const nearest = facet.nearest(sphere.position);
        double const squared = norm_squared(nearest.offset);
        Candidate found{std::sqrt(squared), nearest.offset, nearest.feature, &facet};
        entry.due = due_after(travelled, std::max(found.distance - sphere.radius, 0.0));
        if (squared >= sphere.reach * sphere.reach)
            continue;
        if (squared == 0) { // the centre is on the triangle: push along its normal
            found.distance = 1e-9 * sphere.radius;
            found.offset = found.distance * facet.normal;
        }
        auto const after = std::find_if(candidates_.begin(), candidates_.end(),
                                        [&](Candidate const& c) { return c.distance > found.distance; });
        candidates_.insert(after, found);
    }
}

bool MeshContactFinder::is_passed_over(std::size_t candidate) const
{
    Candidate const& c = candidates_[candidate];
    if (c.feature == shape::face)
        return false;
    for (std::size_t k = 0; k < candidate; ++k)
        if (candidates_[k].distance < c.distance && candidates_[k].facet->contains(*c.facet, c.feature))
            return true;
    return false;
}

std::span<Vector3 const> MeshContactFinder::find(shape::TriangleMesh const& mesh,
                                                 std::span<NearTriangle> near, double travelled,
                                                 Sphere const& sphere)
{
    DEMENS_EXPECT(sphere.radius > 0 && sphere.reach >= sphere.radius, "a sphere that reaches its surface");
    collect(mesh, near, travelled, sphere);
    offsets_.clear();
    accepted_.clear();
    double const negligible = 1e-9 * sphere.radius;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
        Candidate const& c = candidates_[k];
        double depth = sphere.radius - c.distance;
        if (k > 0) {
            if (is_passed_over(k))
                continue;
            double rise = sphere.reach;
            for (std::size_t const other : accepted_) {
                Candidate const& deeper = candidates_[other];
                rise = std::min(rise, deeper.distance - dot(c.offset, deeper.offset) / deeper.distance);
            }
            if (rise <= negligible)
                continue;
            depth = std::min(depth, rise);
        }
        accepted_.push_back(k);
        offsets_.push_back(((sphere.radius - depth) / c.distance) * c.offset);
    }
    return offsets_;
}

void SlotAssignment::assign(ContactList& list, MeshPatch const& patch, std::span<Vector3 const> contacts,
                            double reach)
{
    DEMENS_EXPECT(contacts.size() <= patch.slots, "a contact needs a slot");
    auto& offset = offset_;
    auto& taken = taken_;
    auto& placed = placed_;
    offset.resize(patch.slots);
    for (std::uint32_t s = 0; s < patch.slots; ++s)
        offset[s] = list.touching[patch.first_slot + s] ? parted(list.offset[patch.first_slot + s], reach)
                                                        : out_of_reach;
    taken.assign(patch.slots, 0);
    placed.assign(contacts.size(), 0);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        double best = like_normals;
        std::uint32_t best_slot = patch.slots;
        for (std::uint32_t s = 0; s < patch.slots; ++s) {
            Vector3 const& old = list.offset[patch.first_slot + s];
            if (!list.touching[patch.first_slot + s] || taken[s])
                continue;
            double const cosine =
                dot(contacts[c], old) / std::sqrt(norm_squared(contacts[c]) * norm_squared(old));
            if (cosine > best) {
                best = cosine;
                best_slot = s;
            }
        }
        if (best_slot < patch.slots) {
            offset[best_slot] = contacts[c];
            taken[best_slot] = placed[c] = 1;
        }
    }
    // New contacts go where there is no history, or where that of a lost contact is in the way.
    auto const state_size = static_cast<std::size_t>(list.state_size);
    for (std::size_t c = 0; c < contacts.size(); ++c)
        for (bool const empty : {true, false})
            for (std::uint32_t s = 0; s < patch.slots && !placed[c]; ++s) {
                std::uint32_t const slot = patch.first_slot + s;
                if (taken[s] || (empty && list.touching[slot]))
                    continue;
                if (list.touching[slot]) {
                    std::fill_n(list.state.begin() + static_cast<std::ptrdiff_t>(slot * state_size),
                                state_size, 0.0);
                    list.touching[slot] = 0;
                }
                offset[s] = contacts[c];
                taken[s] = placed[c] = 1;
            }
    std::copy_n(offset.begin(), patch.slots, list.offset.begin() + patch.first_slot);
}

} // namespace demens::dem
