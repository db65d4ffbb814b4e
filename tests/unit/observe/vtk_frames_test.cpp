#include "demens/observe/vtk_frames.hpp"

#include "demens/base/error.hpp"
#include "demens/observe/hull_surface.hpp"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

namespace demens::observe {

namespace {

class VtkFramesTest : public testing::Test
{
  protected:
    VtkFramesTest()
    {
        std::string name = std::filesystem::temp_directory_path() / "demens-vtk-XXXXXX";
        folder = mkdtemp(name.data());
    }
    ~VtkFramesTest() override { std::filesystem::remove_all(folder); }

    std::string content(std::string const& file) const
    {
        std::stringstream text;
        text << std::ifstream(folder / file, std::ios::binary).rdbuf();
        return text.str();
    }

    std::filesystem::path folder;
};

//! Reads an array as the VTK file format describes it: base64 of the length as 64 bits and the values.
template <typename T>
std::vector<T> array_of(std::string const& file, std::string const& name)
{
    std::smatch match;
    if (!std::regex_search(file, match,
                           std::regex("Name=\"" + name + "\"[^>]*format=\"binary\">\\s*([A-Za-z0-9+/=]*)")))
        return {};
    std::string const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/",
                      text = match[1];
    std::string bytes;
    unsigned word = 0;
    int bits = 0;
    for (char const c : text) {
        if (c == '=')
            break;
        word = word << 6 | static_cast<unsigned>(digits.find(c));
        if ((bits += 6) >= 8)
            bytes += static_cast<char>(word >> (bits -= 8) & 255);
    }
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof(length));
    EXPECT_EQ(bytes.size(), sizeof(length) + length) << name;
    std::vector<T> values(length / sizeof(T));
    std::memcpy(values.data(), bytes.data() + sizeof(length), length);
    return values;
}

int attribute(std::string const& file, std::string const& name)
{
    std::smatch match;
    return std::regex_search(file, match, std::regex(name + "=\"(\\d+)\"")) ? std::stoi(match[1]) : -1;
}

Snapshot two_particles();

TEST_F(VtkFramesTest, HullsAreThereAsTheyAre)
{
    // A cube of 2 with roundings of 0.1: six faces, twelve edges and eight corners of its surface.
    Snapshot snapshot = two_particles();
    VtkFrames frames(folder);
    frames.write(snapshot);
    EXPECT_FALSE(std::filesystem::exists(folder / "hulls.pvd"));
    snapshot = {};
    for (double const x : {-1.0, 1.0})
        for (double const y : {-1.0, 1.0})
            for (double const z : {-1.0, 1.0})
                snapshot.x.push_back(x), snapshot.y.push_back(y), snapshot.z.push_back(z);
    snapshot.radius.assign(8, 0.1), snapshot.hull.assign(8, 1), snapshot.grain.assign(8, 3);
    frames.write(snapshot);
    auto const file = content("hulls_000001.vtp");
    EXPECT_EQ(attribute(file, "NumberOfPolys"), 26);
    EXPECT_EQ(attribute(file, "NumberOfPoints"), 24);
    EXPECT_EQ(array_of<std::int64_t>(file, "grain"), std::vector<std::int64_t>(26, 3));
    EXPECT_EQ(content("hulls.pvd").find("hulls_000000"), std::string::npos);
    // Closed, its faces outwards: its volume is that of the cube less what is cut off edges and corners.
    auto const polygons = hull_surfaces(snapshot);
    double volume = 0;
    std::size_t begin = 0;
    for (auto const end : polygons.ends) {
        auto const corner = [&](std::size_t k) {
            return polygons.corners[static_cast<std::size_t>(polygons.faces[k])];
        };
        for (std::size_t k = begin + 2; k < static_cast<std::size_t>(end); ++k)
            volume += dot(corner(begin), cross(corner(k - 1), corner(k))) / 6;
        begin = static_cast<std::size_t>(end);
    }
    // Prisms of half a square along the edges, and at corners what a tetrahedron leaves of a cube.
    double const side = 2.2, r = 0.1, edges = 12 * 2.0 * 0.5 * r * r, corners = 8 * (1 - 1.0 / 6) * r * r * r;
    EXPECT_NEAR(volume, side * side * side - edges - corners, 1e-12);
}

TEST_F(VtkFramesTest, SayWhichSpheresAreOneGrain)
{
    auto snapshot = two_particles();
    VtkFrames frames(folder);
    frames.write(snapshot);
    EXPECT_TRUE(array_of<std::int64_t>(content("particles_000000.vtp"), "grain").empty());
    snapshot.grain = {4, 4};
    frames.write(snapshot);
    EXPECT_EQ(array_of<std::int64_t>(content("particles_000001.vtp"), "grain"),
              (std::vector<std::int64_t>{4, 4}));
}

Snapshot two_particles()
{
    Snapshot snapshot;
    snapshot.time = 0.25;
    snapshot.x = {1, 2}, snapshot.y = {3, 4}, snapshot.z = {5, 6}, snapshot.radius = {0.5, 0.25};
    snapshot.vx = {7, 8}, snapshot.vy = {9, 10}, snapshot.vz = {11, 12};
    snapshot.wx = {-1, -2}, snapshot.wy = {-3, -4}, snapshot.wz = {-5, -6};
    snapshot.walls = {{0, 0, 0, 2, 3, 0}, {0, 0, 0, 1, 1, 1}}; // a floor and a cube
    return snapshot;
}

} // namespace

TEST_F(VtkFramesTest, particles_are_read_back)
{
    VtkFrames frames(folder);
    frames.write(two_particles());
    auto const file = content("particles_000000.vtp");
    EXPECT_EQ(attribute(file, "NumberOfPoints"), 2);
    EXPECT_EQ(attribute(file, "NumberOfVerts"), 2);
    EXPECT_EQ(array_of<float>(file, "Points"), (std::vector<float>{1, 3, 5, 2, 4, 6}));
    EXPECT_EQ(array_of<float>(file, "radius"), (std::vector<float>{0.5, 0.25}));
    EXPECT_EQ(array_of<float>(file, "velocity"), (std::vector<float>{7, 9, 11, 8, 10, 12}));
    EXPECT_EQ(array_of<float>(file, "angular_velocity"), (std::vector<float>{-1, -3, -5, -2, -4, -6}));
    EXPECT_EQ(array_of<std::int64_t>(file, "connectivity"), (std::vector<std::int64_t>{0, 1}));
    EXPECT_EQ(array_of<std::int64_t>(file, "offsets"), (std::vector<std::int64_t>{1, 2}));
}

TEST_F(VtkFramesTest, particles_have_ids_masses_materials_forces_and_contacts)
{
    VtkFrames frames(folder);
    auto snapshot = two_particles();
    snapshot.x = {1, 1.7}, snapshot.y = {0, 0}, snapshot.z = {0, 0}; // radii .5 and .25
    snapshot.mass = {2, 3}, snapshot.material = {1, 0};
    snapshot.fx = {1, 2}, snapshot.fy = {3, 4}, snapshot.fz = {5, 6};
    frames.write(snapshot);
    auto const file = content("particles_000000.vtp");
    EXPECT_EQ(array_of<std::int64_t>(file, "id"), (std::vector<std::int64_t>{0, 1}));
    EXPECT_EQ(array_of<std::int64_t>(file, "material"), (std::vector<std::int64_t>{1, 0}));
    EXPECT_EQ(array_of<std::int64_t>(file, "contacts"), (std::vector<std::int64_t>{1, 1}));
    EXPECT_EQ(array_of<float>(file, "mass"), (std::vector<float>{2, 3}));
    EXPECT_EQ(array_of<float>(file, "force"), (std::vector<float>{1, 3, 5, 2, 4, 6}));
}

TEST_F(VtkFramesTest, a_plane_without_an_end_is_cut_to_the_scene)
{
    VtkFrames frames(folder);
    auto snapshot =
        two_particles(); // within 1 to 2, 3 to 4, 5 to 6; the largest sphere and the extent are 1 m
    snapshot.walls = {{-1e6, -1e6, 0, 1e6, 1e6, 0}};
    frames.write(snapshot);
    EXPECT_EQ(array_of<float>(content("walls_000000.vtp"), "Points"),
              (std::vector<float>{0, 2, 0, 3, 2, 0, 3, 5, 0, 0, 5, 0}));
}

TEST_F(VtkFramesTest, frames_of_an_earlier_call_are_replaced)
{
    {
        VtkFrames frames(folder);
        for (int k = 0; k < 3; ++k)
            frames.write(two_particles());
    }
    VtkFrames frames(folder);
    frames.write(two_particles());
    EXPECT_TRUE(std::filesystem::exists(folder / "particles_000000.vtp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "particles_000001.vtp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "walls_000002.vtp"));
}

TEST_F(VtkFramesTest, a_floor_is_one_face_and_a_cube_six)
{
    VtkFrames frames(folder);
    frames.write(two_particles());
    auto const file = content("walls_000000.vtp");
    EXPECT_EQ(attribute(file, "NumberOfPolys"), 7);
    EXPECT_EQ(attribute(file, "NumberOfPoints"), 28);
    auto const points = array_of<float>(file, "Points");
    ASSERT_EQ(points.size(), 84u);
    EXPECT_EQ(std::vector<float>(points.begin(), points.begin() + 12),
              (std::vector<float>{0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0}));
}

TEST_F(VtkFramesTest, triangles_of_other_walls_follow)
{
    VtkFrames frames(folder);
    auto snapshot = two_particles();
    snapshot.walls.pop_back();
    snapshot.wall_triangles = {{1, 2, 3, 4, 5, 6, 7, 8, 9}};
    frames.write(snapshot);
    auto const file = content("walls_000000.vtp");
    EXPECT_EQ(attribute(file, "NumberOfPolys"), 2);
    auto const points = array_of<float>(file, "Points");
    ASSERT_EQ(points.size(), 21u);
    EXPECT_EQ(std::vector<float>(points.begin() + 12, points.end()),
              (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(array_of<std::int64_t>(file, "connectivity"), (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(array_of<std::int64_t>(file, "offsets"), (std::vector<std::int64_t>{4, 7}));
}

TEST_F(VtkFramesTest, numbers_have_names)
{
    VtkFrames frames(folder);
    auto snapshot = two_particles(); // a floor of one face and a cube of six
    snapshot.wall_triangles = {{1, 2, 3, 4, 5, 6, 7, 8, 9}};
    snapshot.wall_of_box = {1, 0}, snapshot.wall_of_triangle = {2};
    snapshot.id = {3, 7}, snapshot.group = {-1, 0};
    snapshot.names = {{"glass"}, {"rain"}, {"cube", "Bo", "cone"}};
    frames.write(snapshot);
    auto const walls = content("walls_000000.vtp"), particles = content("particles_000000.vtp");
    EXPECT_EQ(array_of<std::int64_t>(walls, "wall"), (std::vector<std::int64_t>{1, 0, 0, 0, 0, 0, 0, 2}));
    EXPECT_NE(walls.find("<Array type=\"String\" Name=\"wall_names\" NumberOfTuples=\"3\" format=\"ascii\">"
                         "99 117 98 101 0 66 111 0 99 111 110 101 0 </Array>"),
              std::string::npos);
    EXPECT_EQ(array_of<std::int64_t>(particles, "id"), (std::vector<std::int64_t>{3, 7}));
    EXPECT_EQ(array_of<std::int64_t>(particles, "group"), (std::vector<std::int64_t>{-1, 0}));
    EXPECT_NE(particles.find("Name=\"group_names\""), std::string::npos);
    EXPECT_NE(particles.find("Name=\"material_names\""), std::string::npos);
}

TEST_F(VtkFramesTest, collection_names_all_frames_with_their_times)
{
    VtkFrames frames(folder);
    auto snapshot = two_particles();
    frames.write(snapshot);
    snapshot.time = 0.5;
    frames.write(snapshot);
    auto const collection = content("particles.pvd");
    EXPECT_NE(collection.find("timestep=\"0.25\" file=\"particles_000000.vtp\""), std::string::npos);
    EXPECT_NE(collection.find("timestep=\"0.5\" file=\"particles_000001.vtp\""), std::string::npos);
    EXPECT_EQ(frames.size(), 2u);
}

TEST_F(VtkFramesTest, velocities_that_were_not_kept_are_left_out)
{
    VtkFrames frames(folder);
    auto snapshot = two_particles();
    snapshot.vx.clear(), snapshot.vy.clear(), snapshot.vz.clear();
    frames.write(snapshot);
    EXPECT_EQ(content("particles_000000.vtp").find("Name=\"velocity\""), std::string::npos);
}

TEST_F(VtkFramesTest, a_place_that_cannot_hold_frames_is_refused)
{
    std::ofstream(folder / "file") << "x";
    EXPECT_THROW(VtkFrames(folder / "file"), InputError);
}

} // namespace demens::observe
