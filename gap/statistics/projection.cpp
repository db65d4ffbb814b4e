#include "gap/statistics/projection.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/gaussian.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::gap {

Eigen::MatrixXd checked_root(Eigen::MatrixXd const& covariance, std::vector<Cell> const& cells)
{
    Eigen::VectorXd const sd = covariance.diagonal().cwiseSqrt();
    for (Eigen::Index i = 0; i < sd.size(); ++i)
        if (!(sd[i] > 0))
            throw InputError(fmt::format("cell `{}` has no error at all, neither of the measurement nor of "
                                         "packings, surrogate or form: give its sd, or a form floor",
                                         cells[i].name));
    Eigen::VectorXd const inverse = sd.cwiseInverse();
    Eigen::MatrixXd const correlation = inverse.asDiagonal() * covariance * inverse.asDiagonal();
    Eigen::LLT<Eigen::MatrixXd> const factor(correlation);
    Eigen::MatrixXd const root =
        factor.info() == Eigen::Success ? Eigen::MatrixXd(factor.matrixL()) : square_root(correlation);
    for (Eigen::Index i = 0; i < sd.size(); ++i)
        if (!(root(i, i) > 1e-7))
            throw InputError(fmt::format("cell `{}`: its error is wholly given by those of the cells before "
                                         "it, so that a difference would count as infinitely sure: give the "
                                         "sd of its measurement, or leave it out",
                                         cells[i].name));
    return sd.asDiagonal() * root;
}

Projection::Projection(Evidence const& evidence, Eigen::MatrixXd floor) : floor_(std::move(floor))
{
    check(evidence);
    total_ = floor_ + evidence.nuisance * evidence.nuisance_prior * evidence.nuisance.transpose();
    floor_root_ = checked_root(floor_, evidence.cells);
    total_root_ = checked_root(total_, evidence.cells);
}

// Of no columns there are none: Eigen's solvers take a reference to the first number.

Eigen::MatrixXd Projection::whiten(Eigen::MatrixXd const& columns) const
{
    return columns.size() > 0 ? floor_root_.triangularView<Eigen::Lower>().solve(columns) : columns;
}

Eigen::MatrixXd Projection::reduce(Eigen::MatrixXd const& columns) const
{
    return columns.size() > 0 ? total_root_.triangularView<Eigen::Lower>().solve(columns) : columns;
}

Eigen::MatrixXd Projection::solve(Eigen::MatrixXd const& columns) const
{
    return total_root_.triangularView<Eigen::Lower>().transpose().solve(reduce(columns));
}

Eigen::MatrixXd Projection::whitened_projector() const
{
    Eigen::MatrixXd const reduced = reduce(floor_root_);
    return reduced.transpose() * reduced;
}

double Projection::inner(Eigen::VectorXd const& u, Eigen::VectorXd const& v) const
{
    return reduce(u).col(0).dot(reduce(v).col(0));
}

double Projection::absorbed_share(Eigen::VectorXd const& signature) const
{
    double const whole = whiten(signature).squaredNorm();
    return whole > 0 ? std::max(0.0, 1 - reduce(signature).squaredNorm() / whole) : 1;
}

Distances distances(Projection const& projection, std::vector<Signature> const& effects, double strength)
{
    auto const count = static_cast<Eigen::Index>(effects.size());
    Eigen::MatrixXd signatures(projection.size(), count);
    for (Eigen::Index k = 0; k < count; ++k)
        signatures.col(k) = strength * effects[k].typical * effects[k].first;
    Eigen::MatrixXd const reduced = projection.reduce(signatures);
    Eigen::MatrixXd const gram = reduced.transpose() * reduced;

    Distances found;
    found.norms = gram.diagonal().cwiseSqrt();
    found.absorbed.resize(count);
    found.smallest_detectable.resize(count);
    found.cosines = Eigen::MatrixXd::Identity(count, count);
    found.between = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        found.absorbed[i] = projection.absorbed_share(signatures.col(i));
        found.smallest_detectable[i] = found.norms[i] > 0 ? least_distance * strength / found.norms[i]
                                                          : std::numeric_limits<double>::infinity();
        for (Eigen::Index j = 0; j < i; ++j) {
            double const both = found.norms[i] * found.norms[j];
            double const cosine = both > 0 ? std::clamp(gram(i, j) / both, -1.0, 1.0) : 0;
            found.cosines(i, j) = found.cosines(j, i) = cosine;
            found.between(i, j) = found.between(j, i) =
                std::min(found.norms[i], found.norms[j]) * std::sqrt(1 - cosine * cosine);
        }
    }
    return found;
}

std::vector<std::vector<int>> confusable_groups(Distances const& distances, double least)
{
    auto const count = static_cast<int>(distances.norms.size());
    std::vector<std::vector<int>> groups;
    std::vector<bool> taken(count, false);
    auto alike = [&](int i, int j) {
        bool const weak = distances.norms[i] < least || distances.norms[j] < least;
        double const sine = std::sqrt(1 - std::pow(distances.cosines(i, j), 2));
        return weak ? sine < 0.1 : distances.between(i, j) < least;
    };
    for (int first = 0; first < count; ++first) {
        if (taken[first])
            continue;
        taken[first] = true;
        std::vector<int> group{first};
        for (std::size_t next = 0; next < group.size(); ++next)
            for (int other = first + 1; other < count; ++other)
                if (!taken[other] && alike(group[next], other)) {
                    taken[other] = true;
                    group.push_back(other);
                }
        std::sort(group.begin(), group.end());
        groups.push_back(std::move(group));
    }
    return groups;
}

} // namespace demens::gap
