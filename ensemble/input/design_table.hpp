#pragma once

#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! Text of the first constraint that a point breaks; empty when it satisfies all.
std::string broken_constraint(CampaignInput const& input, std::vector<double> const& point);

//! The points that `[design]` gives, inline or in a CSV file whose columns are the factors: into
//! `input.design.table`, checked against factors and constraints.
//! \param kept files that the input names \return what to warn of \throws InputError with row and column
std::vector<std::string> read_design_table(InputTable const& design, FileSource const& files,
                                           CampaignInput& input, rig::Files& kept);

} // namespace demens::ensemble::input
