#pragma once

#include "ensemble/effect.hpp"
#include "gap/catalogue/measured_response.hpp"
#include "gap/catalogue/setup.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! Where in the model an effect belongs.
enum class EffectGroup
{
    protocol,
    grains,
    walls,
    cohesion,
    friction,
    contact,
    surroundings,
    measurement
};

//! An effect of the catalogue. One of `settings` and `measured` is there.
struct CatalogueEntry
{
    std::string name;
    EffectGroup group;
    std::string doc;       //!< one line
    std::string amplitude; //!< what its amplitude is, with its unit
    std::string keys;      //!< what it changes, for help
    double typical;        //!< amplitude, as a standard deviation
    ensemble::EffectSign sign = ensemble::EffectSign::either;
    //! What it changes in a campaign; none: its rigs or laws do not allow it.
    std::vector<ensemble::EffectSetting> (*settings)(Setup const& setup) = nullptr;
    MeasuredChange measured = nullptr; //!< of an effect that no simulation needs
};

} // namespace demens::gap

namespace demens {

template <>
inline std::vector<Word<gap::EffectGroup>> const& words_of()
{
    using enum gap::EffectGroup;
    static std::vector<Word<gap::EffectGroup>> const words = {
        {protocol, "protocol"},         {grains, "grains"},          {walls, "walls"},
        {cohesion, "cohesion"},         {friction, "friction"},      {contact, "contact"},
        {surroundings, "surroundings"}, {measurement, "measurement"}};
    return words;
}

} // namespace demens
