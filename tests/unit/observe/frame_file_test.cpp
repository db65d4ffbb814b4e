// Frames as LIGGGHTS, LAMMPS, VTK writers and spreadsheets write them.
#include "demens/observe/frame_file.hpp"
#include "demens/observe/vtk_frames.hpp"

#include "demens/base/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace {

using namespace demens;
using observe::SphereFrame;

class FrameFile : public ::testing::Test
{
  protected:
    FrameFile() { std::filesystem::create_directories(folder_); }
    ~FrameFile() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path file(std::string const& name, std::string const& content) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    std::vector<SphereFrame> read(std::string const& name, std::string const& content, double unit = 1) const
    {
        return observe::read_frames(file(name, content), unit);
    }
    std::string refusal(std::string const& name, std::string const& content) const
    {
        try {
            read(name, content);
        } catch (InputError const& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_ =
        std::filesystem::path(::testing::TempDir()) /
        ("frames_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

void expect_sphere(dem::Place const& sphere, double x, double y, double z, double radius)
{
    EXPECT_FLOAT_EQ(sphere.x, x);
    EXPECT_FLOAT_EQ(sphere.y, y);
    EXPECT_FLOAT_EQ(sphere.z, z);
    EXPECT_FLOAT_EQ(sphere.radius, radius);
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

std::string const dump_head = "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\n"
                              "ITEM: BOX BOUNDS pp pp ff\n-1 3\n0 2\n0 1\n";

TEST_F(FrameFile, DumpsHaveAnyNumberOfTimeSteps)
{
    auto const one =
        dump_head + "ITEM: ATOMS id type x y z vx radius \n1 1 0.1 0.2 0.3 5 0.01\n2 1 -1e-1 0 0 5 0.02\n";
    auto const frames = read("bed.dump", one + one);
    ASSERT_EQ(frames.size(), 2U);
    ASSERT_EQ(frames[1].spheres.size(), 2U);
    expect_sphere(frames[1].spheres[0], 0.1, 0.2, 0.3, 0.01);
    expect_sphere(frames[1].spheres[1], -0.1, 0, 0, 0.02);
    EXPECT_SAYS(frames[0].origin, "bed.dump, time step 100");
}

TEST_F(FrameFile, DumpsInOtherColumnsAndUnits)
{
    auto const scaled =
        read("bed.lammpstrj", "ITEM: UNITS\nsi\nITEM: TIME\n0.5\n" + dump_head +
                                  "ITEM: ATOMS id xs ys zs diameter\n1 0.5 0.5 0.5 0.4\n2 0 1 1 0.2\r\n");
    expect_sphere(scaled[0].spheres[0], 1, 1, 0.5, 0.2);
    expect_sphere(scaled[0].spheres[1], -1, 2, 1, 0.1);
    auto const unwrapped =
        read("bed.100", dump_head + "ITEM: ATOMS xu yu zu radius\n10 20 30 1\n0 0 0 2\n", 1e-3);
    expect_sphere(unwrapped[0].spheres[0], 0.01, 0.02, 0.03, 0.001);
}

TEST_F(FrameFile, DumpsThatCannotBeReadSayWhy)
{
    auto const no_radius = refusal("a.dump", dump_head + "ITEM: ATOMS id x y z\n1 0 0 0\n2 0 0 0\n");
    EXPECT_SAYS(no_radius, "a.dump:9: there is no column of radii among \"ITEM: ATOMS id x y z\"");
    EXPECT_SAYS(refusal("a.dump", dump_head + "ITEM: ATOMS x y radius\n"), "no coordinates");
    EXPECT_SAYS(refusal("a.dump", dump_head + "ITEM: ATOMS x y z radius\n0 0 0 1\n"), "before atom 2 of 2");
    EXPECT_SAYS(refusal("a.dump", dump_head + "ITEM: ATOMS x y z radius\n0 0 0 1\n0 0 1\n"), ":11: 3 values");
    EXPECT_SAYS(refusal("a.dump", dump_head + "ITEM: ATOMS x y z radius\n0 0 0 1\n0 0 0 -1\n"),
                "radii positive");
    EXPECT_SAYS(refusal("a.dump", dump_head + "ITEM: ATOMS x y z radius\n0 0 0 1\n0 0 b 1\n"),
                "\"b\" is not a number");
    EXPECT_SAYS(refusal("a.dump", dump_head), "no \"ITEM: ATOMS\"");
    for (char const* count : {"1e88", "-3", "2.5", "nan", "many"})
        EXPECT_SAYS(
            refusal("a.dump", fmt::format("ITEM: NUMBER OF ATOMS\n{}\nITEM: ATOMS x y z radius\n", count)),
            fmt::format("a.dump:2: \"{}\" stands where a number of atoms would", count));
    EXPECT_SAYS(refusal("a.dump", "hello\n"), "neither a text dump");
    EXPECT_SAYS(refusal("a.dump", ""), "neither a text dump");
}

TEST_F(FrameFile, WhatThisProgramWritesIsReadBack)
{
    observe::Snapshot snapshot;
    snapshot.x = {0.1, 0.4}, snapshot.y = {0.2, 0.5}, snapshot.z = {0.3, 0.6}, snapshot.radius = {0.01, 0.02};
    observe::VtkFrames frames(folder_ / "run");
    frames.write(snapshot);
    snapshot.x[0] = 0.15;
    frames.write(snapshot);
    auto const read = observe::read_frames(folder_ / "run/particles.pvd", 1);
    ASSERT_EQ(read.size(), 2U);
    expect_sphere(read[0].spheres[1], 0.4, 0.5, 0.6, 0.02);
    expect_sphere(read[1].spheres[0], 0.15, 0.2, 0.3, 0.01);
    // cut short
    auto content = std::string(std::filesystem::file_size(folder_ / "run/particles_000000.vtp"), ' ');
    std::ifstream(folder_ / "run/particles_000000.vtp", std::ios::binary)
        .read(content.data(), static_cast<std::streamsize>(content.size()));
    EXPECT_SAYS(refusal("cut.vtp", content.substr(0, content.size() / 2)), "not whole");
}

TEST_F(FrameFile, XmlInTextAndInBase64)
{
    auto const with = [](std::string const& points, std::string const& radii) {
        return "<?xml version=\"1.0\"?>\n<!-- made by hand -->\n<VTKFile type='UnstructuredGrid' "
               "version=\"0.1\" "
               "byte_order=\"LittleEndian\">\n<UnstructuredGrid><Piece NumberOfPoints=\"1\" "
               "NumberOfCells=\"0\">\n"
               "<PointData><DataArray type=\"Float32\" Name=\"radius\" " +
               radii +
               "</DataArray></PointData>\n<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" " +
               points + "</DataArray></Points>\n</Piece></UnstructuredGrid></VTKFile>\n";
    };
    expect_sphere(read("a.vtu", with("format=\"ascii\">1 2.5\n-3", "format=\"ascii\"> 0.5 "))[0].spheres[0],
                  1, 2.5, -3, 0.5);
    // 4 bytes 0.5F behind their count, and 12 of (1, 2, 3) with a count that is encoded by itself
    expect_sphere(
        read("a.vtu", with("format=\"binary\">DAAAAA==AACAPwAAAEAAAEBA", "format=\"binary\">BAAAAAAAAD8="))[0]
            .spheres[0],
        1, 2, 3, 0.5);
    EXPECT_SAYS(refusal("a.vtu", with("format=\"ascii\">1 2 3", "Name=\"mass\" format=\"ascii\">1")),
                "no array");
    EXPECT_SAYS(refusal("a.vtu", with("format=\"ascii\">1 2", "format=\"ascii\">1")),
                "2 coordinates and 1 radii");
    EXPECT_SAYS(refusal("a.vtu", "<VTKFile compressor=\"vtkZLibDataCompressor\">"), "compressed");
}

TEST_F(FrameFile, LegacyVtkInTextAndBinary)
{
    auto const text =
        read("a.vtk", "# vtk DataFile Version 3.0\nbed\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n"
                      "0.1 0.2 0.3 0.4 0.5 0.6\nVERTICES 2 4\n1 0\n1 1\nPOINT_DATA 2\n"
                      "VECTORS v float\n0 0 0 1 1 1\nSCALARS radius float 1\nLOOKUP_TABLE default\n"
                      "0.01\n0.02\nFIELD more 1\nid 1 2 int\n7 8\n");
    expect_sphere(text[0].spheres[1], 0.4, 0.5, 0.6, 0.02);
    auto const big_endian = [](std::vector<float> const& numbers) {
        std::string bytes;
        for (float number : numbers) {
            auto* raw = reinterpret_cast<char*>(&number);
            std::reverse(raw, raw + 4);
            bytes.append(raw, 4);
        }
        return bytes;
    };
    auto const binary =
        read("a.vtk", "# vtk DataFile Version 5.1\nbed\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n" +
                          big_endian({1, 2, 3}) + "\nPOINT_DATA 1\nFIELD FieldData 1\ndiameter 1 1 float\n" +
                          big_endian({0.5}) + "\n");
    expect_sphere(binary[0].spheres[0], 1, 2, 3, 0.25);
    std::string const head =
        "# vtk DataFile Version 3.0\nbed\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n1 2 3\n";
    EXPECT_SAYS(refusal("a.vtk", head), "no array \"radius\"");
    EXPECT_SAYS(refusal("a.vtk", head + "POINT_DATA 1\nSCALARS radius float\nLOOKUP_TABLE default\n"),
                "not whole");
    EXPECT_SAYS(refusal("a.vtk", "# vtk DataFile Version 3.0\nbed\nASCII\nDATASET STRUCTURED_POINTS\n"),
                "STRUCTURED_POINTS");
}

TEST_F(FrameFile, TablesWithUnits)
{
    expect_sphere(read("a.csv", "id,x_mm,y_mm,z_mm,diameter [um]\n1,10,20,30,500\n")[0].spheres[0], 0.01,
                  0.02, 0.03, 0.00025);
    expect_sphere(read("a.csv", "x;y;z;r\n1,5;2;3;0,5\n", 1e-3)[0].spheres[0], 0.0015, 0.002, 0.003, 0.0005);
    EXPECT_SAYS(refusal("a.csv", "x,y,z\n1,2,3\n"), "there is no column of sizes");
    EXPECT_SAYS(refusal("a.csv", "x,z,radius\n1,2,3\n"), "there is no column y");
}

TEST_F(FrameFile, AreToldByName)
{
    for (auto const* name : {"a.dump", "dump.100", "a.VTP", "b.pvd", "c.csv", "d.liggghts"})
        EXPECT_TRUE(observe::is_frame_file(name)) << name;
    for (auto const* name : {"a.png", "dump", "a.toml", "a."})
        EXPECT_FALSE(observe::is_frame_file(name)) << name;
    EXPECT_THROW(observe::read_frames(folder_ / "none.csv", 1), InputError);
}

} // namespace
