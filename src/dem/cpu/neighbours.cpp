#include "src/dem/cpu/neighbours.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cpu/joined_walls.hpp"
#include "src/dem/cpu/mesh_contacts.hpp"
#include "src/dem/cpu/wall_contacts.hpp"

#include <algorithm>

namespace demens::dem {

void NeighbourSearch::rebuild(Particles& particles, std::vector<Wall> const& walls,
                              NeighbourReach const& reach, ContactLists& contacts)
{
    DEMENS_EXPECT(particles.is_whole(), "particles have columns of one length");
    DEMENS_EXPECT(contacts.pairs.size() == contacts.walls.size() &&
                      (particles.ghosts == 0 || contacts.ghosts.size() == contacts.pairs.size()),
                  "of each kind a list for each law set");
    CellGrid const grid(particles.place, reach.candidates, periods_);
    sort_into_cells(particles, grid);
    index_old_contacts(particles.size(), contacts);
    set_histories_aside(contacts);
    hull_pairs_.clear(), hulls_at_walls_.clear();
    large_.clear();
    for (std::uint32_t i = 0; i < particles.owned(); ++i)
        if (particles.place[i].radius > grid.regular_radius())
            large_.push_back(i);
    bool const has_large = !large_.empty();
    auto const find = periods_.any() ? (has_large ? &NeighbourSearch::find_pairs<true, true>
                                                  : &NeighbourSearch::find_pairs<true, false>)
                                     : (has_large ? &NeighbourSearch::find_pairs<false, true>
                                                  : &NeighbourSearch::find_pairs<false, false>);
    (this->*find)(particles, grid, {contacts.pairs.data(), reach});
    if (has_large)
        find_pairs_of_large(particles, grid, {contacts.pairs.data(), reach});
    find_wall_contacts(particles, walls, reach.candidates, contacts.walls);
    if (particles.ghosts > 0)
        find_ghost_pairs(particles, grid, {contacts.ghosts.data(), reach});
}

void NeighbourSearch::sort_into_cells(Particles& particles, CellGrid const& grid)
{
    std::size_t const n = particles.size();
    cell_of_.resize(n);
    new_index_.resize(n);
    number_along_cells(particles, grid, 0, particles.owned(), cell_start_);
    std::vector<std::uint32_t> ghost_cell_start;
    if (particles.ghosts > 0)
        number_along_cells(particles, grid, particles.owned(), n, ghost_cell_start);

    sorted_.has_bodies = particles.has_bodies, sorted_.has_hulls = particles.has_hulls;
    sorted_.resize(n);
    sorted_.ghosts = particles.ghosts;
    for (std::size_t i = 0; i < n; ++i) {
        std::uint32_t const to = new_index_[i];
        sorted_.place[to] = particles.place[i];
        sorted_.motion[to] = particles.motion[i];
        sorted_.load[to] = particles.load[i];
        sorted_.material[to] = particles.material[i];
        sorted_.id[to] = particles.id[i];
    }
    for (std::size_t i = 0; i < particles.body.size(); ++i)
        sorted_.body[new_index_[i]] = particles.body[i];
    for (std::size_t i = 0; i < particles.hull.size(); ++i)
        sorted_.hull[new_index_[i]] = particles.hull[i];
    std::swap(particles, sorted_);
}

void NeighbourSearch::number_along_cells(Particles const& particles, CellGrid const& grid, std::size_t from,
                                         std::size_t to, std::vector<std::uint32_t>& cell_start)
{
    std::size_t const cells = grid.size();
    cell_start.assign(cells + 1, 0);
    cell_start[0] = static_cast<std::uint32_t>(from);
    for (std::size_t i = from; i < to; ++i) {
        cell_of_[i] = grid.cell_of(particles.place[i]);
        ++cell_start[cell_of_[i] + 1];
    }
    for (std::size_t c = 0; c < cells; ++c)
        cell_start[c + 1] += cell_start[c];
    std::vector<std::uint32_t> next(cell_start.begin(), cell_start.end() - 1);
    for (std::size_t i = from; i < to; ++i)
        new_index_[i] = next[cell_of_[i]]++;
}

void NeighbourSearch::index_old_contacts(std::size_t particles, ContactLists const& contacts)
{
    // Every touching contact is filed under the particle that will come first in its pair; wall contacts
    // under the particle.
    old_start_.assign(particles + 1, 0);
    auto const for_each_touching = [&](auto&& visit) {
        contacts.for_each([&](ContactList const& list) {
            for (std::uint32_t s = 0; s < list.size(); ++s) {
                if (!list.touching[s])
                    continue;
                std::uint32_t const i = new_index_[list.first[s]];
                bool const wall = list.kind == ContactKind::wall;
                std::uint32_t const j = wall ? list.second[s] : new_index_[list.second[s]];
                bool const reversed = !wall && j < i;
                visit(reversed ? j : i,
                      OldContact{reversed ? i : j, list.interaction, s, list.kind, reversed});
            }
        });
    };
    for_each_touching([&](std::uint32_t owner, OldContact const&) { ++old_start_[owner + 1]; });
    for (std::size_t i = 0; i < particles; ++i)
        old_start_[i + 1] += old_start_[i];
    old_contacts_.resize(old_start_[particles]);
    std::vector<std::uint32_t> next(old_start_.begin(), old_start_.end() - 1);
    for_each_touching(
        [&](std::uint32_t owner, OldContact const& contact) { old_contacts_[next[owner]++] = contact; });
}

void NeighbourSearch::set_histories_aside(ContactLists& contacts)
{
    for (ContactKind const kind : {ContactKind::pair, ContactKind::wall, ContactKind::ghost}) {
        auto &lists = contacts.of(kind), &old = old_lists_.of(kind);
        old.resize(lists.size());
        for (std::size_t k = 0; k < lists.size(); ++k) {
            std::swap(old[k].state, lists[k].state);
            std::swap(old[k].offset, lists[k].offset);
            lists[k].clear();
        }
    }
}

void NeighbourSearch::add_contact(ContactList& list, std::uint32_t i, std::uint32_t j)
{
    DEMENS_EXPECT(i != j || list.kind == ContactKind::wall, "a particle does not meet itself");
    list.add(i, j);
    restore_histories(list, list.size() - 1);
}

void NeighbourSearch::add_patch(ContactList& list, std::uint32_t i, std::uint32_t wall, std::uint32_t slots,
                                std::span<NearTriangle const> triangles)
{
    auto const slot = static_cast<std::uint32_t>(list.size());
    auto const count = static_cast<std::uint32_t>(triangles.size());
    list.patches.push_back(
        {slot, slots, static_cast<std::uint32_t>(list.near_triangles.size()), count, MeshPatch::always});
    list.near_triangles.insert(list.near_triangles.end(), triangles.begin(), triangles.end());
    for (std::uint32_t k = 0; k < list.patches.back().slots; ++k)
        list.add(i, wall);
    restore_histories(list, slot);
}

void NeighbourSearch::restore_histories(ContactList& list, std::size_t slot)
{
    // A ghost may come first in its pair; contacts are filed under the other one.
    bool const reversed = list.kind == ContactKind::ghost && list.second[slot] < list.first[slot];
    std::uint32_t const i = reversed ? list.second[slot] : list.first[slot];
    std::uint32_t const j = reversed ? list.first[slot] : list.second[slot];
    bool const with_wall = list.kind == ContactKind::wall;
    auto const size = static_cast<std::size_t>(list.state_size);
    for (std::uint32_t k = old_start_[i]; k < old_start_[i + 1] && slot < list.size(); ++k) {
        OldContact const& old = old_contacts_[k];
        if (old.other != j || (old.kind == ContactKind::wall) != with_wall)
            continue;
        list.touching[slot] = 1;
        ContactList const& from_list = old_lists_.of(old.kind)[old.list];
        double const* from = from_list.state.data() + old.slot * size;
        double* to = list.state.data() + slot * size;
        for (int c = 0; c < list.state_size; ++c)
            to[c] = old.reversed != reversed && c >= list.state_scalars ? -from[c] : from[c];
        if (with_wall)
            list.offset[slot] = from_list.offset[old.slot];
        ++slot;
    }
}

template <bool periodic>
DEMENS_INLINE void NeighbourSearch::test_pair(Particles const& particles, std::uint32_t first,
                                              std::uint32_t second, PairLists lists)
{
    Place const& a = particles.place[first];
    Place const& b = particles.place[second];
    double const squared = distance_squared<periodic>(a, b, periods_), touching = a.radius + b.radius;
    double const furthest = touching + lists.reach.candidates;
    if (squared >= furthest * furthest || particles.are_of_one_body(first, second))
        return;
    if (particles.is_hull(first) || particles.is_hull(second)) {
        hull_pairs_.push_back({first, second});
        return;
    }
    ContactList& list = lists.of_interaction[interaction_[particles.material[first] * materials_ +
                                                          particles.material[second]]];
    list.candidates.push_back({first, second});
    double const near = touching + lists.reach.contacts;
    if (squared < near * near)
        add_contact(list, first, second);
}

template <bool periodic, bool has_large>
void NeighbourSearch::find_pairs(Particles const& particles, CellGrid const& grid, PairLists lists)
{
    auto const test_range = [&](std::uint32_t i, std::uint32_t from, std::uint32_t to) {
        for (std::uint32_t j = from; j < to; ++j) {
            if (has_large && particles.place[j].radius > grid.regular_radius())
                continue;
            // Across a border a neighbour may come earlier in the order, as histories are filed.
            if (periodic && j < i)
                test_pair<periodic>(particles, j, i, lists);
            else
                test_pair<periodic>(particles, i, j, lists);
        }
    };
    std::uint32_t i = 0;
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
        std::uint32_t const end = cell_start_[cell + 1];
        if (i == end)
            continue;
        std::uint32_t const own_row_end = cell_start_[grid.end_of_own_row(cell)];
        CellGrid::Ranges const forward = grid.forward_of(cell);
        for (; i < end; ++i) {
            if (has_large && particles.place[i].radius > grid.regular_radius())
                continue;
            test_range(i, i + 1, own_row_end);
            for (int r = 0; r < forward.count; ++r)
                test_range(i, cell_start_[forward.from[r]], cell_start_[forward.to[r]]);
        }
    }
}

void NeighbourSearch::find_pairs_of_large(Particles const& particles, CellGrid const& grid, PairLists lists)
{
    auto const test = [&](std::uint32_t i, std::uint32_t j) {
        test_pair<true>(particles, std::min(i, j), std::max(i, j), lists);
    };
    for (auto large = large_.begin(); large != large_.end(); ++large) {
        for (auto other = large + 1; other != large_.end(); ++other)
            test(*large, *other);
        Place const& place = particles.place[*large];
        grid.for_each_near(place, place.radius + grid.regular_radius() + lists.reach.candidates,
                           [&](std::uint32_t cell) {
                               for (std::uint32_t j = cell_start_[cell]; j < cell_start_[cell + 1]; ++j)
                                   if (particles.place[j].radius <= grid.regular_radius())
                                       test(*large, j);
                           });
    }
}

//! All pairs of a ghost and a particle of this process. The one with the lower id comes first: the other
//! process has the same pair, and computes the same force from the same numbers.
void NeighbourSearch::find_ghost_pairs(Particles const& particles, CellGrid const& grid, PairLists lists)
{
    auto const test = [&](std::uint32_t ghost, std::uint32_t j) {
        bool const ghost_first = particles.id[ghost] < particles.id[j];
        test_pair<true>(particles, ghost_first ? ghost : j, ghost_first ? j : ghost, lists);
    };
    for (auto ghost = static_cast<std::uint32_t>(particles.owned()); ghost < particles.size(); ++ghost) {
        for (std::uint32_t const large : large_)
            test(ghost, large);
        Place const& place = particles.place[ghost];
        grid.for_each_near(place, place.radius + grid.regular_radius() + lists.reach.candidates,
                           [&](std::uint32_t cell) {
                               for (std::uint32_t j = cell_start_[cell]; j < cell_start_[cell + 1]; ++j)
                                   if (particles.place[j].radius <= grid.regular_radius())
                                       test(ghost, j);
                           });
    }
}

namespace {

//! Contacts that a particle may have with a mesh within a skin of its place: few, or, in the tip of a hollow,
//! many.
std::uint32_t most_contacts(Mesh const& wall, Place const& p, double skin,
                            std::span<NearTriangle const> triangles)
{
    if (triangles.size() <= MeshPatch::few_contacts)
        return static_cast<std::uint32_t>(triangles.size());
    std::vector<NearTriangle> near(triangles.begin(), triangles.end()); // what is due when stays as it is
    MeshContactFinder finder;
    auto const found = finder.find(*wall.mesh, near, 0,
                                   {wall.placement.inverse({p.x, p.y, p.z}), p.radius, p.radius + skin});
    return std::max(MeshPatch::few_contacts, static_cast<std::uint32_t>(found.size()));
}

} // namespace

void NeighbourSearch::find_wall_contacts(Particles const& particles, std::vector<Wall> const& walls,
                                         double skin, std::vector<ContactList>& lists)
{
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
        Wall const& wall = walls[w];
        if (!wall.active)
            continue;
        WallNeighbours const found = find_neighbours(wall, particles, skin);
        bool const is_mesh = std::holds_alternative<Mesh>(wall.shape);
        for (std::size_t k = 0; k < found.particles.size(); ++k) {
            std::uint32_t const i = found.particles[k];
            if (particles.is_hull(i)) {
                hulls_at_walls_.push_back({i, w});
                continue;
            }
            auto& list = lists[interaction_[particles.material[i] * materials_ + wall.material.value]];
            if (is_mesh) {
                std::span const triangles(found.near_triangles.data() + found.triangle_start[k],
                                          found.triangle_start[k + 1] - found.triangle_start[k]);
                add_patch(list, i, w,
                          most_contacts(std::get<Mesh>(wall.shape), particles.place[i], skin, triangles),
                          triangles);
            } else {
                add_contact(list, i, w);
            }
        }
    }
    for (ContactList& list : lists)
        find_joined(list, particles.place, walls);
}

} // namespace demens::dem
