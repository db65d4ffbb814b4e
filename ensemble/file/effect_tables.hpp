#pragma once

#include "ensemble/campaign.hpp"
#include "ensemble/file/row_writer.hpp"

#include <cstdint>
#include <vector>

namespace demens::ensemble {

//! Numbers of each design point of these runs, which are ordered by point, one row each.
std::vector<double> rows_of(std::vector<double> RunRecord::*member, std::vector<RunRecord> const& runs);

//! The effects of a wave, and a row of their amplitudes for each design point.
void write_effects(RowWriter& writer, Wave const& wave);
//! Effects and amplitudes of the runs, whose points are known. \throws FileError
void read_effects(hid_t file, Wave& wave, CampaignInput const& input, std::int64_t first_point,
                  std::size_t points);

} // namespace demens::ensemble
