#pragma once

#include "src/rig/custom/setup.hpp"

namespace demens::rig::custom {

//! What a response sees when it looks.
struct Sight
{
    Look& look;
    ResponsePlan const& plan;
    Setup const& setup;
};

//! What can be looked at: a row for each has its keys, and how it is read.
struct Quantity
{
    TableKind keys;
    std::string units;
    std::function<double(Sight const&)> read; //!< NaN: there is nothing
    //! \throws InputError for what cannot be read off the particles of this experiment; null: everything can
    void (*check)(ResponsePlan const& response, OptionValues const& experiment,
                  std::vector<ParticleGroup> const& groups) = nullptr;
    //! The surface that it looks at, kept at the end of the stage; null: it looks at none.
    ProfileReading::Points (*surface)(Sight const& sight) = nullptr;
    bool reads_loads = false; //!< whether it looks at forces, or at energy that they store
};

//! All of them, the one list.
std::vector<Quantity> const& quantities();

//! \throws InputError
Component read_component(std::string const& text);

} // namespace demens::rig::custom
