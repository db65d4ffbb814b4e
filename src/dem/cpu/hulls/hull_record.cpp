#include "src/dem/cpu/hulls/hull_record.hpp"

#include "demens/dem/record_fields.hpp"
#include "src/dem/cpu/hulls/hull_wall_finder.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace demens::dem {
namespace {

constexpr char const* shapes_name = "bodies/hull_shapes";
constexpr char const* kinds[] = {"pairs", "walls", "ghosts"};

//! A list of contacts as columns.
struct Columns
{
    std::vector<std::uint32_t> numbers, memories; //!< two, and eight, of each pair
    std::vector<float> normals;                   //!< three of each pair
    std::vector<std::uint32_t> contacts;          //!< two of each contact
    std::vector<double> places;                   //!< ten of each contact

    template <class Record, class State>
    void visit(Record const& record, HullContactList const& list, State& state)
    {
        std::string const name =
            fmt::format("hulls/{}/{}/", kinds[static_cast<std::size_t>(list.kind)], list.interaction);
        record(name + "numbers", numbers), record(name + "memories", memories);
        record(name + "normals", normals), record(name + "contacts", contacts);
        record(name + "places", places), record(name + "state", state);
    }
};

Columns columns_of(HullContactList const& list)
{
    Columns columns;
    for (HullPair const& pair : list.pairs) {
        grain::PairMemory const& m = pair.memory;
        for (std::uint32_t const number : {pair.first, pair.second})
            columns.numbers.push_back(number);
        for (std::uint16_t const number :
             {m.a[0], m.a[1], m.a[2], m.b[0], m.b[1], m.b[2], m.size, m.was_near})
            columns.memories.push_back(number);
        columns.normals.insert(columns.normals.end(), std::begin(m.normal), std::end(m.normal));
    }
    for (HullContact const& contact : list.contacts) {
        columns.contacts.push_back(contact.pair), columns.contacts.push_back(contact.feature);
        columns.places.push_back(contact.share);
        for (Vector3 const& v : {contact.apart, contact.arm_first, contact.arm_second})
            for (double const component : {v.x, v.y, v.z})
                columns.places.push_back(component);
    }
    return columns;
}

void fill(HullContactList& list, Columns const& columns)
{
    std::size_t const pairs = columns.numbers.size() / 2, contacts = columns.contacts.size() / 2;
    expect_fit(columns.numbers.size() == 2 * pairs && columns.memories.size() == 8 * pairs &&
                   columns.normals.size() == 3 * pairs && columns.contacts.size() == 2 * contacts &&
                   columns.places.size() == 10 * contacts &&
                   list.state.size() == contacts * static_cast<std::size_t>(list.state_size),
               "contacts of hulls have columns of several lengths");
    for (std::size_t k = 0; k < pairs; ++k) {
        HullPair pair{columns.numbers[2 * k], columns.numbers[2 * k + 1]};
        std::uint32_t const* from = columns.memories.data() + 8 * k;
        auto const next = [&] { return static_cast<std::uint16_t>(*from++); };
        for (auto* corners : {&pair.memory.a, &pair.memory.b})
            for (std::uint16_t& corner : *corners)
                corner = next();
        pair.memory.size = next(), pair.memory.was_near = next();
        std::copy_n(columns.normals.data() + 3 * k, 3, pair.memory.normal);
        list.pairs.push_back(pair);
    }
    for (std::size_t k = 0; k < contacts; ++k) {
        double const* p = columns.places.data() + 10 * k;
        list.contacts.push_back({columns.contacts[2 * k],
                                 columns.contacts[2 * k + 1],
                                 p[0],
                                 {p[1], p[2], p[3]},
                                 {p[4], p[5], p[6]},
                                 {p[7], p[8], p[9]}});
    }
}

//! Corners, and corners of faces, of a core; the balls and moments that go with it.
struct ShapeColumns
{
    std::vector<Vector3> vertices;
    std::vector<std::uint32_t> face_sizes, corners;
    std::vector<double> balls; //!< four of each
    std::vector<double> inertia;
    double rounding = 0;

    template <class Record>
    void visit(Record const& record)
    {
        record("vertices", vertices), record("face_sizes", face_sizes), record("corners", corners);
        record("balls", balls), record("inertia", inertia), record("rounding", rounding);
    }
};

void write_shape(RecordWriter const& write, grain::BodyShape const& shape)
{
    grain::Hull const& core = shape.hull->core;
    ShapeColumns columns;
    columns.vertices = core.vertices(), columns.rounding = shape.hull->rounding;
    for (grain::HullFace const& face : core.faces())
        columns.face_sizes.push_back(face.size);
    columns.corners.assign(core.all_corners().begin(), core.all_corners().end());
    for (auto const& [place, radius] : shape.balls)
        for (double const number : {place.x, place.y, place.z, radius})
            columns.balls.push_back(number);
    columns.inertia = {shape.inertia.x, shape.inertia.y, shape.inertia.z};
    columns.visit(write);
}

grain::BodyShape read_shape(RecordReader const& read)
{
    ShapeColumns columns;
    columns.visit(read);
    bool fits = columns.inertia.size() == 3 && columns.balls.size() % 4 == 0 && !columns.balls.empty() &&
                columns.vertices.size() >= 4 && columns.vertices.size() <= grain::most_vertices &&
                columns.face_sizes.size() >= 4 && columns.rounding > 0;
    std::vector<std::vector<std::uint16_t>> faces;
    auto corner = columns.corners.begin();
    for (std::uint32_t const size : columns.face_sizes) {
        fits &= size >= 3 && size <= static_cast<std::size_t>(columns.corners.end() - corner);
        expect_fit(fits, "a hull");
        faces.emplace_back();
        for (std::uint32_t k = 0; k < size; ++k, ++corner) {
            expect_fit(*corner < columns.vertices.size(),
                       "a face of a hull names a corner that is not there");
            faces.back().push_back(static_cast<std::uint16_t>(*corner));
        }
    }
    expect_fit(fits && corner == columns.corners.end(), "a hull");
    grain::BodyShape shape{{}, {columns.inertia[0], columns.inertia[1], columns.inertia[2]}};
    for (std::size_t k = 0; k < columns.balls.size(); k += 4)
        shape.balls.push_back(
            {{columns.balls[k], columns.balls[k + 1], columns.balls[k + 2]}, columns.balls[k + 3]});
    shape.hull = grain::RoundedHull{grain::Hull(std::move(columns.vertices), faces), columns.rounding};
    return shape;
}

template <class Record, class Ghosts>
void visit_ghosts(Record const& record, Ghosts& ghosts)
{
    record("bodies/ghosts/orientation", ghosts.orientation), record("bodies/ghosts/radius", ghosts.radius);
    record("bodies/ghosts/shape", ghosts.shape);
}

std::string name_of_shape(std::size_t number)
{
    return fmt::format("bodies/hull_shape/{}/", number);
}

} // namespace

void write_hulls(StateRecord& record, State const& state)
{
    RecordWriter const write(record);
    write("particles/hull", state.particles.hull), write("bodies/hull", state.bodies.hull);
    auto const& shapes = state.bodies.hull_shapes;
    write.count(shapes_name, shapes);
    for (std::size_t k = 0; k < shapes.size(); ++k)
        write_shape(RecordWriter(record, name_of_shape(k)), *shapes[k]);
    if (!state.hulls.ghosts.empty())
        visit_ghosts(write, state.bodies.ghosts);
    state.hulls.for_each(
        [&](HullContactList const& list) { columns_of(list).visit(write, list, list.state); });
}

bool has_hulls(StateRecord const& record)
{
    return record.has(shapes_name);
}

void read_hulls(StateRecord const& record, State& state)
{
    RecordReader const read(record);
    state.particles.has_hulls = true;
    read("particles/hull", state.particles.hull), read("bodies/hull", state.bodies.hull);
    auto& shapes = state.bodies.hull_shapes;
    read.count(shapes_name, shapes);
    for (std::size_t k = 0; k < shapes.size(); ++k)
        shapes[k] =
            std::make_shared<grain::BodyShape const>(read_shape(RecordReader(record, name_of_shape(k))));
    if (!state.hulls.ghosts.empty())
        visit_ghosts(read, state.bodies.ghosts);
    state.hulls.for_each([&](HullContactList& list) {
        Columns columns;
        columns.visit(read, list, list.state);
        fill(list, columns);
    });
}

void check_hulls(State const& state, ContactNumbers const& numbers)
{
    Particles const& particles = state.particles;
    expect_fit(particles.hull.size() == (particles.has_hulls ? particles.size() : 0), "particles and hulls");
    for (std::size_t k = 0; k < particles.size(); ++k)
        expect_fit(particles.is_hull(k) ==
                       (!particles.is_alone(k) && state.bodies.is_hull(particles.body[k])),
                   "a particle and its hull");
    std::size_t const known = numbers.owned + numbers.ghost_ids.size();
    // A ghost of lists that are to be made anew is not among the particles any more.
    std::size_t const seen = state.lists.is_stale ? numbers.owned : known;
    auto const vertices = [&](std::uint32_t particle) -> std::size_t {
        return particle >= seen ? grain::most_vertices
               : particles.is_hull(particle)
                   ? state.bodies.hull_shape(particles.body[particle]).hull->core.vertices().size()
                   : 1;
    };
    auto const are_below = [](auto const& corners, std::size_t end) {
        return std::all_of(std::begin(corners), std::end(corners), [&](auto n) { return n < end; });
    };
    state.hulls.for_each([&](HullContactList const& list) {
        std::size_t const seconds = list.with_walls() ? state.walls.size() : known;
        for (HullPair const& pair : list.pairs)
            expect_fit(pair.first < known && pair.second < seconds &&
                           (pair.first >= seen || particles.is_hull(pair.first)) && pair.memory.size <= 3 &&
                           are_below(pair.memory.a, vertices(pair.first)) &&
                           are_below(pair.memory.b,
                                     list.with_walls()
                                         ? HullWallFinder::corners_of(state.walls.all()[pair.second].shape)
                                         : vertices(pair.second)),
                       "a contact names a hull that is not there");
        std::uint32_t before = 0;
        for (HullContact const& contact : list.contacts)
            expect_fit(contact.pair < list.pairs.size() &&
                           contact.pair >= std::exchange(before, contact.pair),
                       "contacts of hulls are not in order");
    });
}

} // namespace demens::dem
