#include "tao_calib/design/d_optimal.hpp"
#include "tao_calib/design/design.hpp"
#include "tao_calib/design/response_surface.hpp"
#include "tao_calib/design/sobol.hpp"

#include "demens/base/error.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::tao_calib;
using ensemble::DesignKind;
using ensemble::DesignOptions;
using ensemble::Factor;
using ensemble::LinearConstraint;

namespace {

std::vector<Factor> coded_factors(int count)
{
    std::vector<Factor> factors;
    for (int k = 0; k < count; ++k)
        factors.push_back({std::string("f") + char('1' + k), std::string("f") + char('1' + k), -1, 1});
    return factors;
}

//! f2 <= f1, as kinetic friction below static friction.
LinearConstraint second_below_first(int count)
{
    LinearConstraint constraint{"f2 <= f1", std::vector<double>(count, 0.0), 0};
    constraint.coefficients[0] = -1;
    constraint.coefficients[1] = 1;
    return constraint;
}

DesignOptions of_kind(DesignKind kind)
{
    DesignOptions options;
    options.kind = kind;
    return options;
}

Eigen::MatrixXd make(DesignOptions const& options, int factors)
{
    return make_design(options, coded_factors(factors), {}, 1);
}

int rows_of_distance(Eigen::MatrixXd const& points, double distance)
{
    return static_cast<int>(((points.rowwise().norm().array() - distance).abs() < 1e-12).count());
}

} // namespace

TEST(Designs, SobolStartsAsKnown)
{
    Eigen::MatrixXd expected(8, 2);
    expected << 0, 0, .5, .5, .75, .25, .25, .75, .375, .375, .875, .875, .625, .125, .125, .625;
    auto options = of_kind(DesignKind::sobol);
    options.points = 8;
    std::vector<Factor> const unit{{"a", "a", 0, 1}, {"b", "b", 0, 1}};
    EXPECT_EQ(make_design(options, unit, {}, 1), expected);
}

// Point 1000 in ten dimensions as scipy 1.10.1 gives it (qmc.Sobol, not scrambled), times 1024.
TEST(Designs, SobolHasTheDirectionNumbersOfJoeAndKuo)
{
    double const expected[] = {161, 931, 83, 1013, 991, 865, 879, 729, 833, 647};
    SobolSequence sequence(10);
    for (int i = 0; i < 999; ++i)
        sequence.next();
    EXPECT_EQ(1024 * sequence.next(), Eigen::VectorXd::Map(expected, 10));
    EXPECT_THROW(SobolSequence(11), InputError);
}

TEST(Designs, FullFactorialHasAllCombinations)
{
    auto options = of_kind(DesignKind::full_factorial);
    options.levels = 3;
    std::vector<Factor> const factors{
        {"a", "a", 0, 2}, {"b", "b", 1, 100, true}, {"c", "c", 2, 8, false, {2, 8}}};
    auto const points = make_design(options, factors, {}, 1);
    ASSERT_EQ(points.rows(), 18);
    EXPECT_EQ(Eigen::VectorXd(points.row(0)), Eigen::Vector3d(0, 1, 2));
    EXPECT_NEAR(points(4, 1), 10, 1e-12); // middle of 1 and 100 in the logarithm
    EXPECT_EQ(Eigen::VectorXd(points.row(17)), Eigen::Vector3d(2, 100, 8));
}

// The 23 points of three factors: 8 cube, 6 axial at 8^(1/4) = 1.6818, 9 centre; orthogonal and rotatable.
TEST(Designs, CentralCompositeOfTwentyThreePoints)
{
    auto options = of_kind(DesignKind::central_composite);
    options.centre_repetitions = 9;
    auto const points = make(options, 3);
    ASSERT_EQ(points.rows(), 23);
    EXPECT_NEAR(rotatable_axial_distance(8), 1.682, 5e-4);
    EXPECT_EQ(rows_of_distance(points, 1), 6); // on the bounds
    EXPECT_EQ(rows_of_distance(points, std::sqrt(3) / std::pow(8, 0.25)), 8);
    EXPECT_EQ(rows_of_distance(points, 0), 9);

    // Orthogonal: squares, less their means, are uncorrelated but for 9 instead of 9.31 centre points.
    Eigen::MatrixXd const coded = points * rotatable_axial_distance(8);
    Eigen::MatrixXd squares = coded.cwiseAbs2();
    squares.rowwise() -= squares.colwise().mean().eval();
    EXPECT_NEAR(squares.col(0).dot(squares.col(1)) / squares.col(0).squaredNorm(), 0, 0.01);
}

TEST(Designs, CentralCompositeOnTheFacesOfAFraction)
{
    auto options = of_kind(DesignKind::central_composite);
    options.axial_distance = 1;
    options.generators = {"E=ABCD"};
    auto const points = make(options, 5);
    ASSERT_EQ(points.rows(), 16 + 10 + 1);
    EXPECT_EQ(rows_of_distance(points, std::sqrt(5)), 16);
    EXPECT_EQ(rows_of_distance(points, 1), 10);
}

// Box and Behnken (1960): 12, 24, 40, 48, 56 points without the centre; rows on a sphere; a quadratic can be
// fitted.
TEST(Designs, BoxBehnken)
{
    int const counts[] = {12, 24, 40, 48, 56};
    for (int factors = 3; factors <= 7; ++factors) {
        auto options = of_kind(DesignKind::box_behnken);
        options.centre_repetitions = 3;
        auto const points = make(options, factors);
        EXPECT_EQ(points.rows(), counts[factors - 3] + 3);
        EXPECT_EQ(rows_of_distance(points, std::sqrt(factors < 6 ? 2 : 3)), counts[factors - 3]);
        EXPECT_EQ(rows_of_distance(points, 0), 3);
        FactorSpace const space(coded_factors(factors), {});
        EXPECT_GT(information(space, polynomial_terms(PolynomialModel::quadratic, factors), points), 1);
        EXPECT_TRUE(points.colwise().sum().isZero());
    }
    EXPECT_THROW(make(of_kind(DesignKind::box_behnken), 2), InputError);
}

// Largest det(X'X) of a quadratic over the 3 x 3 grid, by enumeration.
TEST(Designs, DOptimalReachesTheLargestDeterminant)
{
    double const largest[] = {256, 960, 2304, 5184, 9360};
    FactorSpace const space(coded_factors(2), {});
    auto const model = polynomial_terms(PolynomialModel::quadratic, 2);
    for (int runs = 6; runs <= 10; ++runs) {
        auto options = of_kind(DesignKind::d_optimal);
        options.points = runs;
        EXPECT_NEAR(information(space, model, make(options, 2)), largest[runs - 6], 1e-9 * largest[runs - 6])
            << runs;
    }
}

TEST(Designs, DOptimalKeepsWhatWasRun)
{
    auto options = of_kind(DesignKind::d_optimal);
    options.points = 9;
    options.table = {{0, 0}, {-1, -1}, {1, 1}, {-1, 1}, {1, 0}};
    auto const points = make(options, 2);
    for (std::size_t i = 0; i < options.table.size(); ++i)
        EXPECT_EQ(Eigen::VectorXd(points.row(static_cast<int>(i))),
                  Eigen::Vector2d::Map(options.table[i].data()));
    // The five points are part of the 3 x 3 factorial, which is optimal for nine.
    FactorSpace const space(coded_factors(2), {});
    EXPECT_NEAR(information(space, polynomial_terms(PolynomialModel::quadratic, 2), points), 5184, 1e-5);
}

// In a triangle the six points that carry a quadratic best are its corners and the middles of its sides
// (Kiefer 1961, Ann. Math. Stat. 32:298).
TEST(Designs, DOptimalInATriangle)
{
    auto options = of_kind(DesignKind::d_optimal);
    options.points = 6;
    auto const points = make_design(options, coded_factors(2), {second_below_first(2)}, 1);
    Eigen::MatrixXd lattice(6, 2);
    lattice << -1, -1, 1, -1, 1, 1, 0, -1, 1, 0, 0, 0;
    FactorSpace const space(coded_factors(2), {second_below_first(2)});
    auto const model = polynomial_terms(PolynomialModel::quadratic, 2);
    EXPECT_NEAR(information(space, model, points), information(space, model, lattice), 1e-9);
}

// A factor of two levels has no square: the five terms left are carried best by all six combinations.
TEST(Designs, DOptimalWithTwoLevels)
{
    auto options = of_kind(DesignKind::d_optimal);
    options.points = 6;
    auto factors = coded_factors(2);
    factors[1].levels = {-1, 1};
    auto const points = make_design(options, factors, {}, 1);
    Eigen::MatrixXd factorial(6, 2);
    factorial << -1, -1, 0, -1, 1, -1, -1, 1, 0, 1, 1, 1;
    FactorSpace const space(factors, {});
    auto const model = polynomial_terms(PolynomialModel::quadratic, columns_of_factors({0, 2}));
    ASSERT_EQ(model.size(), 5u);
    EXPECT_NEAR(information(space, model, points), information(space, model, factorial), 1e-9);
}

TEST(Designs, DOptimalSaysWhenItCannot)
{
    auto options = of_kind(DesignKind::d_optimal);
    options.points = 5;
    EXPECT_THROW(make(options, 2), InputError); // six terms
    options.points = 8;
    auto factors = coded_factors(2);
    factors[1].levels = {-1, 1 - 1e-15, 1}; // a third level that differs by rounding
    try {
        (void)make_design(options, factors, {}, 1);
        FAIL() << "a square on two levels";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("^2 = constant"), std::string::npos) << error.what();
    }
}

TEST(Designs, EveryKindRespectsTheConstraint)
{
    int const factors = 3;
    auto const constraint = second_below_first(factors);
    for (auto const& [kind, name] : words_of<DesignKind>()) {
        auto options = of_kind(kind);
        options.centre_repetitions = 2;
        if (kind == DesignKind::table)
            options.table = {{0.5, 0.25, 0}};
        auto const points = make_design(options, coded_factors(factors), {constraint}, 5);
        EXPECT_GE(points.rows(), 1) << name;
        EXPECT_TRUE((points.col(1).array() <= points.col(0).array() + 1e-12).all()) << name;
        EXPECT_LE(points.cwiseAbs().maxCoeff(), 1) << name;
        EXPECT_EQ(points, make_design(options, coded_factors(factors), {constraint}, 5)) << name;
    }
}

TEST(Designs, FactorialPointsMoveOntoTheConstraint)
{
    auto const design =
        plan_design(of_kind(DesignKind::full_factorial), coded_factors(2), {second_below_first(2)}, 1);
    ASSERT_EQ(design.points.rows(), 4);
    // Order -1 -1, 1 -1, -1 1, 1 1; the third is outside and goes to the side of the triangle.
    EXPECT_NEAR(design.points(2, 0), design.points(2, 1), 1e-9);
    ASSERT_EQ(design.notes.size(), 1u);
    EXPECT_EQ(design.notes[0], "moved onto the constraints: points 3 of the unconstrained design");
}

TEST(Designs, FractionTellsItsAliases)
{
    auto options = of_kind(DesignKind::fractional_factorial);
    options.points = 4;
    auto const design = plan_design(options, coded_factors(3), {}, 1);
    ASSERT_EQ(design.notes.size(), 3u);
    EXPECT_EQ(design.notes[0], "A = f1, B = f2, C = f3");
    EXPECT_EQ(design.notes[1], "fraction of resolution 3 by C=AB; I = ABC");
    EXPECT_EQ(design.notes[2], "aliases: A = BC, B = AC, C = AB");
}

TEST(Designs, BadInputIsNamed)
{
    auto message = [](DesignOptions const& options, std::vector<Factor> const& factors,
                      std::vector<LinearConstraint> const& constraints) -> std::string {
        try {
            make_design(options, factors, constraints, 1);
        } catch (InputError const& error) {
            return error.what();
        }
        return {};
    };
    auto table = of_kind(DesignKind::table);
    table.table = {{0, 0}, {0, 2}};
    EXPECT_EQ(message(table, coded_factors(2), {}),
              "[design] table, row 2: f2 = 2 is outside its bounds -1 to 1");
    table.table = {{0, 0.5}};
    EXPECT_EQ(message(table, coded_factors(2), {second_below_first(2)}),
              "[design] table, row 1: `f2 <= f1` does not hold");
    EXPECT_EQ(message(of_kind(DesignKind::sobol), {{"p", "p", 2, 1}}, {}),
              "factor `p`: lower = 2 is not below upper = 1");
    EXPECT_EQ(message(of_kind(DesignKind::sobol), {{"p", "p", 0, 1, true}}, {}),
              "factor `p`: a logarithmic scale needs lower > 0, not 0");
}
