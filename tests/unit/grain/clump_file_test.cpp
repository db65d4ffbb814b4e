// Tables of spheres as generators write them.
#include "demens/base/error.hpp"
#include "demens/grain/clump_file.hpp"
#include "tests/support/fault_of.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::grain;

Clump const rod = {{{0, 0, 0}, 0.5}, {{0.25, 0, 0}, 0.5}, {{0.5, 0, -0.125}, 0.25}};

Clump read(std::string const& text, double scale = 1)
{
    return read_clump(text, "rod.csv", scale);
}

std::string refusal_of_file(std::string const& text)
{
    return test::fault_of([&] { read(text); });
}

TEST(ClumpFile, IsReadWithAndWithoutNamesHoweverSeparated)
{
    for (std::string const text : {"x,y,z,r\n0,0,0,0.5\n0.25,0,0,0.5\n0.5,0,-0.125,0.25\n",
                                   "0 0 0 0.5\n 0.25 0 0 0.5\n0.5  0 -1.25e-1 0.25",
                                   "# made by hand\n0,0,0,0.5\n.25,0,0,.5\n.5,0,-.125,.25\n",
                                   "0\t0\t0\t0.5\r\n0.25\t0\t0\t0.5\r\n0.5\t0\t-0.125\t0.25\r\n",
                                   "Radius;X;Y;Z;id\n0.5;0;0;0;1\n0.5;0.25;0;0;2\n0.25;0.5;0;-0.125;3\n"})
        EXPECT_EQ(read(text), rod) << text;
    EXPECT_EQ(read("0,0,0,500\n250,0,0,500\n500,0,-125,250\n", 1e-3)[2].radius, 0.25);
}

TEST(ClumpFile, IsWrittenAsItIsRead)
{
    Clump const clump = {{{1.0 / 3, 1e-7, -0.1}, 0.7}, {{0, 0, 0}, 2.0 / 7}};
    EXPECT_EQ(read(clump_table(clump, 1)), clump);
    EXPECT_EQ(clump_table(rod, 1), "x,y,z,r\n0,0,0,0.5\n0.25,0,0,0.5\n0.5,0,-0.125,0.25\n");
}

TEST(ClumpFile, SaysWhereItIsWrong)
{
    EXPECT_NE(
        refusal_of_file("x,y,z,r\n0,0,0,1\n0,one,0,1\n").find("rod.csv:3: column y: \"one\" is not a number"),
        std::string::npos);
    EXPECT_NE(refusal_of_file("0,0,0,1\n0,0,1\n").find("rod.csv:2: has 3 values"), std::string::npos);
    EXPECT_NE(refusal_of_file("0,0,0,1\n0,0,,1\n").find("rod.csv:2: the column z is empty"),
              std::string::npos);
    EXPECT_EQ(refusal_of_file("0,0,0,1\n0,0,1,-2\n"), "rod.csv:2: the radius -2 must be above 0");
    EXPECT_NE(refusal_of_file("x,y,z,d\n0,0,0,1\n").find("no column `r`"), std::string::npos);
    EXPECT_NE(refusal_of_file("x,y,z,r\n").find("holds no numbers; lines of x, y, z, r are expected"),
              std::string::npos);
    EXPECT_NE(refusal_of_file("0,0,0,1\n5,0,0,1\n").find("do not hang together"), std::string::npos);
}

} // namespace
