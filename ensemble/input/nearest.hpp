#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace demens::ensemble::input {

//! Number of letters to insert, delete, replace or swap with their neighbour to turn one word into the other.
std::size_t edit_distance(std::string const& a, std::string const& b);

//! The candidate that a misspelt word most likely stands for; empty when none is near.
std::string nearest(std::string const& word, std::vector<std::string> const& candidates);

//! `did you mean "restitution"?`, those that the word is a part of, or the list of candidates when none is
//! near.
std::string suggestion(std::string const& word, std::vector<std::string> const& candidates);

} // namespace demens::ensemble::input
