#pragma once

#include "ensemble/campaign.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace demens::ensemble {

//! What becomes of runs that somebody takes back.
enum class Fate
{
    redo, //!< as if they had never been run: the next session runs them
    drop  //!< kept, with all that they gave, but out of fits and not counted as failed
};

//! Takes runs of a campaign back. Their waves are in progress again, all other results at hand beside the
//! file, and the campaign goes on: the next session runs what is to be run, and makes the last analysis anew.
//! A kill in between loses nothing but what these runs had given.
//! \param reason kept with dropped runs; may be empty
//! \throws InputError when there is no such run, when somebody works on the campaign, or when a diagnosis
//! rests on the runs; FileError
void take_back(std::filesystem::path const& file, std::vector<int> const& runs, Fate fate,
               std::string const& reason = {}, Rigs const& rigs = rig::all_rigs());

} // namespace demens::ensemble
