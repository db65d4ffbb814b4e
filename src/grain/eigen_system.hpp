#pragma once

#include "demens/grain/mass_properties.hpp"

#include <array>

namespace demens::grain {

//! Eigenvalues, ascending, and unit eigenvectors, right-handed.
struct EigenSystem
{
    std::array<double, 3> values;
    std::array<Vector3, 3> vectors;
};

//! Of a symmetric matrix, by Jacobi's rotations: precise to rounding also where values are nearly equal.
EigenSystem eigen_system(SymmetricTensor const& a);

} // namespace demens::grain
