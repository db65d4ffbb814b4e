#pragma once

#include "ensemble/campaign.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace demens::ensemble {

//! Runs of another campaign as the first waves of this one: those of the base model as its design, those with
//! effects as signatures. Numbered anew; seeds stay. \param source what they are marked with
std::vector<Wave> taken_waves(CampaignInput const& here, std::vector<RunRecord> const& runs,
                              std::string const& source);

//! A wave of another campaign with those of its runs that hold.
struct KeptWave
{
    Wave wave;
    std::vector<int> runs_there; //!< number there of each run
};

//! The same wave by wave, each with its purpose; those of which nothing holds are left out.
std::vector<KeptWave> kept_waves(CampaignInput const& here, std::vector<RunRecord> const& runs,
                                 Campaign const& there, std::string const& source);

//! A campaign file as the source of runs: what it is or will be called, and its check sum. \throws FileError
std::string source_text(std::filesystem::path const& file, std::filesystem::path const& called);

//! What a campaign takes over from its `[run] bank`.
struct Taken
{
    std::vector<Wave> waves;
    std::vector<std::string> lines; //!< what it is and what does not hold, for the author
};

//! Reads the bank. \throws InputError with what differs where nothing holds for an experiment that is fitted
Taken taken_from_bank(CampaignInput const& here, std::filesystem::path const& bank,
                      Rigs const& rigs = rig::all_rigs());

} // namespace demens::ensemble
