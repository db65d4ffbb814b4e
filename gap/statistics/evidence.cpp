#include "gap/statistics/evidence.hpp"

#include "demens/base/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>

namespace demens::gap {
namespace {

//! Where an array that is a number for each of n cells is not that.
void need_size(char const* array, Eigen::Index size, Eigen::Index right, char const* of)
{
    if (size != right)
        throw InputError(fmt::format("the evidence has {} numbers in `{}` for {} {}: give one for each", size,
                                     array, right, of));
}

void need_finite(char const* array, Eigen::MatrixXd const& rows, std::vector<Cell> const& cells)
{
    if (rows.size() == 0)
        return;
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        if (!rows.row(i).allFinite())
            throw InputError(fmt::format(
                "cell `{}`: `{}` is not a number: leave the cell out, or find out why its runs failed",
                cells[i].name, array));
}

void need_not_negative(char const* array, Eigen::VectorXd const& values, std::vector<Cell> const& cells)
{
    need_finite(array, values, cells);
    for (Eigen::Index i = 0; i < values.size(); ++i)
        if (values[i] < 0)
            throw InputError(fmt::format("cell `{}`: `{}` is {}, and cannot be negative", cells[i].name,
                                         array, values[i]));
}

//! Of numbers for each cell; none of none.
Eigen::VectorXd some(Eigen::VectorXd const& values, std::vector<int> const& cells)
{
    return values.size() > 0 ? Eigen::VectorXd(values(cells)) : values;
}

void check_packing(Evidence const& evidence)
{
    std::vector<int> seen(evidence.cells.size(), 0);
    for (auto const& scatter : evidence.packing) {
        need_size("packing.deviations", scatter.deviations.cols(),
                  static_cast<Eigen::Index>(scatter.cells.size()), "cells of an experiment");
        for (int cell : scatter.cells) {
            if (cell < 0 || cell >= evidence.size())
                throw InputError(fmt::format("`packing.cells` names cell {} of {}", cell, evidence.size()));
            if (seen[cell]++)
                throw InputError(fmt::format("cell `{}` is in two entries of `packing`: each cell has one",
                                             evidence.cells[cell].name));
        }
        if (scatter.packings < 1)
            throw InputError(fmt::format("`packing.packings` is {}: at least one run is behind a prediction",
                                         scatter.packings));
        if (!scatter.deviations.allFinite())
            throw InputError("`packing.deviations` has a number that is missing: leave that run out");
        if (scatter.degrees_of_freedom < 1 || scatter.degrees_of_freedom > scatter.deviations.rows())
            throw InputError(fmt::format("`packing.degrees_of_freedom` is {} of {} runs: it is runs less "
                                         "points, and at least 1; add replicates, or leave the entry out",
                                         scatter.degrees_of_freedom, scatter.deviations.rows()));
    }
}

} // namespace

void check(Evidence const& evidence)
{
    auto const n = evidence.size();
    if (n == 0)
        throw InputError("the evidence has no cell: nothing was measured that could be compared");
    need_size("measured", evidence.measured.size(), n, "cells");
    need_size("predicted", evidence.predicted.size(), n, "cells");
    need_size("nuisance", evidence.nuisance.rows(), n, "cells");
    need_size("nuisance_prior", evidence.nuisance_prior.rows(), evidence.factors(), "factors");
    need_size("nuisance_prior", evidence.nuisance_prior.cols(), evidence.factors(), "factors");
    need_size("experiment_variance", evidence.experiment_variance.size(), n, "cells");
    if (evidence.repeats.size() > 0)
        need_size("repeats", evidence.repeats.size(), n, "cells");
    if (evidence.surrogate_variance.size() > 0)
        need_size("surrogate_variance", evidence.surrogate_variance.size(), n, "cells");
    if (evidence.experiment_correlation.size() > 0) {
        need_size("experiment_correlation", evidence.experiment_correlation.rows(), n, "cells");
        need_size("experiment_correlation", evidence.experiment_correlation.cols(), n, "cells");
        need_finite("experiment_correlation", evidence.experiment_correlation, evidence.cells);
        auto const& correlation = evidence.experiment_correlation;
        if (!correlation.diagonal().isOnes(1e-9) || !correlation.isApprox(correlation.transpose(), 1e-9) ||
            correlation.cwiseAbs().maxCoeff() > 1 + 1e-9)
            throw InputError("`experiment_correlation` is no correlation: it is symmetric, has ones on its "
                             "diagonal and numbers from -1 to 1");
    }
    need_finite("measured", evidence.measured, evidence.cells);
    need_finite("predicted", evidence.predicted, evidence.cells);
    need_finite("nuisance", evidence.nuisance, evidence.cells);
    if (!evidence.nuisance_prior.allFinite() || (evidence.nuisance_prior.diagonal().array() < 0).any() ||
        !evidence.nuisance_prior.isApprox(evidence.nuisance_prior.transpose(), 1e-9))
        throw InputError("`nuisance_prior` is no covariance: it is symmetric, no variance is negative and no "
                         "number is missing");
    for (Eigen::Index i = 0; i < n; ++i)
        if (!std::isfinite(evidence.experiment_variance[i]))
            throw InputError(fmt::format("cell `{}`: `experiment_variance` is not a number: give the sd of "
                                         "the measurement",
                                         evidence.cells[i].name));
    need_not_negative("experiment_variance", evidence.experiment_variance, evidence.cells);
    need_not_negative("surrogate_variance", evidence.surrogate_variance, evidence.cells);
    for (Eigen::Index i = 0; i < evidence.repeats.size(); ++i)
        if (!(evidence.repeats[i] >= 1))
            throw InputError(fmt::format("cell `{}`: `repeats` is {}: at least one measurement is needed",
                                         evidence.cells[i].name, evidence.repeats[i]));
    if (!(evidence.form_floor >= 0) || !(evidence.correlation_length >= 0))
        throw InputError(fmt::format("`form_floor` is {} and `correlation_length` {}: neither is negative",
                                     evidence.form_floor, evidence.correlation_length));
    for (auto const& cell : evidence.cells) {
        if (!(cell.scale >= 0) || cell.scale > 1e300)
            throw InputError(fmt::format("cell `{}`: its scale is {}: give the size of the response",
                                         cell.name, cell.scale));
        if (cell.condition.size() != evidence.cells[0].condition.size())
            throw InputError(fmt::format("cell `{}` has {} coordinates of its condition, `{}` has {}: all "
                                         "have the same",
                                         cell.name, cell.condition.size(), evidence.cells[0].name,
                                         evidence.cells[0].condition.size()));
    }
    check_packing(evidence);
}

void check(Signature const& signature, Evidence const& evidence)
{
    auto need = [&](char const* array, Eigen::Index rows, Eigen::Index columns, Eigen::Index right) {
        if (rows != evidence.size() || columns != right)
            throw InputError(fmt::format("effect `{}`: `{}` is [{} x {}], and must be [{} x {}]: a row for "
                                         "each cell",
                                         signature.name, array, rows, columns, evidence.size(), right));
    };
    need("first", signature.first.size(), 1, 1);
    if (signature.interaction.size() > 0)
        need("interaction", signature.interaction.rows(), signature.interaction.cols(), evidence.factors());
    if (signature.second.size() > 0)
        need("second", signature.second.size(), 1, 1);
    if (signature.first_variance.size() > 0)
        need("first_variance", signature.first_variance.size(), 1, 1);
    for (auto const& [array, values] : {std::pair<char const*, Eigen::MatrixXd>{"first", signature.first},
                                        {"interaction", signature.interaction},
                                        {"second", signature.second},
                                        {"first_variance", signature.first_variance}})
        if (!values.allFinite())
            throw InputError(fmt::format("effect `{}`: `{}` has a number that is missing: leave the cell "
                                         "out, or the effect",
                                         signature.name, array));
    if ((signature.first_variance.array() < 0).any())
        throw InputError(fmt::format("effect `{}`: `first_variance` is negative", signature.name));
    if (!(signature.typical > 0) || !(signature.form_error >= 0))
        throw InputError(fmt::format("effect `{}`: `typical` is {} and must be positive, `form_error` is {} "
                                     "and must not be negative",
                                     signature.name, signature.typical, signature.form_error));
}

Evidence subset(Evidence const& evidence, std::vector<int> const& cells)
{
    Evidence part = evidence;
    part.cells.clear();
    for (int cell : cells)
        part.cells.push_back(evidence.cells[cell]);
    part.measured = some(evidence.measured, cells);
    part.predicted = some(evidence.predicted, cells);
    part.nuisance = evidence.nuisance(cells, Eigen::all);
    part.experiment_variance = some(evidence.experiment_variance, cells);
    part.repeats = some(evidence.repeats, cells);
    part.surrogate_variance = some(evidence.surrogate_variance, cells);
    if (evidence.experiment_correlation.size() > 0)
        part.experiment_correlation = evidence.experiment_correlation(cells, cells);
    part.packing.clear();
    for (auto const& scatter : evidence.packing) {
        auto of_part = scatter;
        of_part.cells.clear();
        std::vector<int> columns;
        for (std::size_t i = 0; i < scatter.cells.size(); ++i)
            for (std::size_t place = 0; place < cells.size(); ++place)
                if (cells[place] == scatter.cells[i]) {
                    of_part.cells.push_back(static_cast<int>(place));
                    columns.push_back(static_cast<int>(i));
                }
        of_part.deviations = scatter.deviations(Eigen::all, columns);
        if (!columns.empty())
            part.packing.push_back(std::move(of_part));
    }
    return part;
}

Signature subset(Signature const& signature, std::vector<int> const& cells)
{
    Signature part = signature;
    part.first = some(signature.first, cells);
    part.second = some(signature.second, cells);
    part.first_variance = some(signature.first_variance, cells);
    if (signature.interaction.size() > 0)
        part.interaction = signature.interaction(cells, Eigen::all);
    return part;
}

std::vector<CellGroup> groups_by_experiment(std::vector<Cell> const& cells)
{
    std::map<int, std::vector<int>> places;
    for (int i = 0; i < static_cast<int>(cells.size()); ++i)
        places[cells[i].experiment].push_back(i);
    std::vector<CellGroup> groups;
    for (auto& [experiment, members] : places)
        groups.push_back({fmt::format("experiment {}", experiment), std::move(members)});
    return groups;
}

} // namespace demens::gap
