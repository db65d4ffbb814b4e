// Tables as spreadsheets and programs write them, and what is said about those that cannot be read.
#include "demens/base/error.hpp"
#include "demens/base/text/csv.hpp"
#include "tests/support/fault_of.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using demens::InputError;
using demens::text::CsvTable;
using demens::text::DecimalMark;
using demens::text::means_missing;
using demens::text::number_of;

using Numbers = std::vector<double>;

Numbers column(std::string const& text, std::string const& name)
{
    auto const table = CsvTable::from_text(text, "t.csv");
    return table.numbers(table.column(name));
}

std::string refusal(std::string const& text, std::string const& name = "y")
{
    return demens::test::fault_of([&] { column(text, name); });
}

TEST(NumberOf, SignsExponentsAndMarks)
{
    EXPECT_EQ(number_of("+1.0"), 1.0);
    EXPECT_EQ(number_of(" -2.5e-3 "), -2.5e-3);
    EXPECT_EQ(number_of("+1.0000E-01"), 0.1);
    EXPECT_EQ(number_of("1.5D+01"), 15.0); // Fortran
    EXPECT_EQ(number_of(".5"), 0.5);
    EXPECT_EQ(number_of("\xE2\x88\x92"
                        "3"),
              -3.0); // the sign of typesetters
    EXPECT_EQ(number_of("1\xC2\xA0"), 1.0);
    EXPECT_EQ(number_of("0,25", DecimalMark::comma), 0.25);
    for (auto const* text :
         {"", "x", "1 2", "+-1", "--1", "1,5", "1e999", "inf", "nan", "1.2.3", "5 %", "0x10"})
        EXPECT_FALSE(number_of(text)) << text;
    EXPECT_FALSE(number_of("1.234,5", DecimalMark::comma));
    EXPECT_FALSE(number_of("1,234,567", DecimalMark::comma));
}

TEST(MeansMissing, HasManyNames)
{
    for (auto const* text : {"", " ", "NA", "n/a", "N/A", "NaN", "NULL", "-", "#N/A", "#DIV/0!"})
        EXPECT_TRUE(means_missing(text)) << text;
    for (auto const* text : {"0", "x", "-1", "#1"})
        EXPECT_FALSE(means_missing(text)) << text;
}

// The same numbers in every dialect.
TEST(CsvTable, Dialects)
{
    Numbers const a = {1, 2, 3}, y = {2.5, -0.125, 1000};
    for (std::string const text : {
             "a,y\n1,2.5\n2,-0.125\n3,1000\n",
             "\xEF\xBB\xBF"
             "a,y\n1,2.5\n2,-0.125\n3,1000",
             "a,y\r\n1,2.5\r\n2,-0.125\r\n3,1000\r\n",
             "a,y\r1,2.5\r2,-0.125\r3,1000\r",
             "a;y\n1;2,5\n2;-0,125\n3;1000\n",
             "a;y\n1;2.5\n2;-0.125\n3;1000\n",
             "a\ty\n1\t2.5\n2\t-0.125\n3\t1000\n",
             "a\ty\n1\t2,5\n2\t-0,125\n3\t1000\n",
             "a|y\n1|2.5\n2|-0.125\n3|1000\n",
             "  a   y\n  1 2.5  \n  2 -0.125\n  3 1000\n",
             "sep=;\na;y\n1;2,5\n2;-0,125\n3;1000\n",
             "\"a\",\"y\"\n\"1\",\"2,5\"\n\"2\",\"-0,125\"\n\"3\",\"1000\"\n",
             "a,y\n+1,+2.5E+00\n+2,-1.25e-01\n+3,1.D+3\n",
             "# made by hand\n\na , y\n1 , 2.5\n# a remark, with a comma and a \"\n2,-0.125\n3,1000\n\n",
             "#a,y\n1,2.5\n2,-0.125\n3,1000\n",
             "# first remark\n# a, y\n1,2.5\n2,-0.125\n3,1000\n",
             "a,y,\n1,2.5,\n2,-0.125,\n3,1000,\n",
             "a,y\n1,2.5,,\n2,-0.125\n,,\n3,1000\n",
             "date,a,y\n2.1.2024,1,2.5\n3.1.2024,2,-0.125\nx,3,1000\n",
             "A,Y\n1,2.5\n2,-0.125\n3,1000\n",
         }) {
        EXPECT_EQ(column(text, "a"), a) << text;
        EXPECT_EQ(column(text, "y"), y) << text;
    }
}

TEST(CsvTable, QuotesHoldSeparatorsQuotesAndLines)
{
    auto const table =
        CsvTable::from_text("\"mu, static\",\"the \"\"run\"\"\",\"y\nin g\"\n0.1,\"a, b\",2\n", "t.csv");
    EXPECT_EQ(table.names(), (std::vector<std::string>{"mu, static", "the \"run\"", "y\nin g"}));
    EXPECT_EQ(table.cell(0, 1), "a, b");
    EXPECT_EQ(table.number(0, table.column("mu, static")), 0.1);
    EXPECT_EQ(table.line_of_row(0), 3);
    EXPECT_EQ(CsvTable::from_text("pipe,y\n5\" wide,1\n", "t.csv").cell(0, 0), "5\" wide");
    EXPECT_EQ(refusal("a,y\n\"1,2\n3,4\n"), "t.csv:2: a quote is opened and not closed");
}

TEST(CsvTable, MissingValuesAndTexts)
{
    auto const y = column("a,y\n1,2.1\n5,N/A\n6,\n7,NA\n8,-\n#N/A,3\n", "y");
    ASSERT_EQ(y.size(), 6u);
    for (std::size_t k : {1, 2, 3, 4})
        EXPECT_TRUE(std::isnan(y[k])) << k;
    EXPECT_EQ(y[5], 3);
    auto const table = CsvTable::from_text("run,a,y\nr1,1,2\nr2,2,-\n", "t.csv");
    EXPECT_FALSE(table.is_numeric(0));
    EXPECT_TRUE(table.is_numeric(2));
    EXPECT_EQ(table.cell(1, 0), "r2");
}

TEST(CsvTable, NamesWhatItCannotRead)
{
    EXPECT_EQ(refusal("a,y\n1,2\n2,x\n"), "t.csv:3: column y: \"x\" is not a number");
    EXPECT_EQ(refusal("a,b\n1,2\n"), "t.csv has no column `y`; its columns are a, b");
    EXPECT_EQ(refusal("a,a\n1,2\n"), "t.csv:1: two columns are called \"a\"");
    EXPECT_EQ(refusal("a,y\n1,2\n3\n"),
              "t.csv:3: has 1 values where the header has 2 columns, separated by commas");
    EXPECT_EQ(refusal("a,y\n1,5,2,1\n1,6,2,2\n"),
              "t.csv:2: has 4 values where the header has 2 columns, separated by commas; are there decimal "
              "commas? Then separate by semicolons, or put the numbers in quotes");
    EXPECT_EQ(
        refusal("1,2\n3,4\n"),
        "t.csv:1: holds numbers where the names of the columns are expected; begin with a line of names");
    EXPECT_EQ(refusal("\xFF\xFE"
                      "a"),
              "t.csv: is UTF-16, not plain text; save it as UTF-8 or ASCII");
}

TEST(CsvTable, NamesThatAreKnownNeedNotBeWritten)
{
    auto const table = CsvTable::from_text("# spheres\n1 2\n3 4\n", "t.csv", {"a", "y"});
    EXPECT_EQ(table.numbers(table.column("y")), (Numbers{2, 4}));
    EXPECT_EQ(table.where(1), "t.csv:3");
    auto const named = CsvTable::from_text("y a\n1 2\n", "t.csv", {"a", "y"});
    EXPECT_EQ(named.numbers(named.column("y")), (Numbers{1}));
    EXPECT_THROW(CsvTable::from_text("1 2 3\n", "t.csv", {"a", "y"}), InputError);
}

// 1,234 is 1.234 to some and 1234 to others: neither is taken.
TEST(CsvTable, ThousandsAreNoDecimals)
{
    EXPECT_EQ(
        refusal("a,y\n1,\"1,234\"\n2,\"12,500\"\n"),
        "t.csv:2: column y: \"1,234\" is not a number that is clear: `1,234` in line 2 may be a decimal "
        "comma or one between thousands; write decimal points, and nothing between thousands");
    EXPECT_EQ(refusal("a,y\n1,\"1,234.5\"\n"), "t.csv:2: column y: \"1,234.5\" is not a number");
    EXPECT_EQ(refusal("a,y\n1,\"1,234,567\"\n"),
              "t.csv:2: column y: \"1,234,567\" is not a number; write nothing between thousands");
    EXPECT_EQ(
        refusal("a;y\n1,5;2.5\n"),
        "t.csv:2: column y: \"2.5\" is not a number that is clear: the file has decimal commas (`1,5` in "
        "line 2) and points (`2.5` in line 2); write all numbers in one way");
    EXPECT_EQ(column("a;y\n1;1,234\n", "y"), Numbers{1.234}); // semicolons leave the comma to the decimals
    EXPECT_EQ(column("a,y\n1,\"0,234\"\n", "y"), Numbers{0.234});
}

} // namespace
