#include "tao_calib/surrogate/surrogate.hpp"

#include "tao_calib/surrogate/gaussian_process.hpp"
#include "tao_calib/surrogate/polynomial.hpp"
#include "tao_calib/surrogate/radial_basis.hpp"

#include <cmath>
#include <limits>

namespace demens::tao_calib {

char const* name_of(SurrogateKind kind)
{
    switch (kind) {
    case SurrogateKind::constant:
        return "constant";
    case SurrogateKind::linear:
        return "linear";
    case SurrogateKind::linear_and_squares:
        return "linear and squares";
    case SurrogateKind::quadratic:
        return "full quadratic";
    case SurrogateKind::radial_basis:
        return "cubic radial basis functions";
    case SurrogateKind::gaussian_process:
        return "Gaussian process";
    }
    return "";
}

double Surrogate::smoothing() const
{
    return std::numeric_limits<double>::quiet_NaN();
}

double leave_one_out_rmse(Surrogate const& surrogate, Samples const& samples)
{
    return std::sqrt(samples.weights.dot(surrogate.leave_one_out_errors().cwiseAbs2()) /
                     samples.weights.sum());
}

namespace {

std::unique_ptr<Surrogate> fit_polynomial(Samples const& samples)
{
    return Polynomial::best_up_to(SurrogateKind::quadratic, samples);
}

std::unique_ptr<Surrogate> fit_radial_basis(Samples const& samples)
{
    if (RadialBasis::can_fit(samples))
        return std::make_unique<RadialBasis>(samples);
    return Polynomial::best_up_to(SurrogateKind::linear, samples);
}

std::unique_ptr<Surrogate> fit_gaussian_process(Samples const& samples)
{
    if (GaussianProcess::can_fit(samples))
        return std::make_unique<GaussianProcess>(samples);
    return Polynomial::best_up_to(SurrogateKind::linear, samples);
}

//! Simple ones first: a later one has to predict better.
std::unique_ptr<Surrogate> fit_best(Samples const& samples)
{
    auto best = fit_polynomial(samples);
    for (auto const& fit : {fit_radial_basis, fit_gaussian_process}) {
        auto candidate = fit(samples);
        if (leave_one_out_rmse(*candidate, samples) < leave_one_out_rmse(*best, samples))
            best = std::move(candidate);
    }
    return best;
}

} // namespace

std::unique_ptr<Surrogate> fit_surrogate(SurrogateChoice choice, Samples const& samples)
{
    switch (choice) {
    case SurrogateChoice::quadratic:
        return fit_polynomial(samples);
    case SurrogateChoice::rbf:
        return fit_radial_basis(samples);
    case SurrogateChoice::gaussian_process:
        return fit_gaussian_process(samples);
    case SurrogateChoice::automatic:
        break;
    }
    return fit_best(samples);
}

} // namespace demens::tao_calib
