#pragma once

#include "demens/contact/evaluation/state_layout.hpp"
#include "demens/contact/laws.hpp"
#include "demens/dem/ids.hpp"
#include "demens/dem/simulation_options.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace demens::dem {

//! What does not change while a simulation runs. Replicas may share it.
struct Params
{
    SimulationOptions options;
    std::vector<contact::Material> materials;
    //! Law set of materials (a, b) at a * materials + b, or `no_laws` where no pair of the model says it.
    std::vector<std::uint32_t> interaction;
    static constexpr std::uint32_t no_laws = 0xffffffff;
    // Of each law set
    std::vector<contact::LawSet> laws;
    std::vector<contact::LawPlaces> places;
    std::vector<contact::StateLayout> layouts; //!< of its histories
};

//! \throws InputError where no pair of the model says how two materials touch.
void require_laws(Params const& params, MaterialId a, MaterialId b);

//! \throws InputError when a pair of the model names a material that is not in it.
std::shared_ptr<Params const> make_params(contact::Model const& model, SimulationOptions const& options);

} // namespace demens::dem
