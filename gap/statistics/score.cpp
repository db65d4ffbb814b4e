#include "gap/statistics/score.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::gap {
namespace {

void check(Eigen::MatrixXd const& probabilities, Eigen::MatrixXd const& truths)
{
    if (truths.rows() < 1 || probabilities.rows() != truths.rows() || probabilities.cols() != truths.cols())
        throw InputError(fmt::format("{} x {} probabilities for {} x {} truths: give a row of each for each "
                                     "case, and at least one case",
                                     probabilities.rows(), probabilities.cols(), truths.rows(),
                                     truths.cols()));
    for (Eigen::Index i = 0; i < truths.rows(); ++i)
        if (!(truths.row(i).minCoeff() >= 0) || std::abs(truths.row(i).sum() - 1) > 1e-12)
            throw InputError(fmt::format("the truths of case {} must be shares that sum to 1", i));
}

//! The x at which I_x(a, b) reaches a probability.
double beta_quantile(double a, double b, double probability)
{
    double lower = 0, upper = 1;
    while (upper - lower > 1e-14) {
        double const half = 0.5 * (lower + upper);
        (tao_calib::incomplete_beta(a, b, half) < probability ? lower : upper) = half;
    }
    return 0.5 * (lower + upper);
}

} // namespace

double brier_score(Eigen::MatrixXd const& probabilities, Eigen::MatrixXd const& truths)
{
    check(probabilities, truths);
    return (probabilities - truths).squaredNorm() / static_cast<double>(truths.rows());
}

double log_score(Eigen::MatrixXd const& probabilities, Eigen::MatrixXd const& truths)
{
    check(probabilities, truths);
    Eigen::ArrayXd const right = (truths.array() > 0).select(probabilities.array(), 0).rowwise().sum();
    return -right.max(1e-12).log().mean();
}

std::vector<ReliabilityBin> reliability(Eigen::MatrixXd const& probabilities, Eigen::MatrixXd const& truths,
                                        int bins)
{
    check(probabilities, truths);
    std::vector<ReliabilityBin> found;
    for (int b = 0; b < bins; ++b)
        found.push_back({static_cast<double>(b) / bins, (b + 1.) / bins, 0, 0, 0});
    for (Eigen::Index i = 0; i < probabilities.rows(); ++i)
        for (Eigen::Index k = 0; k < probabilities.cols(); ++k) {
            double const p = probabilities(i, k);
            auto& bin = found[std::clamp(static_cast<int>(p * bins), 0, bins - 1)];
            ++bin.cases;
            bin.said += p;
            bin.happened += truths(i, k) > 0;
        }
    for (auto& bin : found) {
        double const share = bin.cases > 0 ? 1. / bin.cases : std::numeric_limits<double>::quiet_NaN();
        bin.said *= share;
        bin.happened *= share;
    }
    return found;
}

std::pair<double, double> share_interval(int hits, int cases, double confidence)
{
    if (cases < 1 || hits < 0 || hits > cases)
        throw InputError(fmt::format("{} hits of {} cases have no share", hits, cases));
    double const tail = 0.5 * (1 - confidence);
    return {hits == 0 ? 0 : beta_quantile(hits, cases - hits + 1, tail),
            hits == cases ? 1 : beta_quantile(hits + 1, cases - hits, 1 - tail)};
}

FScore location_score(std::vector<bool> const& said, std::vector<bool> const& truth)
{
    if (said.size() != truth.size())
        throw InputError(fmt::format("{} cells were judged, the truth has {}", said.size(), truth.size()));
    int both = 0, of_said = 0, of_truth = 0;
    for (std::size_t i = 0; i < said.size(); ++i) {
        both += said[i] && truth[i];
        of_said += said[i];
        of_truth += truth[i];
    }
    auto share = [](int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : 1.; };
    return {share(both, of_said), share(both, of_truth), share(2 * both, of_said + of_truth)};
}

} // namespace demens::gap
