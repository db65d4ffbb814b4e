#pragma once

#include "demens/base/file_error.hpp"
#include "demens/rig/rig.hpp"
#include "ensemble/storage/journal.hpp"

#include <chrono>

namespace demens::ensemble {

//! Tells a journal now and then how far a run is: as `RunHooks::on_progress`, while the journal lives.
inline auto progress_notes(Journal& journal, int run)
{
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds between{15};
    return [&journal, run, next = Clock::now() + between](rig::RunProgress const& at) mutable {
        if (Clock::now() < next)
            return;
        next = Clock::now() + between;
        try {
            journal.at(run, at.share, at.moment);
        } catch (FileError const&) { // no reason to lose the run: it will be told by what it leaves
        }
    };
}

} // namespace demens::ensemble
