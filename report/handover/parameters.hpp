#pragma once

#include "report/handover/counterpart.hpp"

#include <string>

namespace demens::report {

//! The pair of two materials; the first one of the model where they never meet.
contact::PairProperties const& pair_between(contact::Model const& model, std::string const& a,
                                            std::string const& b);

//! LIGGGHTS: material properties as `fix property/global`, without the pair style.
std::string liggghts_properties(contact::Model const& model);
//! What follows `pair_style gran` and `fix wall/gran`: models of the first pair, and keywords at the end.
std::string liggghts_models(contact::Model const& model);
std::string liggghts_keywords(contact::Model const& model);
//! What it does not take of a model, one line each: laws of pairs that differ from those of the first.
std::vector<std::string> liggghts_faults(contact::Model const& model);

//! LAMMPS: what follows `pair_coeff I J` or `fix wall/gran granular`.
std::string lammps_coefficients(contact::Model const& model, std::string const& a, std::string const& b);

//! A file of parameters to be included or copied.
std::string liggghts_parameters(contact::Model const& model);
std::string lammps_parameters(contact::Model const& model);
//! Keywords of an mfix.dat, particles being of the first material and walls of the last.
std::string mfix_parameters(contact::Model const& model);

//! Lines `code, path, value, match, name there, value there, note` of all codes.
std::string mapping_table(contact::Model const& model);
//! The same lines of one code.
std::string parameter_table(Code code, contact::Model const& model);

} // namespace demens::report
