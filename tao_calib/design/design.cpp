#include "tao_calib/design/design.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/design/d_optimal.hpp"
#include "tao_calib/design/latin_hypercube.hpp"
#include "tao_calib/design/response_surface.hpp"
#include "tao_calib/design/sobol.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using ensemble::DesignOptions;

// What every maker below gets, and what it gives: a whole design from the options.
struct Request
{
    DesignOptions const& options;
    FactorSpace const& space;
    std::uint64_t seed;
};

//! Enough for a full quadratic and two checks.
int default_points(int factors)
{
    return (factors + 1) * (factors + 2) / 2 + 2;
}

int points_of(Request const& request)
{
    return request.options.points > 0 ? request.options.points : default_points(request.space.size());
}

MatrixXd matrix_of(std::vector<VectorXd> const& rows, int columns)
{
    MatrixXd matrix(static_cast<Index>(rows.size()), columns);
    for (std::size_t i = 0; i < rows.size(); ++i)
        matrix.row(static_cast<Index>(i)) = rows[i].transpose();
    return matrix;
}

//! Whether two points of a space differ by less than a simulation could notice.
bool same_point(FactorSpace const& space, VectorXd const& a, VectorXd const& b)
{
    return (space.coded(a) - space.coded(b)).cwiseAbs().maxCoeff() < 1e-9;
}

//! Brings a design of fixed shape (points of the unit cube) and its centre points into the feasible region.
//! Points outside go towards the middle of the region until they are in; one that lands on another point is
//! dropped. A centre outside is replaced by the middle.
Design fit_into(FactorSpace const& space, MatrixXd const& unit, int centre_points)
{
    std::vector<VectorXd> rows;
    std::vector<std::pair<std::size_t, Index>> moved; // place in rows, place in the design
    std::vector<Index> dropped;
    for (Index i = 0; i < unit.rows(); ++i) {
        VectorXd const point = unit.row(i).transpose();
        VectorXd const values = space.own_units(point);
        if (space.feasible(values)) {
            rows.push_back(values);
            continue;
        }
        if (auto const inside = space.pulled_inside(point)) {
            moved.push_back({rows.size(), i + 1});
            rows.push_back(space.own_units(*inside));
        } else
            dropped.push_back(i + 1);
    }
    for (auto entry = moved.rbegin(); entry != moved.rend(); ++entry) {
        auto const place = entry->first;
        bool const repeated = std::any_of(rows.begin(), rows.end(), [&](VectorXd const& other) {
            return &other != &rows[place] && same_point(space, other, rows[place]);
        });
        if (repeated) {
            rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(place));
            dropped.push_back(entry->second);
            entry->second = 0;
        }
    }

    VectorXd const centre = VectorXd::Constant(space.size(), 0.5);
    bool const centre_feasible = space.feasible(space.own_units(centre));
    for (int i = 0; i < centre_points; ++i)
        rows.push_back(space.own_units(centre_feasible ? centre : space.middle()));

    Design design{matrix_of(rows, space.size()), {}};
    std::vector<Index> moved_points;
    for (auto const& [place, number] : moved)
        if (number > 0)
            moved_points.push_back(number);
    std::sort(dropped.begin(), dropped.end());
    if (!moved_points.empty())
        design.notes.push_back(
            fmt::format("moved onto the constraints: points {} of the unconstrained design",
                        fmt::join(moved_points, ", ")));
    if (!dropped.empty())
        design.notes.push_back(fmt::format(
            "dropped for the constraints: points {} of the unconstrained design", fmt::join(dropped, ", ")));
    if (centre_points > 0 && !centre_feasible)
        design.notes.push_back("the centre breaks a constraint; the middle of what is left stands for it");
    return design;
}

Design plan_latin_hypercube(Request const& request)
{
    auto const& space = request.space;
    int const points = points_of(request);
    if (!space.constrained()) {
        Eigen::MatrixXi const places = maximin_latin_hypercube(points, space.size(), request.seed);
        return {space.own_units_of_rows((places.cast<double>().array() + 0.5) / points), {}};
    }
    auto const chosen = constrained_latin_hypercube(space, points, request.seed);
    Design design{space.own_units_of_rows(chosen.unit), {}};
    if (chosen.empty_strata > 0)
        design.notes.push_back(
            fmt::format("the constraints leave {} of {} strata of the Latin hypercube without a "
                        "point",
                        chosen.empty_strata, points * space.size()));
    return design;
}

//! Points that break a constraint are passed over.
Design plan_sobol(Request const& request)
{
    auto const& space = request.space;
    SobolSequence sequence(space.size());
    std::vector<VectorXd> rows;
    constexpr int most_passed_over = 100'000;
    int const points = points_of(request);
    for (int passed = 0; static_cast<int>(rows.size()) < points && passed < most_passed_over; ++passed) {
        VectorXd const values = space.own_units(sequence.next());
        if (space.feasible(values))
            rows.push_back(values), passed = 0;
    }
    auto const found = rows.size();
    RandomStream random(request.seed);
    while (static_cast<int>(rows.size()) < points)
        rows.push_back(space.own_units(space.sample(random)));
    Design design{matrix_of(rows, space.size()), {}};
    if (found < rows.size())
        design.notes.push_back(
            fmt::format("the constraints leave so little room that {} of {} points are drawn at "
                        "random in place of the sequence",
                        rows.size() - found, rows.size()));
    return design;
}

Design plan_full_factorial(Request const& request)
{
    std::vector<int> levels;
    for (auto const& factor : request.space.factors()) {
        levels.push_back(factor.levels.empty() ? request.options.levels
                                               : static_cast<int>(factor.levels.size()));
        if (levels.back() < 2)
            throw InputError(
                fmt::format("[design] levels = {}: a full factorial needs at least 2", levels.back()));
    }
    Eigen::MatrixXi const places = full_factorial(levels);
    MatrixXd unit(places.rows(), places.cols());
    for (Index k = 0; k < unit.cols(); ++k) {
        // A discrete factor is met in the middle of its level's share, a continuous one from bound to bound.
        bool const discrete = !request.space.factors()[k].levels.empty();
        auto const column = places.col(k).cast<double>().array();
        unit.col(k) = discrete ? ((column + 0.5) / levels[k]).eval() : (column / (levels[k] - 1)).eval();
    }
    return fit_into(request.space, unit, request.options.centre_repetitions);
}

FractionalFactorial fraction_of(Request const& request)
{
    auto const& [options, space, seed] = request;
    if (!options.generators.empty())
        return {space.size(), options.generators};
    return options.points > 0 ? FractionalFactorial::of_best_resolution(space.size(), options.points)
                              : FractionalFactorial::smallest_of_resolution_four(space.size());
}

std::vector<std::string> notes_on(FractionalFactorial const& fraction, FactorSpace const& space)
{
    if (fraction.resolution() == 0)
        return {};
    std::vector<std::string> names, words{"I"};
    for (int k = 0; k < space.size(); ++k)
        names.push_back(fmt::format("{} = {}", factor_letter(k), space.factors()[k].name));
    for (auto const& word : fraction.defining_relation())
        words.push_back(word.text());
    return {fmt::format("{}", fmt::join(names, ", ")),
            fmt::format("fraction of resolution {} by {}; {}", fraction.resolution(),
                        fmt::join(fraction.generators(), ", "), fmt::join(words, " = ")),
            fmt::format("aliases: {}", fmt::join(fraction.aliases(), ", "))};
}

Design plan_fractional_factorial(Request const& request)
{
    auto const fraction = fraction_of(request);
    auto design =
        fit_into(request.space, 0.5 * (fraction.coded().array() + 1), request.options.centre_repetitions);
    auto const notes = notes_on(fraction, request.space);
    design.notes.insert(design.notes.begin(), notes.begin(), notes.end());
    return design;
}

//! The axial points lie on the bounds, the cube inside, since a bound may be where a law ends.
Design plan_central_composite(Request const& request)
{
    auto const& [options, space, seed] = request;
    FractionalFactorial const cube(space.size(), options.generators);
    double const axial =
        options.axial_distance > 0 ? options.axial_distance : rotatable_axial_distance(cube.runs());
    MatrixXd const coded = central_composite(cube, axial) / std::max(axial, 1.0);
    auto design = fit_into(space, 0.5 * (coded.array() + 1), std::max(options.centre_repetitions, 1));
    auto const notes = notes_on(cube, space);
    design.notes.insert(design.notes.begin(), notes.begin(), notes.end());
    return design;
}

Design plan_box_behnken(Request const& request)
{
    return fit_into(request.space, 0.5 * (box_behnken(request.space.size()).array() + 1),
                    std::max(request.options.centre_repetitions, 1));
}

MatrixXd rows_of_table(Request const& request)
{
    auto const& [options, space, seed] = request;
    std::vector<VectorXd> rows;
    for (std::size_t i = 0; i < options.table.size(); ++i) {
        auto const& row = options.table[i];
        if (static_cast<int>(row.size()) != space.size())
            throw InputError(fmt::format("[design] table, row {}: {} values for {} factors", i + 1,
                                         row.size(), space.size()));
        rows.push_back(VectorXd::Map(row.data(), space.size()));
        if (auto const broken = space.violation(rows.back()); !broken.empty())
            throw InputError(fmt::format("[design] table, row {}: {}", i + 1, broken));
    }
    return matrix_of(rows, space.size());
}

Design plan_table(Request const& request)
{
    if (request.options.table.empty())
        throw InputError("[design] kind = \"table\" needs `table`, one list of factor values a design point");
    return {rows_of_table(request), {}};
}

//! Rows of the table come first and count.
Design plan_d_optimal(Request const& request)
{
    auto const& [options, space, seed] = request;
    std::vector<std::size_t> level_counts; // of two levels the square is a constant
    for (auto const& factor : space.factors())
        level_counts.push_back(factor.levels.size());
    auto const model = polynomial_terms(options.model, columns_of_factors(level_counts));
    DOptimalOptions search;
    search.kept = rows_of_table(request);
    search.levels = std::max(options.levels, 3);
    search.runs = (options.points > 0 ? options.points : static_cast<int>(model.size()) + 5) -
                  static_cast<int>(search.kept.rows());
    MatrixXd const added = d_optimal(space, model, search, seed);
    MatrixXd points(search.kept.rows() + added.rows(), space.size());
    points << search.kept, added;
    return {points, {}};
}

} // namespace

Design plan_design(DesignOptions const& options, std::vector<ensemble::Factor> const& factors,
                   std::vector<ensemble::LinearConstraint> const& constraints, std::uint64_t seed)
{
    Request const request{options, FactorSpace(factors, constraints), seed};
    using enum ensemble::DesignKind;
    switch (options.kind) {
    case latin_hypercube:
        return plan_latin_hypercube(request);
    case sobol:
        return plan_sobol(request);
    case full_factorial:
        return plan_full_factorial(request);
    case fractional_factorial:
        return plan_fractional_factorial(request);
    case central_composite:
        return plan_central_composite(request);
    case box_behnken:
        return plan_box_behnken(request);
    case d_optimal:
        return plan_d_optimal(request);
    case table:
        return plan_table(request);
    }
    throw std::logic_error("a design without an implementation");
}

MatrixXd make_design(DesignOptions const& options, std::vector<ensemble::Factor> const& factors,
                     std::vector<ensemble::LinearConstraint> const& constraints, std::uint64_t seed)
{
    return plan_design(options, factors, constraints, seed).points;
}

} // namespace demens::tao_calib
