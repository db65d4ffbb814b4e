#include "demens/contact/pair_material.hpp"

#include "demens/base/contract.hpp"

#include <cmath>
#include <numbers>

namespace demens::contact {

PairMaterial::PairMaterial(Material const& i, Material const& j, PairProperties const& pair)
    : youngs_modulus_i(i.youngs_modulus), youngs_modulus_j(j.youngs_modulus)
{
    DEMENS_EXPECT(i.youngs_modulus > 0 && j.youngs_modulus > 0, "bodies are not infinitely soft");
    DEMENS_EXPECT(pair.restitution > 0 && pair.restitution <= 1, "a coefficient of restitution");
    auto const plane_compliance = [](Material const& m) {
        return (1 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
    };
    auto const shear_compliance = [](Material const& m) {
        return 2 * (2 - m.poisson_ratio) * (1 + m.poisson_ratio) / m.youngs_modulus;
    };
    effective_youngs_modulus = 1 / (plane_compliance(i) + plane_compliance(j));
    effective_shear_modulus = 1 / (shear_compliance(i) + shear_compliance(j));
    double const log_e = std::log(pair.restitution);
    damping = log_e / std::sqrt(log_e * log_e + std::numbers::pi * std::numbers::pi);
}

} // namespace demens::contact
