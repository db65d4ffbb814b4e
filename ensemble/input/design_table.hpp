#pragma once

#include "demens/base/text/csv.hpp"
#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! Text of the first constraint that a point breaks; empty when it satisfies all.
std::string broken_constraint(CampaignInput const& input, std::vector<double> const& point);

//! What is wrong with values of the factors: bounds, constraints, their number; empty: nothing.
std::string wrong_with_point(std::vector<double> const& point, CampaignInput const& input);

//! The column of each factor, by its path or its name. \throws InputError
std::vector<int> factor_columns(text::CsvTable const& table, std::vector<Factor> const& factors);

//! The points that `[design]` gives, inline or in a CSV file whose columns are the factors: into
//! `input.design.table`, checked against factors and constraints.
//! \param kept files that the input names \return what to warn of \throws InputError with row and column
std::vector<std::string> read_design_table(InputTable const& design, FileSource const& files,
                                           CampaignInput& input, rig::Files& kept);

} // namespace demens::ensemble::input
