#include "demens/observe/potential_energy.hpp"

namespace demens::observe {

double specific_potential_energy(dem::StateView const& particles, Vector3 const& gravity,
                                 Vector3 const& lowest)
{
    double const g = norm(gravity);
    Vector3 const up = -1 / g * gravity;
    double mass = 0, moment = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
        mass += particles.mass(k);
        moment += particles.mass(k) * dot(up, particles.position(k) - lowest);
    }
    return g * moment / mass;
}

} // namespace demens::observe
