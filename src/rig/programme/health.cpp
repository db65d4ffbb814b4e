#include "src/rig/programme/health.hpp"

#include "demens/rig/programme/programme_run.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace demens::rig {
namespace {

//! Where the particle is that has left the domain, of several the first one; empty where none is seen
//! outside.
std::string place_outside(dem::Simulation& simulation)
{
    auto const &lower = simulation.options().domain_lower, &upper = simulation.options().domain_upper;
    auto const view = simulation.read(dem::Fields::places);
    std::optional<std::size_t> first;
    for (std::size_t k = 0; k < view.size(); ++k) {
        Vector3 const p = view.position(k);
        bool const inside = p.x >= lower.x && p.y >= lower.y && p.z >= lower.z && p.x <= upper.x &&
                            p.y <= upper.y && p.z <= upper.z;
        if (!inside && (!first || view.id(k) < view.id(*first)))
            first = k;
    }
    if (!first)
        return "";
    Vector3 const p = 1e3 * view.position(*first), from = 1e3 * lower, to = 1e3 * upper;
    return fmt::format(" at ({:.4g}, {:.4g}, {:.4g}) mm, which reaches from ({:.4g}, {:.4g}, {:.4g}) to "
                       "({:.4g}, {:.4g}, {:.4g}),",
                       p.x, p.y, p.z, from.x, from.y, from.z, to.x, to.y, to.z);
}

} // namespace

void check_health(dem::Simulation& simulation, bool has_rigid_bodies,
                  std::function<std::string()> const& moment)
{
    switch (simulation.health()) {
    case dem::Health::good:
        return;
    case dem::Health::not_a_number:
        throw RunFailure(RunStatus::not_a_number, "a position or force is not a number " + moment());
    case dem::Health::escaped:
        throw RunFailure(RunStatus::escaped,
                         fmt::format("a particle left the domain{} {}", place_outside(simulation), moment()));
    case dem::Health::overlapping:
        throw RunFailure(
            RunStatus::overlapping,
            fmt::format("two bodies overlap by more than {:.0f} % of the smaller radius{} {}",
                        100 * simulation.options().overlap_limit,
                        has_rigid_bodies ? ", or two polyhedra by more than twice their roundings," : "",
                        moment()));
    case dem::Health::leaping:
        throw RunFailure(
            RunStatus::overlapping,
            fmt::format("a particle moved by more than its radius in one step {}; it may have passed "
                        "through other bodies: a smaller time step is needed",
                        moment()));
    case dem::Health::unbalanced:
        throw RunFailure(RunStatus::unbalanced,
                         fmt::format("the energy ledger misses {:.2g} % of the energy turned over, more than "
                                     "energy_closure_limit, {:.2g} %, {}: {}. Run it with half the "
                                     "rayleigh_fraction: what becomes less is the error of the time step, "
                                     "in contacts that are too short for it; what stays is not, e.g. bodies "
                                     "that were put into each other, or a fault of the program",
                                     100 * std::abs(simulation.energy().closure_error()),
                                     100 * simulation.options().closure_limit, moment(),
                                     simulation.energy().gap() > 0 ? "there is more than came in"
                                                                   : "there is less than came in"));
    }
}

} // namespace demens::rig
