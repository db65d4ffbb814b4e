#pragma once

#include "demens/contact/model.hpp"
#include "src/dem/cpu/contact_block.hpp"

#include <string>
#include <vector>

namespace demens::bench {

//! Laws by name, e.g. {"rolling", "epsd2"}; the other kinds as in the plain Hertz-Mindlin contact.
using LawChoice = std::vector<std::pair<std::string, std::string>>;
//! The powder of the speed comparison with these laws, and with coefficients for all of them.
contact::Model powder_with(LawChoice const& choice);
//! Every law of every kind, one at a time.
std::vector<LawChoice> single_laws();

//! One block of contacts with plausible numbers in all lanes.
void fill(dem::ContactBlock& block);
//! Geometry and laws of a contact on one block in cache, the least of several measurements [ns].
double arithmetic_nanoseconds(contact::Model const& model);

} // namespace demens::bench
