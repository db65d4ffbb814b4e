#include "gap/statistics/locate.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/multiple_testing.hpp"
#include "gap/statistics/refit.hpp"
#include "gap/statistics/twins.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::gap {
namespace {

GroupTest group_test(CellGroup group, Eigen::MatrixXd const& covariance, Eigen::MatrixXd const& floor,
                     double least_left)
{
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> const eigen(
        covariance(group.cells, group.cells), floor(group.cells, group.cells));
    // The eigenvectors are orthonormal in the floor's metric, so that v'e has variance lambda; ascending.
    Eigen::Index const left = (eigen.eigenvalues().array() >= least_left).count();
    Eigen::MatrixXd const directions =
        eigen.eigenvalues().tail(left).cwiseSqrt().cwiseInverse().asDiagonal() *
        eigen.eigenvectors().rightCols(left).transpose();
    return {std::move(group), directions};
}

double chi_square(GroupTest const& test, Eigen::VectorXd const& refitted)
{
    return (test.directions * refitted(test.group.cells)).squaredNorm();
}

//! Rejects among those that have a p value.
template <class Item>
void mark(std::vector<Item*> const& items, double rate)
{
    std::vector<Item*> testable;
    std::vector<double> p_values;
    for (Item* item : items)
        if (item->finding != Finding::not_testable) {
            testable.push_back(item);
            p_values.push_back(item->p);
        }
    auto const rejected = reject_by_rate(p_values, rate);
    for (std::size_t i = 0; i < testable.size(); ++i)
        if (rejected[i])
            testable[i]->finding = Finding::beyond_floor;
}

} // namespace

char const* words(Finding finding)
{
    switch (finding) {
    case Finding::not_testable:
        return "not testable: absorbed by recalibration";
    case Finding::within_floor:
        return "within the floor";
    case Finding::beyond_floor:
        break;
    }
    return "beyond the floor";
}

Locator::Locator(Evidence const& evidence, Projection const& projection, std::vector<CellGroup> groups,
                 LocateOptions const& options)
    : projection_(projection), options_(options), covariance_(refitted_covariance(projection)),
      precision_(projection.solve(Eigen::MatrixXd::Identity(projection.size(), projection.size())))
{
    std::vector<bool> grouped(evidence.cells.size(), false);
    for (auto const& group : groups) {
        if (group.cells.empty())
            throw InputError(fmt::format("group `{}` has no cell", group.name));
        for (int cell : group.cells) {
            if (cell < 0 || cell >= evidence.size())
                throw InputError(
                    fmt::format("group `{}` names cell {} of {}", group.name, cell, evidence.size()));
            grouped[cell] = true;
        }
    }
    CellGroup others{"others", {}};
    for (int i = 0; i < evidence.size(); ++i)
        if (!grouped[i])
            others.cells.push_back(i);
    if (!others.cells.empty())
        groups.push_back(std::move(others));
    for (auto& group : groups)
        groups_.push_back(group_test(std::move(group), covariance_, projection.floor(), options_.least_left));

    if (options_.twins < 1)
        throw InputError(fmt::format("`twins` is {}: without twins there is nothing to compare with, 500 "
                                     "are usual",
                                     options_.twins));
    Twins const twins(evidence, projection.floor(), options_.seed);
    for (int i = 0; i < options_.twins; ++i) {
        Eigen::VectorXd const t = sigmas(projection_.floor() * projection_.solve(twins.base(i)));
        double largest = 0;
        for (double value : t)
            largest = std::max(largest, std::isnan(value) ? 0 : std::abs(value));
        null_.push_back(largest);
    }
    std::sort(null_.begin(), null_.end());
}

double Locator::smallest_p(Eigen::VectorXd const& residual) const
{
    Eigen::VectorXd const solved = projection_.solve(residual);
    Eigen::VectorXd const refitted = projection_.floor() * solved;
    double smallest =
        tao_calib::chi_square_p_value(residual.dot(solved), static_cast<double>(residual.size()));
    for (double t : sigmas(refitted))
        if (!std::isnan(t))
            smallest = std::min(smallest, two_sided_p_value(t));
    for (auto const& test : groups_)
        if (test.directions.rows() > 0)
            smallest = std::min(smallest,
                                tao_calib::chi_square_p_value(chi_square(test, refitted),
                                                              static_cast<double>(test.directions.rows())));
    return smallest;
}

Eigen::VectorXd Locator::left_of(Eigen::VectorXd const& change) const
{
    return sigmas(projection_.floor() * projection_.solve(change));
}

Eigen::VectorXd Locator::sigmas(Eigen::VectorXd const& refitted) const
{
    Eigen::VectorXd t = refitted;
    for (Eigen::Index j = 0; j < t.size(); ++j)
        t[j] = covariance_(j, j) < options_.least_left * projection_.floor()(j, j)
                   ? not_a_number
                   : t[j] / std::sqrt(covariance_(j, j));
    return t;
}

Located Locator::locate(Eigen::VectorXd const& residual) const
{
    Eigen::VectorXd const solved = projection_.solve(residual);
    Eigen::VectorXd const refitted = projection_.floor() * solved, t = sigmas(refitted);
    Located found{};
    for (Eigen::Index j = 0; j < t.size(); ++j) {
        double const floor = projection_.floor()(j, j);
        bool const testable = !std::isnan(t[j]);
        found.cells.push_back({testable ? Finding::within_floor : Finding::not_testable, refitted[j], t[j],
                               std::sqrt(floor), covariance_(j, j) / floor,
                               testable ? two_sided_p_value(t[j]) : not_a_number});
        if (testable)
            found.largest = std::max(found.largest, std::abs(t[j]));
    }
    for (auto const& test : groups_) {
        auto const& group = test.group;
        LocatedGroup tested{};
        tested.name = group.name;
        tested.chi_square = chi_square(test, refitted);
        tested.degrees_of_freedom = static_cast<int>(test.directions.rows());
        bool const testable = tested.degrees_of_freedom > 0;
        tested.p = testable ? tao_calib::chi_square_p_value(tested.chi_square, tested.degrees_of_freedom)
                            : not_a_number;
        tested.finding = testable ? Finding::within_floor : Finding::not_testable;
        // Conditional distribution of some of a normal vector's elements, by its precision.
        Eigen::LLT<Eigen::MatrixXd> const own(precision_(group.cells, group.cells));
        Eigen::VectorXd const of_group = solved(group.cells);
        tested.left_out_chi_square = of_group.dot(own.solve(of_group));
        tested.left_out_p = tao_calib::chi_square_p_value(tested.left_out_chi_square,
                                                          static_cast<double>(group.cells.size()));
        found.groups.push_back(std::move(tested));
    }

    found.critical = quantile(null_, 1 - options_.level);
    auto const as_large = null_.end() - std::lower_bound(null_.begin(), null_.end(), found.largest);
    found.p = (1 + static_cast<double>(as_large)) / (1 + static_cast<double>(null_.size()));
    if (found.beyond_floor()) {
        std::vector<LocatedGroup*> groups;
        for (auto& group : found.groups)
            groups.push_back(&group);
        mark(groups, options_.level);
        for (std::size_t i = 0; i < groups.size(); ++i)
            if (groups[i]->finding == Finding::beyond_floor) {
                std::vector<LocatedCell*> cells;
                for (int cell : groups_[i].group.cells)
                    cells.push_back(&found.cells[cell]);
                mark(cells, options_.level);
            }
    }
    return found;
}

} // namespace demens::gap
