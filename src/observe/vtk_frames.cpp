#include "demens/observe/vtk_frames.hpp"

#include "demens/base/error.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>

namespace demens::observe {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

namespace {

//! An XML PolyData file with its arrays as raw bytes at the end (VTK file formats, "appended" data).
class PolyData
{
  public:
    PolyData(std::size_t points, double time) : points_(points), time_(time) {}

    void set_points(std::vector<float> const& xyz) { points_xml_ = array("Points", 3, xyz); }
    void add_point_data(std::string const& name, int components, std::vector<float> const& values)
    {
        point_data_xml_ += array(name, components, values);
    }
    void add_numbers(std::string const& name, std::vector<std::int64_t> const& values)
    {
        point_data_xml_ += array(name, 1, values);
    }
    //! `kind` is Verts or Polys; cell i has the points from end i - 1 to end i.
    void set_cells(std::string const& kind, std::vector<std::int64_t> const& connectivity,
                   std::vector<std::int64_t> const& ends)
    {
        cells_ = ends.size();
        cells_kind_ = kind;
        cells_xml_ = array("connectivity", 1, connectivity) + array("offsets", 1, ends);
    }
    void write(std::filesystem::path const& file) const;

  private:
    template <typename T>
    std::string array(std::string const& name, int components, std::vector<T> const& values)
    {
        std::uint64_t const offset = bytes_.size(), length = values.size() * sizeof(T);
        append(&length, sizeof(length));
        append(values.data(), length);
        return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
                           "offset=\"{}\"/>\n",
                           sizeof(T) == 4 ? "Float32" : "Int64", name, components, offset);
    }
    void append(void const* data, std::size_t size) { bytes_.append(static_cast<char const*>(data), size); }

    std::size_t points_, cells_ = 0;
    double time_;
    std::string points_xml_, point_data_xml_, cells_kind_, cells_xml_;
    std::string bytes_;
};

void write_file(std::filesystem::path const& file, std::string const& content)
{
    std::ofstream out(file, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out)
        throw InputError(
            fmt::format("{}: a frame cannot be written; give a folder that is writable and has room "
                        "for it ({} bytes)",
                        file.string(), content.size()));
}

void PolyData::write(std::filesystem::path const& file) const
{
    std::string const count = fmt::format("NumberOf{}=\"{}\"", cells_kind_, cells_);
    write_file(
        file, fmt::format(
                  "<?xml version=\"1.0\"?>\n"
                  "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                  "header_type=\"UInt64\">\n<PolyData>\n"
                  "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                  "format=\"ascii\">{}</DataArray></FieldData>\n"
                  "<Piece NumberOfPoints=\"{}\" {}>\n<Points>\n{}</Points>\n<PointData>\n{}</PointData>\n"
                  "<{}>\n{}</{}>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
                  time_, points_, count, points_xml_, point_data_xml_, cells_kind_, cells_xml_, cells_kind_) +
                  bytes_ + "\n</AppendedData>\n</VTKFile>\n");
}

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

PolyData particles_of(Snapshot const& snapshot)
{
    std::size_t const count = snapshot.x.size();
    PolyData data(count, snapshot.time);
    data.set_points(interleaved(snapshot.x, snapshot.y, snapshot.z));
    data.add_point_data("radius", 1, {snapshot.radius.begin(), snapshot.radius.end()});
    if (snapshot.vx.size() == count)
        data.add_point_data("velocity", 3, interleaved(snapshot.vx, snapshot.vy, snapshot.vz));
    if (snapshot.wx.size() == count)
        data.add_point_data("angular_velocity", 3, interleaved(snapshot.wx, snapshot.wy, snapshot.wz));
    if (!snapshot.grain.empty())
        data.add_numbers("grain", snapshot.grain);
    std::vector<std::int64_t> points(count), ends(count);
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = static_cast<std::int64_t>(i);
        ends[i] = points[i] + 1;
    }
    data.set_cells("Verts", points, ends);
    return data;
}

//! The faces of axis-aligned boxes; of a flat box, the one face that it is. Then the triangles of other
//! walls.
PolyData walls_of(Snapshot const& snapshot)
{
    std::vector<float> corners;
    std::vector<std::int64_t> faces, ends;
    for (auto const& wall : snapshot.walls) {
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
            }
        }
    }
    for (auto const& triangle : snapshot.wall_triangles) {
        for (int corner = 0; corner < 3; ++corner)
            faces.push_back(static_cast<std::int64_t>(corners.size() / 3) + corner);
        for (double const value : triangle)
            corners.push_back(static_cast<float>(value));
        ends.push_back(static_cast<std::int64_t>(faces.size()));
    }
    PolyData data(corners.size() / 3, snapshot.time);
    data.set_points(corners);
    data.set_cells("Polys", faces, ends);
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
}

void VtkFrames::write(Snapshot const& snapshot)
{
    particles_of(snapshot).write(folder_ / frame_name("particles", size()));
    walls_of(snapshot).write(folder_ / frame_name("walls", size()));
    times_.push_back(snapshot.time);
    write_collection("particles");
    write_collection("walls");
}

void VtkFrames::write_collection(std::string const& name) const
{
    std::string entries;
    for (std::size_t frame = 0; frame < times_.size(); ++frame)
        entries +=
            fmt::format("<DataSet timestep=\"{}\" file=\"{}\"/>\n", times_[frame], frame_name(name, frame));
    write_file(
        folder_ / (name + ".pvd"),
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n" +
            entries + "</Collection>\n</VTKFile>\n");
}

} // namespace demens::observe
