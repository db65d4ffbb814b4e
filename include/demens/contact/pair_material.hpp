#pragma once

#include "demens/contact/model.hpp"

namespace demens::contact {

//! Elastic and dissipative constants of a pair of materials.
struct PairMaterial
{
    PairMaterial(Material const& i, Material const& j, PairProperties const& pair);

    double youngs_modulus_i, youngs_modulus_j; //!< [Pa]
    double effective_youngs_modulus;           //!< E* [Pa]
    double effective_shear_modulus;            //!< G* [Pa]
    double damping;                            //!< beta = ln e / sqrt(ln^2 e + pi^2) [-], <= 0
};

} // namespace demens::contact
