#include "demens/observe/potential_energy.hpp"

namespace demens::observe {

double specific_potential_energy(dem::StateView const& particles, double gravity, double lowest)
{
    double mass = 0, moment = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
        mass += particles.mass(k);
        moment += particles.mass(k) * (particles.place(k).z - lowest);
    }
    return gravity * moment / mass;
}

} // namespace demens::observe
