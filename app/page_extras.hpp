#pragma once

#include "report/extras.hpp"

#include <filesystem>
#include <vector>

namespace demens::cli {

//! What a reader wants to see on a page beside what it always shows.
struct PageWishes
{
    std::vector<int> pictures; //!< of these runs
    bool film = false;         //!< of these, else of the best run of each experiment
    int frames = 24;           //!< of a film
    bool any() const { return film || !pictures.empty(); }
};

//! Takes pictures from the campaign file, and simulates again what is to be a film. \throws InputError for
//! runs that are not there
report::Extras page_extras(std::filesystem::path const& campaign_file, PageWishes const& wishes);

} // namespace demens::cli
