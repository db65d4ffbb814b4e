#include "demens/observe/vtk_frames.hpp"

#include "demens/base/error.hpp"
#include "demens/observe/hull_surface.hpp"
#include "src/observe/contact_numbers.hpp"
#include "src/observe/poly_data.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace demens::observe {

namespace {

std::vector<float> interleaved(std::vector<double> const& x, std::vector<double> const& y,
                               std::vector<double> const& z)
{
    std::vector<float> xyz;
    xyz.reserve(3 * x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        for (double value : {x[i], y[i], z[i]})
            xyz.push_back(static_cast<float>(value));
    return xyz;
}

//! What the numbers of an array stand for, where it is known.
void add_names(PolyData& data, std::string const& name, std::vector<std::string> const& names)
{
    if (!names.empty())
        data.add_words(name, names);
}

PolyData particles_of(Snapshot const& snapshot)
{
    std::size_t const count = snapshot.x.size();
    PolyData data(count, snapshot.time);
    data.set_points(interleaved(snapshot.x, snapshot.y, snapshot.z));
    data.add_point_data("radius", 1, std::vector<float>(snapshot.radius.begin(), snapshot.radius.end()));
    if (snapshot.vx.size() == count)
        data.add_point_data("velocity", 3, interleaved(snapshot.vx, snapshot.vy, snapshot.vz));
    if (snapshot.wx.size() == count)
        data.add_point_data("angular_velocity", 3, interleaved(snapshot.wx, snapshot.wy, snapshot.wz));
    if (!snapshot.grain.empty())
        data.add_point_data("grain", 1, snapshot.grain);
    if (!snapshot.hull.empty()) {
        std::vector<std::int64_t> hull; // -1: within one
        for (std::uint32_t const part : snapshot.hull)
            hull.push_back(part == Snapshot::within_a_hull ? -1 : std::int64_t{part});
        data.add_point_data("hull", 1, hull);
    }
    if (snapshot.fx.size() == count)
        data.add_point_data("force", 3, interleaved(snapshot.fx, snapshot.fy, snapshot.fz));
    if (snapshot.mass.size() == count)
        data.add_point_data("mass", 1, std::vector<float>(snapshot.mass.begin(), snapshot.mass.end()));
    if (snapshot.material.size() == count)
        data.add_point_data("material", 1,
                            std::vector<std::int64_t>(snapshot.material.begin(), snapshot.material.end()));
    if (snapshot.group.size() == count && !snapshot.names.groups.empty())
        data.add_point_data("group", 1, snapshot.group);
    add_names(data, "material_names", snapshot.names.materials);
    add_names(data, "group_names", snapshot.names.groups);
    data.add_point_data("contacts", 1, contact_numbers(snapshot));
    std::vector<std::int64_t> points(count), ends(count);
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = static_cast<std::int64_t>(i);
        ends[i] = points[i] + 1;
    }
    data.add_point_data("id", 1,
                        snapshot.id.size() == count
                            ? std::vector<std::int64_t>(snapshot.id.begin(), snapshot.id.end())
                            : points);
    data.set_cells("Verts", points, ends);
    return data;
}

//! A box of a wall cut to the particles with room around them, where it is endless: reaches beyond a
//! kilometre.
std::array<double, 6> cut(std::array<double, 6> wall, Snapshot const& snapshot)
{
    constexpr double endless = 1e3; // [m]
    std::array<std::vector<double> const*, 3> const columns = {&snapshot.x, &snapshot.y, &snapshot.z};
    if (snapshot.x.empty())
        return wall;
    double size = 2 * *std::max_element(snapshot.radius.begin(), snapshot.radius.end());
    for (auto const* column : columns) {
        auto const [least, most] = std::minmax_element(column->begin(), column->end());
        size = std::max(size, *most - *least);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (wall[axis + 3] - wall[axis] < endless)
            continue;
        auto const [least, most] = std::minmax_element(columns[axis]->begin(), columns[axis]->end());
        wall[axis] = std::max(wall[axis], *least - size);
        wall[axis + 3] = std::min(wall[axis + 3], *most + size);
    }
    return wall;
}

//! The faces of axis-aligned boxes; of a flat box, the one face that it is. Then the triangles of other
//! walls.
PolyData walls_of(Snapshot const& snapshot)
{
    std::vector<float> corners;
    std::vector<std::int64_t> faces, ends, numbers;
    auto const number_of = [](std::vector<std::int64_t> const& known, std::size_t k) {
        return k < known.size() ? known[k] : -1;
    };
    for (std::size_t k = 0; k < snapshot.walls.size(); ++k) {
        auto const wall = cut(snapshot.walls[k], snapshot);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::size_t const u = (axis + 1) % 3, v = (axis + 2) % 3;
            if (wall[u] == wall[u + 3] || wall[v] == wall[v + 3])
                continue; // no area in this direction
            bool const flat = wall[axis] == wall[axis + 3];
            for (std::size_t side = 0; side < (flat ? 1 : 2); ++side) {
                for (auto [at_u, at_v] : {std::array{u, v}, {u + 3, v}, {u + 3, v + 3}, {u, v + 3}}) {
                    std::array<double, 3> corner;
                    corner[axis] = wall[axis + 3 * side];
                    corner[u] = wall[at_u];
                    corner[v] = wall[at_v];
                    faces.push_back(static_cast<std::int64_t>(corners.size() / 3));
                    for (double value : corner)
                        corners.push_back(static_cast<float>(value));
                }
                ends.push_back(static_cast<std::int64_t>(faces.size()));
                numbers.push_back(number_of(snapshot.wall_of_box, k));
            }
        }
    }
    for (std::size_t k = 0; k < snapshot.wall_triangles.size(); ++k) {
        for (int corner = 0; corner < 3; ++corner)
            faces.push_back(static_cast<std::int64_t>(corners.size() / 3) + corner);
        for (double const value : snapshot.wall_triangles[k])
            corners.push_back(static_cast<float>(value));
        ends.push_back(static_cast<std::int64_t>(faces.size()));
        numbers.push_back(number_of(snapshot.wall_of_triangle, k));
    }
    PolyData data(corners.size() / 3, snapshot.time);
    data.set_points(corners);
    data.set_cells("Polys", faces, ends);
    data.add_cell_data("wall", 1, numbers);
    add_names(data, "wall_names", snapshot.names.walls);
    return data;
}

//! The grains that are hulls, as they are.
PolyData hulls_of(Snapshot const& snapshot)
{
    Polygons const polygons = hull_surfaces(snapshot);
    std::vector<float> corners;
    for (Vector3 const& corner : polygons.corners)
        for (double const value : {corner.x, corner.y, corner.z})
            corners.push_back(static_cast<float>(value));
    PolyData data(polygons.corners.size(), snapshot.time);
    data.set_points(corners);
    data.set_cells("Polys", polygons.faces, polygons.ends);
    // Of what is the same for all of a grain: where the first of its corners is among the particles.
    std::vector<std::int64_t> grain, material;
    std::vector<std::size_t> first;
    for (std::size_t k = snapshot.hull.size(); k-- > 0;) {
        std::uint32_t const hull = snapshot.hull[k];
        if (hull == Snapshot::no_hull || hull == Snapshot::within_a_hull)
            continue;
        first.resize(std::max<std::size_t>(first.size(), hull));
        first[hull - 1] = k;
    }
    for (std::int64_t const body : polygons.body) {
        std::size_t const k = first[static_cast<std::size_t>(body)];
        grain.push_back(k < snapshot.grain.size() ? snapshot.grain[k] : body);
        material.push_back(k < snapshot.material.size() ? snapshot.material[k] : -1);
    }
    data.add_cell_data("grain", 1, grain);
    data.add_cell_data("material", 1, material);
    add_names(data, "material_names", snapshot.names.materials);
    return data;
}

std::string frame_name(std::string const& name, std::size_t frame)
{
    return fmt::format("{}_{:06}.vtp", name, frame);
}

} // namespace

VtkFrames::VtkFrames(std::filesystem::path folder) : folder_(std::move(folder))
{
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (!std::filesystem::is_directory(folder_))
        throw InputError(
            fmt::format("{}: not a folder and cannot be made one ({}); frames need a folder of their own",
                        folder_.string(), error.message()));
    // Frames of an earlier call would be shown with the new ones.
    for (char const* name : {"particles", "walls", "hulls"})
        for (std::size_t frame = 0; std::filesystem::remove(folder_ / frame_name(name, frame), error);
             ++frame)
            ;
}

void VtkFrames::write(Snapshot const& snapshot)
{
    particles_of(snapshot).write(folder_ / frame_name("particles", size()));
    walls_of(snapshot).write(folder_ / frame_name("walls", size()));
    if (!snapshot.hull.empty() && !first_with_hulls_)
        first_with_hulls_ = size();
    if (first_with_hulls_)
        hulls_of(snapshot).write(folder_ / frame_name("hulls", size()));
    times_.push_back(snapshot.time);
    write_collection("particles", 0);
    write_collection("walls", 0);
    if (first_with_hulls_)
        write_collection("hulls", *first_with_hulls_);
}

std::string VtkFrames::told() const
{
    auto const folder = folder_.string();
    auto const more = first_with_hulls_
                          ? fmt::format("; polyhedra are in {}/hulls.pvd, their balls have hull != 0", folder)
                          : std::string();
    return fmt::format(
        "{} frames; open {}/particles.pvd in ParaView (Representation: Point Gaussian, scaled by "
        "radius){}",
        size(), folder, more);
}

void VtkFrames::write_collection(std::string const& name, std::size_t from) const
{
    std::string entries;
    for (std::size_t frame = from; frame < times_.size(); ++frame)
        entries +=
            fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", times_[frame], frame_name(name, frame));
    write_frame_file(
        folder_ / (name + ".pvd"),
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n" +
            entries + "</Collection>\n</VTKFile>\n");
}

} // namespace demens::observe
