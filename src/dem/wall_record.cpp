// The walls in the record of a simulation.
#include "demens/base/contract.hpp"
#include "demens/dem/record_fields.hpp"
#include "src/dem/wall_set.hpp"

#include <array>
#include <cmath>
#include <span>
#include <type_traits>

namespace demens::dem {
namespace {

//! The same number of the same number of columns for all kinds: a row of numbers that is written or read.
template <std::size_t columns>
struct Row
{
    std::array<double, columns> numbers{};
};

//! What is done with the numbers of a shape or a motion, whatever they mean.
template <class Each>
struct OfNumbers
{
    Each each; //!< number

    void number(auto& x) { each(x); }
    void direction(auto& v) { each(v.x), each(v.y), each(v.z); }
    void point(auto& p) { direction(p); }
    void placement(auto& p)
    {
        direction(p.rotation.x), direction(p.rotation.y), direction(p.rotation.z), point(p.shift);
    }
    void side(RoundSide& side)
    {
        auto number = static_cast<double>(side);
        each(number);
        if (!(number >= 0 && number <= 3 && number == std::floor(number)))
            throw InputError("the state record has a wall that is touched on a side that there is not");
        side = static_cast<RoundSide>(number);
    }
};

template <class Each>
OfNumbers(Each) -> OfNumbers<Each>;

using ShapeRow = Row<12>;
using MotionRow = Row<9>;

template <class Variant, class RowType>
void write_row(Variant value, RowType& row)
{
    auto to = row.numbers.begin();
    auto const write = [&](double x) {
        DEMENS_EXPECT(to != row.numbers.end(), "a row has as many columns as a shape has numbers");
        *to++ = x;
    };
    std::visit([&](auto& alternative) { fields(alternative, OfNumbers{write}); }, value);
}
//! \throws InputError for a kind that there is not.
template <class Variant, class RowType>
Variant read_row(std::uint32_t kind, RowType const& row)
{
    Variant value;
    bool found = false;
    auto from = row.numbers.begin();
    auto const read = [&](double& x) { x = *from++; };
    auto const try_kind = [&]<std::size_t k>() {
        if (kind != k)
            return;
        found = true;
        fields(value.template emplace<k>(), OfNumbers{read});
    };
    [&]<std::size_t... k>(std::index_sequence<k...>)
    {
        (try_kind.template operator()<k>(), ...);
    }
    (std::make_index_sequence<std::variant_size_v<Variant>>());
    expect_fit(found, "a wall has a shape or a motion of an unknown kind");
    return value;
}

//! Columns of shapes, of walls or of what walls were before they were moved.
struct Shapes
{
    std::vector<std::uint32_t> kind, mesh; //!< `mesh`: number of the mesh where the kind is one
    std::vector<ShapeRow> row;

    template <class Record>
    void visit_all(Record& record, std::string const& name)
    {
        record(name + "/shape_kind", kind), record(name + "/shape", row), record(name + "/mesh", mesh);
    }
};

using MeshPointer = std::shared_ptr<shape::TriangleMesh const>;

void add_shape(Shapes& shapes, WallShape const& shape, std::vector<MeshPointer>& meshes)
{
    shapes.kind.push_back(static_cast<std::uint32_t>(shape.index()));
    write_row(shape, shapes.row.emplace_back());
    shapes.mesh.push_back(0);
    if (auto const* mesh = std::get_if<Mesh>(&shape)) {
        auto const known = std::find(meshes.begin(), meshes.end(), mesh->mesh);
        shapes.mesh.back() = static_cast<std::uint32_t>(known - meshes.begin());
        if (known == meshes.end())
            meshes.push_back(mesh->mesh);
    }
}

WallShape shape_at(Shapes const& shapes, std::size_t k, std::vector<MeshPointer> const& meshes)
{
    auto shape = read_row<WallShape>(shapes.kind[k], shapes.row[k]);
    if (auto* mesh = std::get_if<Mesh>(&shape)) {
        expect_fit(shapes.mesh[k] < meshes.size(), "a wall names a mesh that is not there");
        mesh->mesh = meshes[shapes.mesh[k]];
    }
    return shape;
}

//! Columns of walls.
struct WallColumns
{
    Shapes shapes;
    std::vector<std::uint32_t> material;
    std::vector<std::uint8_t> active;
    std::vector<Vector3> velocity, spin, pivot, belt;

    template <class Record>
    void visit_all(Record& record)
    {
        shapes.visit_all(record, "walls");
        record("walls/material", material), record("walls/active", active);
        record("walls/velocity", velocity), record("walls/spin", spin);
        record("walls/pivot", pivot), record("walls/belt", belt);
    }
    bool has_rows(std::size_t rows) const
    {
        return shapes.row.size() == rows && shapes.mesh.size() == rows && material.size() == rows &&
               active.size() == rows && velocity.size() == rows && spin.size() == rows &&
               pivot.size() == rows && belt.size() == rows;
    }
};

//! Columns of moved walls, and of their motions one after another.
struct MotionColumns
{
    Shapes shapes;
    std::vector<Vector3> pivot;
    std::vector<std::uint32_t> wall, motions, spinning; //!< of each moved wall; `motions`: how many
    std::vector<std::uint32_t> kind;
    std::vector<MotionRow> row;
    std::vector<double> start, end; //!< [s]

    template <class Record>
    void visit_all(Record& record)
    {
        shapes.visit_all(record, "moved_walls");
        record("moved_walls/pivot", pivot), record("moved_walls/wall", wall);
        record("moved_walls/motions", motions), record("moved_walls/spinning", spinning);
        record("motions/kind", kind), record("motions/numbers", row);
        record("motions/start", start), record("motions/end", end);
    }
    bool has_rows(std::size_t moved) const
    {
        std::size_t all = 0;
        for (auto const count : motions)
            all += count;
        return shapes.row.size() == moved && shapes.kind.size() == moved && shapes.mesh.size() == moved &&
               pivot.size() == moved && motions.size() == moved && spinning.size() == moved &&
               kind.size() == all && row.size() == all && start.size() == all && end.size() == all;
    }
};

std::string mesh_name(std::size_t number, char const* what)
{
    return fmt::format("meshes/{}/{}", number, what);
}

void write_meshes(StateRecord& record, std::vector<MeshPointer> const& meshes)
{
    RecordWriter write(record);
    write("meshes/count", meshes.size());
    for (std::size_t k = 0; k < meshes.size(); ++k) {
        auto const parts = meshes[k]->parts();
        write(mesh_name(k, "vertices"), parts.vertices);
        write(mesh_name(k, "bounds"), std::vector{parts.bounds.lower, parts.bounds.upper});
        std::vector<std::uint32_t> corners;
        for (auto const& triangle : parts.triangles)
            corners.insert(corners.end(), triangle.begin(), triangle.end());
        write(mesh_name(k, "triangles"), corners);
    }
}

std::vector<MeshPointer> read_meshes(StateRecord const& record)
{
    RecordReader read(record);
    std::size_t count = 0;
    read("meshes/count", count);
    std::vector<MeshPointer> meshes;
    for (std::size_t k = 0; k < count; ++k) {
        shape::TriangleMesh::Parts parts;
        std::vector<std::uint32_t> corners;
        std::vector<Vector3> bounds;
        read(mesh_name(k, "vertices"), parts.vertices), read(mesh_name(k, "triangles"), corners);
        read(mesh_name(k, "bounds"), bounds);
        expect_fit(corners.size() % 3 == 0 && bounds.size() == 2, "a mesh has no whole triangles");
        for (std::size_t c = 0; c < corners.size(); c += 3)
            parts.triangles.push_back({corners[c], corners[c + 1], corners[c + 2]});
        parts.bounds = {bounds[0], bounds[1]};
        meshes.push_back(std::make_shared<shape::TriangleMesh const>(shape::TriangleMesh::from_parts(parts)));
    }
    return meshes;
}

} // namespace

template <std::size_t columns>
struct RecordRow<Row<columns>>
{
    using Element = double;
};

void WallSet::save(StateRecord& record) const
{
    std::vector<MeshPointer> meshes;
    WallColumns columns;
    for (Wall const& wall : walls_) {
        add_shape(columns.shapes, wall.shape, meshes);
        columns.material.push_back(wall.material.value);
        columns.active.push_back(wall.active);
        columns.velocity.push_back(wall.velocity), columns.spin.push_back(wall.spin);
        columns.pivot.push_back(wall.pivot), columns.belt.push_back(wall.belt);
    }
    MotionColumns moved;
    for (auto const& [number, wall] : motions_) {
        auto const& parts = wall.parts();
        add_shape(moved.shapes, parts.shape, meshes);
        moved.pivot.push_back(parts.pivot);
        moved.wall.push_back(number);
        moved.motions.push_back(static_cast<std::uint32_t>(parts.motions.size()));
        moved.spinning.push_back(static_cast<std::uint32_t>(parts.spinning));
        for (WallMotion const& motion : parts.motions) {
            moved.kind.push_back(static_cast<std::uint32_t>(motion.law.index()));
            write_row(motion.law, moved.row.emplace_back());
            moved.start.push_back(motion.start), moved.end.push_back(motion.end);
        }
    }
    write_meshes(record, meshes);
    RecordWriter write(record);
    columns.visit_all(write);
    moved.visit_all(write);
}

WallSet WallSet::restore(StateRecord const& record)
{
    auto const meshes = read_meshes(record);
    RecordReader read(record);
    WallColumns columns;
    MotionColumns moved;
    columns.visit_all(read);
    moved.visit_all(read);
    expect_fit(columns.has_rows(columns.shapes.kind.size()), "the walls have columns of several lengths");
    expect_fit(moved.has_rows(moved.wall.size()), "the motions of walls have columns of several lengths");

    WallSet set;
    for (std::size_t k = 0; k < columns.material.size(); ++k)
        set.add({.shape = shape_at(columns.shapes, k, meshes),
                 .material = MaterialId{columns.material[k]},
                 .velocity = columns.velocity[k],
                 .spin = columns.spin[k],
                 .pivot = columns.pivot[k],
                 .belt = columns.belt[k],
                 .active = columns.active[k] != 0});
    std::size_t motion = 0;
    for (std::size_t k = 0; k < moved.wall.size(); ++k) {
        expect_fit(moved.wall[k] < set.size(), "a wall that moves is not there");
        expect_fit(moved.spinning[k] <= moved.motions[k], "a wall has fewer motions than leave its place");
        MovedWall::Parts parts{shape_at(moved.shapes, k, meshes), moved.pivot[k], {}, moved.spinning[k]};
        for (std::uint32_t m = 0; m < moved.motions[k]; ++m, ++motion)
            parts.motions.push_back(
                {read_row<decltype(WallMotion::law)>(moved.kind[motion], moved.row[motion]),
                 moved.start[motion], moved.end[motion]});
        set.motions_.insert_or_assign(moved.wall[k], MovedWall(std::move(parts)));
    }
    return set;
}

} // namespace demens::dem
