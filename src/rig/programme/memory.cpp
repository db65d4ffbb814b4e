#include "demens/rig/programme/memory.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <unistd.h>

namespace demens::rig {

double memory_limit()
{
    double limit = std::numeric_limits<double>::infinity();
    if (long const pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE); pages > 0 && size > 0)
        limit = static_cast<double>(pages) * static_cast<double>(size);
    // Of control groups version 2 and 1; "max" is no number.
    for (auto const* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
        std::ifstream in(file);
        if (double bytes = 0; in >> bytes && bytes > 0)
            limit = std::min(limit, bytes);
    }
    return limit;
}

double memory_needed(double particles)
{
    return 682 * particles;
}

void check_memory(double particles, int ranks, double available)
{
    constexpr double most = std::numeric_limits<std::uint32_t>::max();
    double const needed = memory_needed(particles) / ranks;
    if (particles > most || needed > available)
        throw InputError(
            fmt::format("a run has about {:.3g} particles, which need at least {:.3g} GB of memory{}; "
                        "there are {:.3g} GB, and numbers for {:.3g} particles: are the diameters in "
                        "mm and the mass in kg? Ask for fewer or larger particles",
                        particles, 1e-9 * needed, ranks > 1 ? " on each rank" : "", 1e-9 * available, most));
}

} // namespace demens::rig
