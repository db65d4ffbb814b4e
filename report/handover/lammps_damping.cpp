#include "report/handover/lammps_damping.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace demens::report {
namespace {

//! Tsuji et al. (1992), figure 4, as LAMMPS fits it (its manual, pair_style granular).
double tsuji_coefficient(double e)
{
    constexpr double c[] = {1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218};
    double sum = 0;
    for (int k = 6; k >= 0; --k)
        sum = sum * e + c[k];
    return sum;
}

} // namespace

double tsuji_restitution(double restitution)
{
    double const log_e = std::log(restitution);
    double const wanted =
        std::sqrt(5.0) * std::abs(log_e) / std::sqrt(log_e * log_e + std::numbers::pi * std::numbers::pi);
    double low = 0, high = 1;
    if (wanted > tsuji_coefficient(low))
        return std::numeric_limits<double>::quiet_NaN();
    if (wanted <= tsuji_coefficient(high))
        return 1;
    for (int k = 0; k < 60; ++k) {
        double const middle = 0.5 * (low + high);
        (tsuji_coefficient(middle) > wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

LikeMaterial like_material(double effective_youngs_modulus, double effective_shear_modulus)
{
    // With itself E* = E/(2 (1 - nu^2)) and G* = E/(4 (2 - nu) (1 + nu)).
    double const ratio = effective_youngs_modulus / effective_shear_modulus;
    double const poisson_ratio = (ratio - 4) / (ratio - 2);
    return {2 * effective_youngs_modulus * (1 - poisson_ratio * poisson_ratio), poisson_ratio};
}

} // namespace demens::report
