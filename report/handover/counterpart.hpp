#pragma once

#include "demens/contact/model.hpp"

#include <string>
#include <vector>

namespace demens::report {

//! Other programs that a parameter set is written for.
enum class Code
{
    liggghts,
    lammps,
    mfix,
    edem,
    rocky
};
inline constexpr Code all_codes[] = {Code::liggghts, Code::lammps, Code::mfix, Code::edem, Code::rocky};
//! As it writes itself, with the version or model that the mapping is of.
char const* name_of(Code code);

//! How well another program has something.
enum class Match
{
    same,    //!< by the same formula
    nearest, //!< something like it: results differ
    none     //!< no counterpart
};
char const* name_of(Match match);

//! What stands for a law or a coefficient in another program.
struct Counterpart
{
    Match match = Match::none;
    std::string name = {};  //!< there; empty where there is none
    std::string value = {}; //!< there; empty: for a law
    std::string note = {};  //!< what differs, how the number is turned
};

//! One line of a mapping.
struct MappedItem
{
    std::string path;  //!< e.g. `contact.a_b.rolling_friction`
    std::string value; //!< here
    Counterpart there;
};

//! What stands for a law, by its kind (`normal`, `tangential`, `rolling`, `cohesion`) and word.
Counterpart counterpart_of_law(Code code, std::string const& kind, std::string const& word);
//! What stands for a coefficient of a pair, by its key in `[contact.A_B]`.
Counterpart counterpart_of_coefficient(Code code, std::string const& key,
                                       contact::PairProperties const& pair);

//! All that a model uses: material constants, laws, and the coefficients that these need or that are not 0.
std::vector<MappedItem> mapped(Code code, contact::Model const& model);
//! Whether every law of every pair has a counterpart, the same or near.
bool has_all_laws(std::vector<MappedItem> const& items);

//! Words of the laws of a pair as a campaign names them.
std::string word_of(contact::NormalLaw law);
std::string word_of(contact::TangentialLaw law);
std::string word_of(contact::RollingLaw law);
std::string word_of(contact::CohesionLaw law);

} // namespace demens::report
