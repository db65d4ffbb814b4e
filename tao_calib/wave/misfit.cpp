#include "tao_calib/wave/misfit.hpp"

#include "tao_calib/regression/distributions.hpp"

#include <algorithm>
#include <cmath>

namespace demens::tao_calib {

using Eigen::MatrixXd;
using Eigen::VectorXd;

ChiSquare::ChiSquare(Assessment const& assessment, VectorXd noise)
    : assessment_(assessment), noise_(std::move(noise)), targets_(noise_.size())
{
    for (int t = 0; t < targets_.size(); ++t)
        targets_[t] = assessment.objective().targets()[t].target.value;
}

VectorXd ChiSquare::residuals(VectorXd const& unit) const
{
    VectorXd responses = assessment_.predict(unit);
    for (int t = 0; t < responses.size(); ++t)
        if (!assessment_.informs(t))
            responses[t] = assessment_.mean_response(t);
    return (responses - targets_).cwiseQuotient(noise_);
}

MatrixXd ChiSquare::slopes(VectorXd const& unit) const
{
    MatrixXd slopes = noise_.cwiseInverse().asDiagonal() * assessment_.response_slopes(unit);
    for (int t = 0; t < slopes.rows(); ++t)
        if (!assessment_.informs(t))
            slopes.row(t).setZero();
    return slopes;
}

//! The error of a prediction is itself known from few runs: it counts as much larger as the 95 % point of
//! Student's t with its degrees of freedom is than that of the normal distribution.
VectorXd target_noise(Assessment const& assessment, VectorXd const& unit)
{
    constexpr double normal_95 = 1.959964;
    VectorXd prediction = assessment.prediction_sd(unit);
    for (int t = 0; t < prediction.size(); ++t) {
        if (!assessment.informs(t))
            prediction[t] = leave_one_out_rmse(assessment.surrogate(t), assessment.samples(t));
        prediction[t] *= student_t_quantile(0.95, assessment.surrogate(t).degrees_of_freedom()) / normal_95;
    }
    return (assessment.objective().measurement_sd().cwiseAbs2() + prediction.cwiseAbs2()).cwiseSqrt();
}

Estimate estimate(Assessment const& assessment)
{
    constexpr std::size_t most_minima = 5, locations = 2;
    constexpr int rounds = 2; // the noise is that of the place where the round before has ended
    std::vector<VectorXd> starts;
    for (auto const& minimum : assessment.minima())
        if (starts.size() < most_minima)
            starts.push_back(minimum.point);
    auto const ranked = assessment.locations().ranked();
    for (std::size_t i = 0; i < std::min(ranked.size(), locations); ++i)
        starts.push_back(ranked[i]->unit);

    auto const& cube = assessment.cube();
    VectorXd best = assessment.minima().front().point;
    for (int round = 0; round < rounds; ++round) {
        ChiSquare const chi_square(assessment, target_noise(assessment, best));
        LeastSquaresProblem const problem{cube.size(), assessment.objective().size(),
                                          [&](VectorXd const& unit) { return chi_square.residuals(unit); },
                                          [&](VectorXd const& unit) { return chi_square.slopes(unit); }};
        if (round > 0)
            starts = {best};
        double least = chi_square(best);
        for (auto const& start : starts)
            if (auto const found = minimum_from(assessment.solver(), problem, cube, start);
                found.sum_of_squares < least)
                best = found.point, least = found.sum_of_squares;
    }
    Estimate result{best, target_noise(assessment, best)};
    result.chi_square = ChiSquare(assessment, result.noise)(best);
    return result;
}

GoodnessOfFit goodness_of_fit(double chi_square, int targets, int free_factors)
{
    int const spare = targets - free_factors, degrees = spare > 0 ? spare : targets;
    bool const enlarged = spare > 0 && chi_square > spare;
    return {chi_square, degrees, chi_square_p_value(chi_square, degrees),
            enlarged ? std::sqrt(chi_square / spare) : 1.0};
}

} // namespace demens::tao_calib
