#include "tao_calib/surrogate/surrogate.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/surrogate/polynomial.hpp"
#include "tao_calib/surrogate/radial_basis.hpp"

#include <cmath>
#include <fmt/format.h>
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

std::unique_ptr<Surrogate> fit_surrogate(std::string const& kind, Samples const& samples)
{
    if (kind == "quadratic")
        return Polynomial::best_up_to(SurrogateKind::quadratic, samples);
    if (kind == "rbf") {
        if (RadialBasis::can_fit(samples))
            return std::make_unique<RadialBasis>(samples);
        return Polynomial::best_up_to(SurrogateKind::linear, samples);
    }
    throw InputError(
        fmt::format("[surrogate] kind = \"{}\" is not known; known are quadratic and rbf", kind));
}

} // namespace demens::tao_calib
