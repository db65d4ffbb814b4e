#include "tao_calib/design/fractional_factorial.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::tao_calib;

namespace {

//! Shortest product of columns that is constant over the design, found by trying all.
int resolution_by_brute_force(Eigen::MatrixXd const& design)
{
    int shortest = 0;
    for (unsigned mask = 1; mask < (1u << design.cols()); ++mask) {
        Eigen::VectorXd product = Eigen::VectorXd::Ones(design.rows());
        int length = 0;
        for (int k = 0; k < design.cols(); ++k)
            if (mask >> k & 1u) {
                product.array() *= design.col(k).array();
                ++length;
            }
        if ((product.array() == product[0]).all() && (shortest == 0 || length < shortest))
            shortest = length;
    }
    return shortest;
}

std::vector<std::string> texts(std::vector<Word> const& words)
{
    std::vector<std::string> result;
    for (Word word : words)
        result.push_back(word.text());
    return result;
}

} // namespace

// Montgomery, Design and Analysis of Experiments, example 8.4: injection moulding, 2^(6-2).
TEST(FractionalFactorial, InjectionMoulding)
{
    FractionalFactorial const fraction(6, {"E=ABC", "F=BCD"});
    EXPECT_EQ(texts(fraction.defining_relation()), (std::vector<std::string>{"ABCE", "ADEF", "BCDF"}));
    EXPECT_EQ(fraction.resolution(), 4);
    EXPECT_EQ(resolution_by_brute_force(fraction.coded()), 4);
    EXPECT_EQ(fraction.aliases(), (std::vector<std::string>{"AB = CE", "AC = BE", "AD = EF", "AE = BC = DF",
                                                            "AF = DE", "BD = CF", "BF = CD"}));

    Eigen::VectorXd y(16);
    y << 6, 10, 32, 60, 4, 15, 26, 60, 8, 12, 34, 60, 16, 5, 37, 52;
    auto const x = fraction.coded();
    EXPECT_DOUBLE_EQ(x.col(0).dot(y) / 8, 13.875);
    EXPECT_DOUBLE_EQ(x.col(1).dot(y) / 8, 35.625);
    EXPECT_DOUBLE_EQ(x.col(0).cwiseProduct(x.col(1)).dot(y) / 8, 11.875);
}

// Resolutions as tabulated by Box, Hunter and Hunter (1978), table 12.15.
TEST(FractionalFactorial, ChosenFractionsHaveTheTabulatedResolution)
{
    struct Case
    {
        int factors, runs, resolution;
    };
    for (auto const& [factors, runs, resolution] :
         {Case{3, 4, 3},    Case{4, 8, 4},   Case{5, 16, 5},  Case{5, 8, 3},    Case{6, 32, 6},
          Case{6, 16, 4},   Case{6, 8, 3},   Case{7, 64, 7},  Case{7, 32, 4},   Case{7, 16, 4},
          Case{7, 8, 3},    Case{8, 64, 5},  Case{8, 32, 4},  Case{8, 16, 4},   Case{9, 128, 6},
          Case{9, 64, 4},   Case{9, 32, 4},  Case{9, 16, 3},  Case{10, 128, 5}, Case{10, 16, 3},
          Case{11, 128, 5}, Case{11, 64, 4}, Case{11, 32, 4}, Case{15, 16, 3}}) {
        auto const fraction = FractionalFactorial::of_best_resolution(factors, runs);
        EXPECT_EQ(fraction.runs(), runs);
        EXPECT_EQ(fraction.resolution(), resolution) << factors << " factors in " << runs << " runs";
        if (factors <= 9) {
            EXPECT_EQ(resolution_by_brute_force(fraction.coded()), resolution);
        }
    }
}

// Fries and Hunter (1980, Technometrics 22:601): the 2^(7-2) fraction of minimum aberration has one word of
// length 4 and two of length 5.
TEST(FractionalFactorial, ChosenFractionHasMinimumAberration)
{
    auto const relation = FractionalFactorial::of_best_resolution(7, 32).defining_relation();
    std::vector<int> lengths;
    for (Word word : relation)
        lengths.push_back(word.length());
    EXPECT_EQ(lengths, (std::vector<int>{4, 5, 5}));
}

TEST(FractionalFactorial, SmallestThatKeepsMainEffectsClear)
{
    EXPECT_EQ(FractionalFactorial::smallest_of_resolution_four(2).runs(), 4);
    EXPECT_EQ(FractionalFactorial::smallest_of_resolution_four(3).runs(), 8);
    EXPECT_EQ(FractionalFactorial::smallest_of_resolution_four(6).runs(), 16);
    EXPECT_EQ(FractionalFactorial::smallest_of_resolution_four(8).runs(), 16);
    EXPECT_EQ(FractionalFactorial::smallest_of_resolution_four(9).runs(), 32);
    for (int factors = 2; factors <= 12; ++factors) {
        int const resolution = FractionalFactorial::smallest_of_resolution_four(factors).resolution();
        EXPECT_TRUE(resolution == 0 || resolution >= 4) << factors;
    }
}

TEST(FractionalFactorial, NegativeGeneratorGivesTheOtherHalf)
{
    auto const design = FractionalFactorial(3, {"C=-AB"}).coded();
    EXPECT_EQ(design.col(2), -design.col(0).cwiseProduct(design.col(1)));
    EXPECT_EQ(FractionalFactorial(3, {"C=-AB"}).aliases(),
              (std::vector<std::string>{"A = -BC", "B = -AC", "C = -AB"}));
}

TEST(FractionalFactorial, RefusesGeneratorsThatMakeNoSense)
{
    EXPECT_THROW(FractionalFactorial(5, {"E"}), InputError);
    EXPECT_THROW(FractionalFactorial(5, {"E=ABZ"}), InputError);
    EXPECT_THROW(FractionalFactorial(5, {"E=AB", "E=ABC"}), InputError);
    EXPECT_THROW(FractionalFactorial(5, {"D=AB", "E=AD"}), InputError);
    EXPECT_THROW(FractionalFactorial(5, {"D=AB", "E=AB"}), InputError);
    EXPECT_THROW(FractionalFactorial::of_best_resolution(6, 20), InputError);
    EXPECT_THROW(FractionalFactorial::of_best_resolution(9, 8), InputError);
}
