#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

namespace demens::tao_calib {

//! What a surrogate is fitted to: one location a row, none twice.
struct Samples
{
    Eigen::MatrixXd points;  //!< [n x k] unit cube
    Eigen::VectorXd values;  //!< [n] mean response of the runs at each location
    Eigen::VectorXd weights; //!< [n] number of runs behind each mean
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
    //! Standard deviation of value() as an estimate of the mean response.
    virtual double standard_deviation(Eigen::VectorXd const& point) const = 0;
    //! Measured minus predicted from the other locations [n].
    virtual Eigen::VectorXd const& leave_one_out_errors() const = 0;
    //! Smoothing that was chosen, 0 when the surrogate interpolates; NaN where the kind has none.
    virtual double smoothing() const;
};

//! Root mean square of the leave-one-out errors, each location counting by its weight.
double leave_one_out_rmse(Surrogate const& surrogate, Samples const& samples);

//! Fits the surrogate of that name ("quadratic", "rbf"), or a simpler one where the samples do not suffice.
std::unique_ptr<Surrogate> fit_surrogate(std::string const& kind, Samples const& samples);

} // namespace demens::tao_calib
