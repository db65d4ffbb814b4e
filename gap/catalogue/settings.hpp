#pragma once

#include "ensemble/effect.hpp"
#include "gap/catalogue/setup.hpp"

#include <string>
#include <vector>

namespace demens::gap {

using Settings = std::vector<ensemble::EffectSetting>;

// What several effects have in common.

//! Every path grows by this share of itself for a unit of amplitude.
Settings scaled(std::vector<std::string> const& paths, double per_unit);
//! So much is added to every path.
Settings added(std::vector<std::string> const& paths, double per_unit);
//! `before` + word + `after`, of each word.
std::vector<std::string> of_each(std::vector<std::string> const& words, std::string const& before,
                                 std::string const& after);
//! Static friction, and kinetic friction where it is given, of these contacts.
Settings friction_scaled(Setup const& setup, std::vector<std::string> const& contacts);

//! A key of each of these contacts grows so much for a unit of amplitude.
Settings of_contacts(std::vector<std::string> const& contacts, std::string const& key, double per_unit);

//! Weight of the grain of mean volume [N].
double grain_weight(Setup const& setup);

} // namespace demens::gap
