#include "gap/statistics/floor.hpp"

#include <cmath>

namespace demens::gap {

Floor make_floor(Evidence const& evidence)
{
    check(evidence);
    auto const n = evidence.size();
    Floor floor;

    Eigen::VectorXd deviations = evidence.experiment_variance;
    if (evidence.repeats.size() > 0)
        deviations.array() /= evidence.repeats.array();
    deviations = deviations.cwiseSqrt();
    Eigen::MatrixXd const correlation = evidence.experiment_correlation.size() > 0
                                            ? evidence.experiment_correlation
                                            : Eigen::MatrixXd::Identity(n, n);
    floor.experiment = deviations.asDiagonal() * correlation * deviations.asDiagonal();

    floor.seed = Eigen::MatrixXd::Zero(n, n);
    for (auto const& scatter : evidence.packing)
        floor.seed(scatter.cells, scatter.cells) =
            shrunk_covariance(scatter.deviations, scatter.degrees_of_freedom).covariance / scatter.packings;

    floor.surrogate = Eigen::MatrixXd::Zero(n, n);
    if (evidence.surrogate_variance.size() > 0)
        floor.surrogate.diagonal() = evidence.surrogate_variance;

    Eigen::VectorXd const errors = evidence.form_floor * scales(evidence.cells);
    floor.form = errors.asDiagonal() *
                 form_correlation(evidence.cells, evidence.cells, evidence.correlation_length) *
                 errors.asDiagonal();
    return floor;
}

Shrunk shrunk_covariance(Eigen::MatrixXd const& deviations, int degrees_of_freedom)
{
    auto const runs = static_cast<double>(deviations.rows());
    auto const m = deviations.cols();
    Eigen::VectorXd const sd = (deviations.colwise().squaredNorm() / degrees_of_freedom).cwiseSqrt();
    Eigen::MatrixXd standardised = deviations * std::sqrt(runs / degrees_of_freedom);
    int varying = 0;
    for (Eigen::Index j = 0; j < m; ++j)
        if (sd[j] > 0) {
            standardised.col(j) /= sd[j];
            ++varying;
        }
    Eigen::MatrixXd const sample = standardised.transpose() * standardised / runs; // ones on the diagonal
    double const off_target = (sample.squaredNorm() - varying) / std::max(varying, 1);
    double scatter = 0;
    for (Eigen::Index k = 0; k < deviations.rows(); ++k)
        scatter += (standardised.row(k).transpose() * standardised.row(k) - sample).squaredNorm();
    scatter /= runs * degrees_of_freedom * std::max(varying, 1);

    double const share = off_target > 0 ? std::min(scatter / off_target, 1.0) : 1;
    Eigen::MatrixXd shrunk = (1 - share) * sample;
    shrunk.diagonal() = sample.diagonal();
    return {sd.asDiagonal() * shrunk * sd.asDiagonal(), share};
}

Eigen::MatrixXd form_correlation(std::vector<Cell> const& rows, std::vector<Cell> const& columns,
                                 double length)
{
    auto correlation = [length](Cell const& a, Cell const& b) {
        if (a.response_family != b.response_family)
            return 0.;
        double square = 0;
        for (std::size_t k = 0; k < a.condition.size(); ++k)
            square += std::pow(a.condition[k] - b.condition[k], 2);
        if (square == 0)
            return 1.;
        if (length == 0)
            return 0.;
        double const x = std::sqrt(3 * square) / length;
        return (1 + x) * std::exp(-x);
    };
    Eigen::MatrixXd k(rows.size(), columns.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = 0; j < columns.size(); ++j)
            k(static_cast<int>(i), static_cast<int>(j)) = correlation(rows[i], columns[j]);
    return k;
}

Eigen::VectorXd scales(std::vector<Cell> const& cells)
{
    Eigen::VectorXd sizes(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        sizes[static_cast<int>(i)] = cells[i].scale;
    return sizes;
}

} // namespace demens::gap
