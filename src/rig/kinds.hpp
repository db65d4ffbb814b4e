#pragma once

#include "demens/base/error.hpp"
#include "demens/base/options.hpp"

#include <string>
#include <vector>

// Tables of which each kind has its own keys and a meaning of its own, e.g. the shapes of walls: a kind is
// listed once, in a row with its name, its keys and what is made of them.
namespace demens::rig {

//! A kind and how an entry of it is read.
template <class Made, class... With>
struct ReadKind
{
    TableKind keys;
    Made (*read)(OptionValues const& entry, With... with);
};

//! The keys of all kinds, which are rows with a member `keys`.
template <class Kind>
std::vector<TableKind> keys_of(std::vector<Kind> const& kinds)
{
    std::vector<TableKind> keys;
    for (auto const& kind : kinds)
        keys.push_back(kind.keys);
    return keys;
}

//! The kind of that name. \throws InputError
template <class Kind>
Kind const& kind_named(std::vector<Kind> const& kinds, std::string const& name)
{
    std::string all;
    for (auto const& kind : kinds) {
        if (kind.keys.name == name)
            return kind;
        all += (all.empty() ? "" : ", ") + kind.keys.name;
    }
    throw InputError("\"" + name + "\" is none of " + all);
}

//! What `read()` gives; what it says to be wrong is said to be in `place`, e.g. "wall.drum".
template <class Read>
auto in_place(std::string const& place, Read const& read)
{
    try {
        return read();
    } catch (InputError const& error) {
        throw InputError(place + ": " + error.what());
    }
}

} // namespace demens::rig
