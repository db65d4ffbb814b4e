#pragma once

#include <filesystem>

namespace demens::report {

//! Writes the report of a campaign, finished or still running, as one HTML file that needs no network.
//! \throws InputError when the campaign cannot be read or the page cannot be written.
void write_report(std::filesystem::path const& campaign_file, std::filesystem::path const& html);

} // namespace demens::report
