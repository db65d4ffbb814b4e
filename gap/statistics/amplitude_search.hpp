#pragma once

#include "gap/statistics/amplitude_model.hpp"

#include <functional>

//! Where amplitudes are most probable.
namespace demens::gap {

//! Of amplitudes u over `typical` [K].
using AmplitudeFunction = std::function<double(Eigen::VectorXd const& u)>;

//! A function about a point: value + gradient x - x' precision x / 2.
struct Expansion
{
    double value;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd precision;
};

//! By central differences; of a linear model exact, for its function is quadratic.
Expansion expand(AmplitudeModel const& model, AmplitudeFunction const& f, Eigen::VectorXd const& at);

//! The same with no eigenvalue below `least`.
Eigen::MatrixXd at_least(Eigen::MatrixXd const& symmetric, double least);

//! ln of likelihood times prior, but for the constants of the prior.
AmplitudeFunction log_joint(AmplitudeModel const& model, AmplitudeModel::Data const& data);

//! Places where a function is largest, within the signs of the effects; the first one is found in any case,
//! others from further starts where the model is not linear.
std::vector<Eigen::VectorXd> modes(AmplitudeModel const& model, AmplitudeFunction const& f);

enum class AmplitudePrior
{
    typical,
    flat //!< least squares: no amplitude is more probable than another
};
//! Amplitudes over `typical` where ln of density and prior, or with `flat` minus the misfit alone, is largest
//! [K].
Eigen::VectorXd best_amplitudes(AmplitudeModel const& model, AmplitudeModel::Data const& data,
                                AmplitudePrior prior);
//! The same, but only the place that is reached from `start`.
Eigen::VectorXd best_amplitudes_near(AmplitudeModel const& model, AmplitudeModel::Data const& data,
                                     AmplitudePrior prior, Eigen::VectorXd const& start);

} // namespace demens::gap
