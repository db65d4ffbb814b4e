#pragma once

#include "tao_calib/surrogate/kriging.hpp"
#include "tao_calib/surrogate/run_error.hpp"
#include "tao_calib/surrogate/surrogate.hpp"

#include <vector>

namespace demens::tao_calib {

//! What a Gaussian process takes for granted about a response.
struct Correlation
{
    Eigen::VectorXd lengths; //!< [k] distance along each factor over which the response changes, unit cube
    double noise = 0;        //!< variance of a run about the mean response over the variance of the latter
};

//! Anisotropic Matern 5/2 process about a constant: smooth twice, with a length of its own along each factor.
//! The scatter of single runs is part of it; a mean over w runs has 1/w of their variance.
class GaussianProcess : public Surrogate
{
  public:
    //! Whether there are samples enough: the constant, and two more than there are factors.
    static bool can_fit(Samples const& samples);

    //! Takes the most likely correlation: restricted likelihood of the means, joined by that of the scatter
    //! between runs at one location, from several starts. can_fit() must hold.
    explicit GaussianProcess(Samples const& samples);
    //! With a given correlation.
    GaussianProcess(Samples const& samples, Correlation correlation);

    SurrogateKind kind() const override { return SurrogateKind::gaussian_process; }
    double value(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd gradient(Eigen::VectorXd const& point) const override;
    double standard_deviation(Eigen::VectorXd const& point) const override;
    double supported_deviation(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd const& leave_one_out_errors() const override { return leave_one_out_; }
    double degrees_of_freedom() const override { return error_.degrees_of_freedom; }

    Correlation const& correlation() const { return correlation_; }
    //! Standard deviation of single runs at one place.
    double run_sd() const;

  private:
    Eigen::VectorXd correlations(Eigen::VectorXd const& point) const;

    Eigen::MatrixXd points_; //!< [n x k]
    Correlation correlation_;
    Kriging kriging_;
    double variance_ = 0; //!< of the process
    Eigen::VectorXd leave_one_out_;
    Eigen::VectorXd run_shares_; //!< [n] 1/runs behind each value
    RunError error_;
};

//! Minus twice the logarithm of the restricted likelihood, the variance profiled out, with the weak prior on
//! the lengths; for a search over the logarithms of lengths and noise [k + 1].
class CorrelationLikelihood
{
  public:
    explicit CorrelationLikelihood(Samples const& samples);
    //! \param gradient by the logarithms, where not null
    double operator()(Eigen::VectorXd const& logarithms, Eigen::VectorXd* gradient) const;

  private:
    std::vector<Eigen::MatrixXd> squared_differences_; //!< [k], each n x n
    Eigen::VectorXd noise_shares_;                     //!< [n] 1/runs
    Eigen::VectorXd centred_;                          //!< values about their mean, in units of their spread
    double replicate_squares_ = 0; //!< summed squares of runs about their location's mean, same units
    double replicate_degrees_ = 0;
};

} // namespace demens::tao_calib
