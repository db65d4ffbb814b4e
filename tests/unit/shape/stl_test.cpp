// STL files: both kinds, and what is wrong with bad ones.
#include "demens/base/error.hpp"
#include "demens/shape/stl.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>

namespace {

using namespace demens;
using shape::TriangleMesh;
using shape::TriangleSoup;

class Stl : public ::testing::Test
{
  protected:
    Stl()
    {
        std::string name = std::filesystem::temp_directory_path() / "demens-stl-XXXXXX";
        folder = mkdtemp(name.data());
    }
    ~Stl() override { std::filesystem::remove_all(folder); }

    std::filesystem::path file(std::string const& content) const
    {
        std::ofstream(folder / "mesh.stl", std::ios::binary) << content;
        return folder / "mesh.stl";
    }
    //! What is said about a file with this content; empty if it is read.
    std::string refusal(std::string const& content) const
    {
        try {
            shape::load_mesh(file(content));
        } catch (InputError const& error) {
            std::string const text = error.what();
            EXPECT_NE(text.find("mesh.stl: "), std::string::npos) << text;
            return text;
        }
        return "";
    }

    std::filesystem::path folder;
};

std::string ascii(TriangleSoup const& soup, std::string const& end = "endsolid part\n")
{
    std::ostringstream out;
    out << "solid part one\n";
    for (auto const& triangle : soup) {
        out << "  facet normal 0 0 0\n    outer loop\n";
        for (Vector3 const& p : triangle)
            out << "      vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
        out << "    endloop\n  endfacet\n";
    }
    out << end;
    return out.str();
}

std::string binary(TriangleSoup const& soup, std::string header = "binary")
{
    header.resize(80, ' ');
    auto const append = [&](auto value) {
        header.append(reinterpret_cast<char const*>(&value), sizeof(value));
    };
    append(static_cast<std::uint32_t>(soup.size()));
    for (auto const& triangle : soup) {
        for (int k = 0; k < 3; ++k)
            append(0.0F);
        for (Vector3 const& p : triangle)
            for (double const c : {p.x, p.y, p.z})
                append(static_cast<float>(c));
        append(std::uint16_t{0});
    }
    return header;
}

TriangleSoup const box = shape::box_triangles({-1, 0, 0.5}, {1, 2, 4});

TEST_F(Stl, AsciiAndBinaryAreTheSameMesh)
{
    auto const from_ascii = shape::load_mesh(file(ascii(box)));
    EXPECT_EQ(from_ascii->vertices().size(), 8u);
    ASSERT_EQ(from_ascii->facets().size(), 12u);
    EXPECT_TRUE(from_ascii->faults().warnings().empty());
    EXPECT_EQ(from_ascii->bounds().lower, (Vector3{-1, 0, 0.5}));
    EXPECT_EQ(from_ascii->bounds().upper, (Vector3{1, 2, 4}));
    // A binary file may begin with the word of an ASCII one.
    for (std::string const header : {"exported", "solid part one"}) {
        auto const from_binary = shape::load_mesh(file(binary(box, header)));
        EXPECT_EQ(from_binary->vertices(), from_ascii->vertices());
        ASSERT_EQ(from_binary->facets().size(), 12u);
        for (std::size_t k = 0; k < 12; ++k)
            EXPECT_EQ(from_binary->facets()[k].vertices, from_ascii->facets()[k].vertices);
    }
    // Windows line ends, capital exponents, tabs.
    EXPECT_EQ(
        refusal("solid\r\n facet normal nan nan nan\r\n\touter loop\r\n vertex 0 0 0\r\n vertex 1E0 0 0\r\n"
                " vertex 0 1.0e+00 0\r\n endloop\r\nendfacet\r\nendsolid\r\n"),
        "");
}

TEST_F(Stl, IsScaledThenTurnedThenShifted)
{
    Placement const placement{rotation_about({0, 0, 1}, 1.5707963267948966), {10, 0, 0}};
    auto const mesh = shape::load_mesh(file(binary(box)), {.scale = 1e-3, .placement = placement});
    EXPECT_NEAR(mesh->bounds().lower.x, 10 - 2e-3, 1e-12); // x = -y, y = x
    EXPECT_NEAR(mesh->bounds().upper.y, 1e-3, 1e-12);
    EXPECT_NEAR(mesh->bounds().upper.z, 4e-3, 1e-12);
    EXPECT_NEAR(norm(mesh->facets()[0].normal), 1, 1e-15);
    EXPECT_NEAR(mesh->extent(), 1e-3 * std::sqrt(1 + 1 + 1.75 * 1.75), 1e-12);
}

// Programs write a solid a part, and `cat` joins files.
TEST_F(Stl, AllSolidsAreRead)
{
    TriangleSoup const first(box.begin(), box.begin() + 5), second(box.begin() + 5, box.end());
    for (std::string const between :
         {"endsolid part\n", "endsolid\n\n", "endsolid solid part of \xC3\xA9\r\n"}) {
        auto const soup = shape::read_stl(file(ascii(first, between) + ascii(second)));
        ASSERT_EQ(soup.size(), 12u) << between;
        EXPECT_EQ(soup[4], box[4]);
        EXPECT_EQ(soup[5], box[5]);
    }
    EXPECT_NE(refusal(ascii(first) + "facet normal").find("\"facet\" where \"solid\" or the end of the file"),
              std::string::npos);
    EXPECT_NE(refusal(ascii(first) + ascii(second, "")).find("truncated: ends before \"endsolid\""),
              std::string::npos);
}

TEST_F(Stl, AsciiInOtherHands)
{
    std::string const facet =
        "facet normal 0 0 1 outer loop vertex 0 0 0 vertex +1 0 0 vertex 0 1.D0 0 endloop endfacet";
    EXPECT_EQ(shape::read_stl(file("\xEF\xBB\xBFsolid\r" + facet + "\rendsolid\r")).size(), 1u);
    EXPECT_EQ(shape::read_stl(
                  file("SOLID A\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 "
                       "0\nENDLOOP\nENDFACET\nENDSOLID A\n"))
                  .size(),
              1u);
    EXPECT_EQ(shape::read_stl(file("solid in one line " + facet + " " + facet + " endsolid")).size(), 2u);
    EXPECT_NE(
        refusal("solid a\n" + facet + "\nendsolid a " + facet).find("line 3: facets follow \"endsolid\""),
        std::string::npos);
    EXPECT_NE(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0,5 0\n")
                  .find("line 4: \"0,5\" where a number"),
              std::string::npos);
}

TEST_F(Stl, BinaryCountMustBeThatOfTheFile)
{
    std::string less = binary(box);
    less[80] = 2;
    EXPECT_NE(refusal(less).find("its header says 2 triangles, but its 684 bytes hold 12"),
              std::string::npos);
    less[80] = 0;
    EXPECT_NE(refusal(less).find("its header says 0 triangles, but its 684 bytes hold 12"),
              std::string::npos);
    EXPECT_EQ(shape::read_stl(file(binary(box) + std::string(49, '\0'))).size(), 12u); // not a triangle
}

TEST_F(Stl, BadFilesAreRefusedWithTheReason)
{
    EXPECT_THROW(shape::read_stl(folder / "none.stl"), InputError);
    EXPECT_THROW(shape::read_stl(folder), InputError);
    EXPECT_NE(refusal("").find("not an STL file: 0 bytes"), std::string::npos);
    EXPECT_NE(refusal("PK some other file").find("not an STL file: 18 bytes"), std::string::npos);
    std::string const whole = binary(box);
    EXPECT_NE(refusal(whole.substr(0, 300))
                  .find("truncated, or not an STL file: 12 triangles need 684 bytes, it has 300"),
              std::string::npos);
    EXPECT_NE(refusal(ascii(box, "")).find("truncated: ends before \"endsolid\""), std::string::npos);
    EXPECT_NE(refusal(ascii(box).substr(0, 200)).find("truncated"), std::string::npos);
    EXPECT_NE(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 zero 0\n")
                  .find("line 4: \"zero\" where a number is expected"),
              std::string::npos);
    EXPECT_NE(refusal("solid a\nfacet normal 0 0 1\nouter lop\n")
                  .find("line 3: \"lop\" where \"loop\" is expected"),
              std::string::npos);
    EXPECT_NE(
        refusal("solid a\nfaces\n").find("line 2: \"faces\" where \"facet\" or \"endsolid\" is expected"),
        std::string::npos);
    EXPECT_NE(refusal("solid a\nendsolid a\n").find("the mesh has no triangles"), std::string::npos);
    TriangleSoup broken = box;
    broken[3][1].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(refusal(binary(broken)).find("a corner of triangle 4 of 12 is not a finite number"),
              std::string::npos);
    EXPECT_NE(refusal(binary({{Vector3{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}}))
                  .find("none of the mesh's 1 triangles has an area"),
              std::string::npos);
}

TEST(TriangleMesh, HolesAreCountedAndLocated)
{
    TriangleSoup open = box;
    open.pop_back(); // half of the top
    auto const warnings = TriangleMesh(open).faults().warnings();
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("3 edges with one triangle only, the first at"), std::string::npos)
        << warnings[0];
    EXPECT_NE(warnings[0].find("open, or has a hole"), std::string::npos);
    TriangleSoup doubled = box;
    doubled.push_back(box[0]);
    auto const faults = TriangleMesh(doubled).faults();
    EXPECT_EQ(faults.manifold_faults, 3u);
    EXPECT_NE(faults.warnings()[0].find("3 edges with more than two triangles"), std::string::npos);
}

TEST(TriangleMesh, DegenerateTrianglesAreLeftOutAndReported)
{
    TriangleSoup soup = box;
    soup.push_back({Vector3{1, 2, 4}, {1, 2, 4}, {0, 0, 0.5}});
    soup.push_back({Vector3{-1, 0, 0.5}, {0, 1, 2.25}, {1, 2, 4}});
    TriangleMesh const mesh(soup);
    EXPECT_EQ(mesh.facets().size(), 12u);
    EXPECT_EQ(mesh.faults().degenerate, 2u);
    EXPECT_NE(mesh.faults().warnings()[0].find("2 triangles without area left out, the first at (1, 2, 4) m"),
              std::string::npos)
        << mesh.faults().warnings()[0];
}

TEST(TriangleMesh, CornersThatNearlyCoincideAreJoined)
{
    // Single precision leaves gaps of some 1e-7 of the size between triangles that share a corner.
    TriangleSoup soup = box;
    for (std::size_t k = 0; k < soup.size(); ++k)
        for (Vector3& p : soup[k])
            p += 1e-7 * static_cast<double>(k % 3) * Vector3{1, -1, 1};
    TriangleMesh const mesh(soup);
    EXPECT_EQ(mesh.vertices().size(), 8u);
    EXPECT_TRUE(mesh.faults().warnings().empty());
}

TEST(TriangleMesh, MustBeInTheDomain)
{
    TriangleMesh const mesh(box);
    EXPECT_EQ(shape::check_within(mesh, {-2, -2, -2}, {5, 5, 5}), "");
    EXPECT_NE(
        shape::check_within(mesh, {-2, -2, -2}, {5, 5, 3}).find("a part of the mesh is outside the domain"),
        std::string::npos);
    try {
        shape::check_within(mesh, {-2, -2, -2}, {5, 5, 0.25});
        FAIL() << "a mesh outside the domain was accepted";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what())
                      .find("reaches from (-1, 0, 0.5) to (1, 2, 4) m, the domain from (-2, -2, -2) to (5, "
                            "5, 0.25) m"),
                  std::string::npos)
            << error.what();
    }
}

} // namespace
