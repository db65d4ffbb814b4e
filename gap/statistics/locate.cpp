#include "gap/statistics/locate.hpp"

#include "demens/base/error.hpp"
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
#include <limits>

namespace demens::gap {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

//! chi-square of residuals in the directions of which recalibration leaves enough.
void test_group(LocatedGroup& group, std::vector<int> const& cells, Eigen::VectorXd const& refitted,
                Eigen::MatrixXd const& covariance, Eigen::MatrixXd const& floor, double least_left)
{
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> const eigen(covariance(cells, cells),
                                                                          floor(cells, cells));
    group.chi_square = 0;
    group.degrees_of_freedom = 0;
    // The eigenvectors are orthonormal in the floor's metric, so that v'e has variance lambda.
    for (Eigen::Index k = 0; k < eigen.eigenvalues().size(); ++k)
        if (eigen.eigenvalues()[k] >= least_left) {
            group.chi_square +=
                std::pow(eigen.eigenvectors().col(k).dot(refitted(cells)), 2) / eigen.eigenvalues()[k];
            ++group.degrees_of_freedom;
        }
    group.p = group.degrees_of_freedom > 0
                  ? tao_calib::chi_square_p_value(group.chi_square, group.degrees_of_freedom)
                  : not_a_number;
    group.finding = group.degrees_of_freedom > 0 ? Finding::within_floor : Finding::not_testable;
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
    : projection_(projection), groups_(std::move(groups)), options_(options),
      covariance_(refitted_covariance(projection)),
      precision_(projection.solve(Eigen::MatrixXd::Identity(projection.size(), projection.size())))
{
    std::vector<bool> grouped(evidence.cells.size(), false);
    for (auto const& group : groups_) {
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
        groups_.push_back(std::move(others));

    if (options_.twins < 1)
        throw InputError(fmt::format("`twins` is {}: without twins there is nothing to compare with, 500 "
                                     "are usual",
                                     options_.twins));
    Twins const twins(evidence, projection.floor(), options_.seed);
    for (int i = 0; i < options_.twins; ++i) {
        Eigen::VectorXd const t = sigmas(twins.base(i));
        double largest = 0;
        for (double value : t)
            largest = std::max(largest, std::isnan(value) ? 0 : std::abs(value));
        null_.push_back(largest);
    }
    std::sort(null_.begin(), null_.end());
}

Eigen::VectorXd Locator::sigmas(Eigen::VectorXd const& residual) const
{
    Eigen::VectorXd t = projection_.floor() * projection_.solve(residual);
    for (Eigen::Index j = 0; j < t.size(); ++j)
        t[j] = covariance_(j, j) < options_.least_left * projection_.floor()(j, j)
                   ? not_a_number
                   : t[j] / std::sqrt(covariance_(j, j));
    return t;
}

Located Locator::locate(Eigen::VectorXd const& residual) const
{
    Eigen::VectorXd const solved = projection_.solve(residual);
    Eigen::VectorXd const refitted = projection_.floor() * solved, t = sigmas(residual);
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
    for (auto const& group : groups_) {
        LocatedGroup tested{};
        tested.name = group.name;
        test_group(tested, group.cells, refitted, covariance_, projection_.floor(), options_.least_left);
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
                for (int cell : groups_[i].cells)
                    cells.push_back(&found.cells[cell]);
                mark(cells, options_.level);
            }
    }
    return found;
}

} // namespace demens::gap
