#pragma once

#include <filesystem>
#include <vector>

namespace demens::report {

//! Writes a campaign as files that other programs read, into a folder that is made where there is none:
//! `runs.EXPERIMENT.csv`, a row a run with all digits; `factors.csv`; curves of the shown run of each
//! experiment as `series.EXPERIMENT.csv` and `profile.EXPERIMENT.NAME.csv`; `best.toml`, the campaign with
//! the values of its best point in the place of those that were given, and beside it the files
//! that it names by a path below its folder. \return the files, in the order in
//! which they were written \throws InputError, FileError
std::vector<std::filesystem::path> export_campaign(std::filesystem::path const& campaign,
                                                   std::filesystem::path const& folder);

} // namespace demens::report
