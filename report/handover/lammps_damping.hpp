#pragma once

namespace demens::report {

//! What LAMMPS's `damping tsuji` has to be given so that it damps as a restitution does here: there the
//! coefficient follows from it by a polynomial, here by sqrt(5) |ln e|/sqrt(ln^2 e + pi^2), which is exact.
//! NaN below 0.114, where the polynomial ends.
double tsuji_restitution(double restitution);

//! Young's modulus [Pa] and Poisson's ratio of one material with itself that give a pair's effective moduli.
struct LikeMaterial
{
    double youngs_modulus, poisson_ratio;
};
LikeMaterial like_material(double effective_youngs_modulus, double effective_shear_modulus);

} // namespace demens::report
