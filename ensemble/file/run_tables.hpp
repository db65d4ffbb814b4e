#pragma once

#include "ensemble/campaign.hpp"
#include "ensemble/file/row_writer.hpp"

namespace demens::ensemble {

//! `/waves/0003`
std::string wave_path(int wave);

//! Creates the group of a wave with what is known when it is planned: number, purpose, design, the plan of
//! each run.
void write_plan(RowWriter& writer, Wave const& wave, CampaignInput const& input);
//! Adds status, responses and the other results of each run.
void write_results(RowWriter& writer, Wave const& wave, CampaignInput const& input);
//! Adds series and snapshots, `details[i]` of `runs[i]`.
void write_details(RowWriter& writer, int wave, std::vector<RunRecord> const& runs,
                   std::vector<RunDetails> const& details, CampaignInput const& input);
//! Adds arrays of the calibration; one of the same path is replaced.
void write_analysis(hid_t file, int wave, std::vector<NamedArray> const& arrays);

//! Reads a wave with its results, if it has any yet, and its analysis.
Wave read_wave(hid_t file, int wave, CampaignInput const& input);
//! Series and snapshots of the run in a row of its wave.
RunDetails read_details(hid_t file, int wave, std::size_t row, std::string const& experiment);

} // namespace demens::ensemble
