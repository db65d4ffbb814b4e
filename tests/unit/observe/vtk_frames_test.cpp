#include "demens/observe/vtk_frames.hpp"

#include "demens/base/error.hpp"

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

//! Reads an appended array as the VTK file format describes it: length as 64 bits, then the values.
template <typename T>
std::vector<T> array_of(std::string const& file, std::string const& name)
{
    std::smatch match;
    std::string const xml = file.substr(0, file.find("<AppendedData"));
    if (!std::regex_search(xml, match, std::regex("Name=\"" + name + "\"[^>]*offset=\"(\\d+)\"")))
        return {};
    std::size_t const data = file.find('_', xml.size()) + 1 + std::stoul(match[1]);
    std::uint64_t length = 0;
    std::memcpy(&length, file.data() + data, sizeof(length));
    std::vector<T> values(length / sizeof(T));
    std::memcpy(values.data(), file.data() + data + sizeof(length), length);
    return values;
}

int attribute(std::string const& file, std::string const& name)
{
    std::smatch match;
    std::string const xml = file.substr(0, file.find("<AppendedData"));
    return std::regex_search(xml, match, std::regex(name + "=\"(\\d+)\"")) ? std::stoi(match[1]) : -1;
}

Snapshot two_particles();

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
