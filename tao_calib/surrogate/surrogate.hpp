#pragma once

#include "ensemble/input/kinds.hpp"

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace demens::tao_calib {

using ensemble::SurrogateChoice;

//! What a surrogate is fitted to: one location a row, none twice.
struct Samples
{
    Eigen::MatrixXd points;  //!< [n x k] unit cube
    Eigen::VectorXd values;  //!< [n] mean response of the runs at each location
    Eigen::VectorXd weights; //!< [n] number of runs behind each mean
    //! [n] summed squares of the runs about each mean; empty: not known
    Eigen::VectorXd squared_deviations = {};
};

//! Kinds by their number in the campaign file.
enum class SurrogateKind
{
    constant = 0,
    linear = 1,
    linear_and_squares = 2,
    quadratic = 3,
    radial_basis = 4,
    gaussian_process = 5
};
char const* name_of(SurrogateKind kind);

//! One response as a function of the factors in the unit cube.
class Surrogate
{
  public:
    virtual ~Surrogate() = default;

    virtual SurrogateKind kind() const = 0;
    virtual double value(Eigen::VectorXd const& point) const = 0;
    virtual Eigen::VectorXd gradient(Eigen::VectorXd const& point) const = 0;
    //! Standard deviation of value() as an estimate of the mean response, by the surrogate's own assumptions.
    virtual double standard_deviation(Eigen::VectorXd const& point) const = 0;
    //! The same, but never less than the leave-one-out errors support.
    virtual double supported_deviation(Eigen::VectorXd const& point) const
    {
        return standard_deviation(point);
    }
    //! Measured minus predicted from the other locations [n].
    virtual Eigen::VectorXd const& leave_one_out_errors() const = 0;
    //! Degrees of freedom behind the error that standard deviations are stated with.
    virtual double degrees_of_freedom() const = 0;
    //! Smoothing that was chosen, 0 when the surrogate interpolates; NaN where the kind has none.
    virtual double smoothing() const;
};

//! Root mean square of the leave-one-out errors, each location counting by its weight.
double leave_one_out_rmse(Surrogate const& surrogate, Samples const& samples);

//! Fits what was chosen, or a simpler surrogate where the samples do not suffice; `automatic` takes the one
//! with the smallest leave-one-out error.
std::unique_ptr<Surrogate> fit_surrogate(SurrogateChoice choice, Samples const& samples);

} // namespace demens::tao_calib
