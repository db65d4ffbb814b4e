#include "src/dem/cpu/state_record.hpp"

#include "demens/dem/record_fields.hpp"
#include "src/dem/cpu/hulls/hull_record.hpp"
#include "src/dem/record_fit.hpp"

#include <utility>

namespace demens::dem {

template <>
struct RecordRow<CandidatePair>
{
    using Element = std::uint32_t;
};

namespace {

// Records of several types, as columns.

struct RangeColumns
{
    std::vector<double> gap;
    std::vector<std::uint8_t> needs_contact;

    template <class Record>
    void visit(Record& record)
    {
        record("lists/range_gap", gap), record("lists/range_needs_contact", needs_contact);
    }
};

struct TriangleColumns
{
    std::vector<std::uint32_t> triangle;
    std::vector<float> due;

    template <class Record>
    void visit(Record& record, std::string const& name)
    {
        record(name + "/near_triangle", triangle), record(name + "/near_triangle_due", due);
    }
};

struct PatchColumns
{
    std::vector<std::uint32_t> numbers; //!< five of each
    std::vector<float> dues;            //!< two of each
    std::vector<double> path;
    std::vector<Vector3> seen_at;

    template <class Record>
    void visit(Record& record, std::string const& name)
    {
        record(name + "/patch_numbers", numbers), record(name + "/patch_dues", dues);
        record(name + "/patch_path", path), record(name + "/patch_seen_at", seen_at);
    }
};

std::string name_of(ContactList const& list)
{
    constexpr char const* kinds[] = {"pairs", "walls", "ghosts"};
    return fmt::format("contacts/{}/{}", kinds[static_cast<std::size_t>(list.kind)], list.interaction);
}

template <class Record, class List>
void visit_columns(Record& record, List& list)
{
    std::string const name = name_of(list);
    record(name + "/candidates", list.candidates);
    record(name + "/first", list.first), record(name + "/second", list.second);
    record(name + "/touching", list.touching), record(name + "/state", list.state);
    record(name + "/offset", list.offset), record(name + "/wants_slots", list.wants_slots);
    record(name + "/joined", list.joined), record(name + "/joined_end", list.joined_end);
}

void write_list(RecordWriter& write, ContactList const& list)
{
    visit_columns(write, list);
    TriangleColumns triangles;
    for (NearTriangle const& near : list.near_triangles)
        triangles.triangle.push_back(near.triangle), triangles.due.push_back(near.due);
    PatchColumns patches;
    for (MeshPatch const& p : list.patches) {
        for (auto const number : {p.first_slot, p.slots, p.first_triangle, p.triangles, p.soon})
            patches.numbers.push_back(number);
        patches.dues.push_back(p.due), patches.dues.push_back(p.later_due);
        patches.path.push_back(p.path), patches.seen_at.push_back(p.seen_at);
    }
    triangles.visit(write, name_of(list));
    patches.visit(write, name_of(list));
}

void read_list(RecordReader& read, ContactList& list)
{
    visit_columns(read, list);
    std::size_t const contacts = list.first.size();
    expect_fit(list.second.size() == contacts && list.touching.size() == contacts &&
                   list.state.size() == contacts * static_cast<std::size_t>(list.state_size) &&
                   list.offset.size() == (list.kind == ContactKind::wall ? contacts : 0),
               "a list of contacts has columns of several lengths");
    TriangleColumns triangles;
    triangles.visit(read, name_of(list));
    expect_fit(triangles.triangle.size() == triangles.due.size(), "near triangles");
    for (std::size_t k = 0; k < triangles.due.size(); ++k)
        list.near_triangles.push_back({triangles.triangle[k], triangles.due[k]});
    PatchColumns patches;
    patches.visit(read, name_of(list));
    std::size_t const count = patches.path.size();
    expect_fit(patches.numbers.size() == 5 * count && patches.dues.size() == 2 * count &&
                   patches.seen_at.size() == count,
               "contacts with meshes have columns of several lengths");
    for (std::size_t k = 0; k < count; ++k) {
        std::uint32_t const* n = patches.numbers.data() + 5 * k;
        list.patches.push_back({.first_slot = n[0],
                                .slots = n[1],
                                .first_triangle = n[2],
                                .triangles = n[3],
                                .due = patches.dues[2 * k],
                                .soon = n[4],
                                .later_due = patches.dues[2 * k + 1],
                                .path = patches.path[k],
                                .seen_at = patches.seen_at[k]});
    }
}

//! The fields that are arrays or numbers of one type.
template <class Record, class StateType>
void visit_plain(Record& record, StateType& state)
{
    auto& particles = state.particles;
    record("particles/place", particles.place), record("particles/motion", particles.motion);
    record("particles/load", particles.load), record("particles/material", particles.material);
    record("particles/id", particles.id), record("particles/ghosts", particles.ghosts);
    record("walls/load", state.wall_loads);
    auto& lists = state.lists;
    record("lists/is_stale", lists.is_stale), record("lists/travelled", lists.travelled);
    record("lists/near_until", lists.near_until), record("lists/rebuilds", lists.rebuilds);
    record("lists/reach_of_candidates", lists.reach.candidates);
    record("lists/reach_of_contacts", lists.reach.contacts);
    record("clock/steps_done", state.steps_done), record("clock/particles_added", state.particles_added);
    record("health/left_domain", state.left_domain), record("health/overlapping", state.overlapping);
    record("health/leaping", state.leaping);
    auto& tally = state.tally;
    record("ledger/loads_before", tally.loads_before), record("ledger/work_of_walls", tally.work_of_walls);
    record("ledger/brought_in", tally.brought_in), record("ledger/turned_over", tally.turned_over);
}

//! There only where surroundings are.
template <class Record, class Tally>
void visit_surroundings(Record& record, Tally& tally)
{
    record("ledger/drag_to_come", tally.drag_to_come);
    record("ledger/vibration_to_come", tally.vibration_to_come);
}

constexpr char const* bodies_name = "bodies/pose";

//! There only where bodies are.
template <class Record, class StateType>
void visit_rigid_bodies(Record& record, StateType& state)
{
    record("particles/body", state.particles.body);
    auto& bodies = state.bodies;
    record(bodies_name, bodies.pose), record("bodies/motion", bodies.motion);
    record("bodies/mass", bodies.mass), record("bodies/load", bodies.load);
    record("bodies/elements_end", bodies.elements_end), record("bodies/element", bodies.element);
    record("bodies/arm", bodies.arm), record("bodies/image", bodies.image);
}

//! There only where particles were removed.
constexpr char const* removed = "clock/particles_removed";

constexpr auto losses = std::array{std::pair{"ledger/lost_to_damping", &LossSums::damping},
                                   std::pair{"ledger/lost_to_friction", &LossSums::friction},
                                   std::pair{"ledger/lost_to_rolling", &LossSums::rolling},
                                   std::pair{"ledger/lost_to_cohesion", &LossSums::cohesion}};

void check_bodies(Params const& params, State const& state)
{
    Particles const& particles = state.particles;
    std::size_t const count = particles.size();
    expect_fit(particles.motion.size() == count && particles.load.size() == count &&
                   particles.material.size() == count && particles.id.size() == count &&
                   particles.ghosts <= count,
               "particles have columns of several lengths");
    expect_fit(particles.body.size() == (particles.has_bodies ? count : 0), "particles and their bodies");
    expect_fit(state.bodies.is_whole(count), "bodies and their elements");
    for (std::size_t k = 0; k < count; ++k) {
        expect_fit(particles.is_alone(k) ||
                       particles.body[k] < state.bodies.size() + state.bodies.ghosts.size(),
                   "a particle is of a body that is not there");
        expect_fit(particles.material[k] < params.materials.size(), "a particle has no material");
        expect_fit(particles.id[k] < state.particles_added, "a particle has an id that was not given");
    }
    expect_fit(state.wall_loads.size() == state.walls.size() &&
                   state.tally.loads_before.size() <= state.walls.size(),
               "walls and their loads");
    for (Wall const& wall : state.walls.all())
        expect_fit(wall.material.value < params.materials.size(), "a wall has no material");
    expect_fit(state.steps_done >= 0, "the number of steps is negative");
}

void check_patches(ContactList const& list, std::vector<Wall> const& walls)
{
    for (MeshPatch const& p : list.patches) {
        expect_fit(p.slots > 0 && p.first_slot < list.size() && p.slots <= list.size() - p.first_slot &&
                       p.first_triangle <= list.near_triangles.size() &&
                       p.triangles <= list.near_triangles.size() - p.first_triangle && p.soon <= p.triangles,
                   "a contact with a mesh has no place in its list");
        auto const* mesh = std::get_if<Mesh>(&walls[list.second[p.first_slot]].shape);
        for (std::uint32_t t = 0; t < p.triangles; ++t)
            expect_fit(mesh &&
                           list.near_triangles[p.first_triangle + t].triangle < mesh->mesh->facets().size(),
                       "a contact names a triangle that is not there");
    }
}

void check_joined(ContactList const& list)
{
    for (std::uint32_t const slot : list.joined)
        expect_fit(slot < list.size(), "walls that join name a contact that is not there");
    std::uint32_t before = 0;
    for (std::uint32_t const end : list.joined_end)
        expect_fit(end > std::exchange(before, end) && end <= list.joined.size(),
                   "walls that join are not in order");
}

} // namespace

void write_state(StateRecord& record, Params const& params, State const& state)
{
    write_fit(record, params);
    RecordWriter write(record);
    visit_plain(write, state);
    if (state.particles_removed > 0)
        write(removed, state.particles_removed);
    if (params.options.surroundings.is_any())
        visit_surroundings(write, state.tally);
    if (state.particles.has_bodies)
        visit_rigid_bodies(write, state);
    if (state.particles.has_hulls)
        write_hulls(record, state);
    for (auto const& [name, sums] : losses) {
        auto const& lane = state.tally.losses.*sums;
        write(name, std::vector<double>(std::begin(lane), std::end(lane)));
    }
    RangeColumns ranges;
    for (auto const& range : state.lists.ranges)
        ranges.gap.push_back(range.gap), ranges.needs_contact.push_back(range.needs_contact);
    ranges.visit(write);
    state.walls.save(record);
    state.contacts.for_each([&](ContactList const& list) { write_list(write, list); });
}

State read_state(StateRecord const& record, Params const& params)
{
    check_fit(record, params);
    State state;
    RecordReader read(record);
    visit_plain(read, state);
    if (record.has(removed))
        read(removed, state.particles_removed);
    if (params.options.surroundings.is_any())
        visit_surroundings(read, state.tally);
    state.particles.has_bodies = record.has(bodies_name);
    if (state.particles.has_bodies)
        visit_rigid_bodies(read, state);
    for (auto const& [name, sums] : losses) {
        auto const lane = record.get<double>(name);
        expect_fit(lane.size() == ContactBlock::lanes, "the losses have not as many lanes as a block");
        std::copy(lane.begin(), lane.end(), std::begin(state.tally.losses.*sums));
    }
    RangeColumns ranges;
    ranges.visit(read);
    expect_fit(ranges.gap.size() == ranges.needs_contact.size() &&
                   (ranges.gap.size() == params.laws.size() || (ranges.gap.empty() && state.lists.is_stale)),
               "the ranges of the laws");
    for (std::size_t k = 0; k < ranges.gap.size(); ++k)
        state.lists.ranges.push_back({ranges.gap[k], ranges.needs_contact[k] != 0});
    state.walls = WallSet::restore(record);
    bool const with_ghosts = params.options.team != nullptr;
    for (auto const& layout : params.layouts)
        add_law_set(state, layout, with_ghosts);
    state.contacts.for_each([&](ContactList& list) { read_list(read, list); });
    if (has_hulls(record))
        read_hulls(record, state);
    check_bodies(params, state);
    find_arms(state.bodies);
    return state;
}

void check_contacts(State const& state, ContactNumbers const& numbers)
{
    std::size_t const particles = numbers.owned + numbers.ghost_ids.size();
    expect_fit(state.lists.is_stale || particles == state.particles.size(),
               "contacts are of another number of particles");
    auto const& walls = state.walls.all();
    state.contacts.for_each([&](ContactList const& list) {
        std::size_t const seconds = list.kind == ContactKind::wall ? walls.size() : particles;
        for (std::size_t s = 0; s < list.size(); ++s)
            expect_fit(list.first[s] < particles && list.second[s] < seconds,
                       "a contact names a body that is not there");
        for (auto const& [first, second] : list.candidates)
            expect_fit(first < particles && second < particles, "a pair names a particle that is not there");
        check_patches(list, walls);
        check_joined(list);
    });
    check_hulls(state, numbers);
}

} // namespace demens::dem
