#pragma once

#include "ensemble/reuse/taken_waves.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace demens::ensemble {

//! A table of results that were made elsewhere.
struct ResultFile
{
    std::string experiment; //!< empty: the campaign's only one
    std::filesystem::path file;
};

//! Rows of a table as runs of an experiment: a column for each factor, by its name or path, and for each
//! response; `status` where runs failed. Rows without results, e.g. of a design that `demens export` wrote,
//! are left out. \throws InputError with file, line and column
std::vector<RunRecord> runs_of_table(CampaignInput const& input, int experiment, std::string const& csv,
                                     std::string const& origin);

//! The same of files, as the first waves of a campaign. \throws InputError where a fitted experiment has none
Taken taken_from_tables(CampaignInput const& input, std::vector<ResultFile> const& files);

} // namespace demens::ensemble
