#include "demens/base/contract.hpp"
#include "src/dem/cpu/body_readings.hpp"
#include "src/dem/cpu/cpu_engine.hpp"
#include "src/dem/cpu/decomposition/byte_stream.hpp"
#include "src/dem/cpu/energy_sums.hpp"
#include "src/dem/motion_readings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demens::dem {

Health CpuEngine::health()
{
    Particles const& particles = state_.particles;
    double sum = 0;
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        Place const& p = particles.place[i];
        Motion const& m = particles.motion[i];
        Load const& l = particles.load[i];
        sum += p.x + p.y + p.z + m.vx + m.vy + m.vz + m.wx + m.wy + m.wz + l.fx + l.fy + l.fz + l.tx + l.ty +
               l.tz;
    }
    bool const leaping = partition_->largest(std::exchange(state_.leaping, false) ? 1.0 : 0.0) > 0;
    bool const overlapping = partition_->largest(std::exchange(state_.overlapping, false) ? 1.0 : 0.0) > 0;
    if (partition_->largest(std::isfinite(sum) ? 0.0 : 1.0) > 0)
        return Health::not_a_number;
    if (state_.left_domain)
        return Health::escaped;
    if (leaping)
        return Health::leaping;
    if (overlapping)
        return Health::overlapping;
    SimulationOptions const& options = params_->options;
    bool const balanced =
        !options.energy_ledger || std::abs(energy().closure_error()) <= options.closure_limit;
    return balanced ? Health::good : Health::unbalanced;
}

namespace {

StateView view_of(Particles const& all, Fields fields, CatchUp const& catches_up)
{
    return {{all.place, all.motion, all.load, all.material, all.id}, fields, catches_up};
}

} // namespace

StateView CpuEngine::read(Fields fields)
{
    if (state_.particles.has_bodies) {
        elements_ = partition_->gather(elements_now(*params_, state_));
        return view_of(elements_, fields, {});
    }
    return view_of(partition_->gather(state_.particles, fields), fields, catch_up(*params_, state_));
}

StateView CpuEngine::read_grains(Fields fields)
{
    if (!state_.particles.has_bodies)
        return read(fields);
    grains_ = partition_->gather(grains_now(*params_, state_));
    return view_of(grains_, fields, {});
}

std::vector<HullPlace> CpuEngine::read_hulls()
{
    RigidBodies const& bodies = state_.bodies;
    if (!state_.particles.has_hulls)
        return {};
    struct Hull
    {
        std::uint32_t id, shape;
        Vector3 place;
        Quaternion orientation;
        double radius;
    };
    Team::Bytes mine;
    ByteWriter out(mine);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!bodies.is_hull(b))
            continue;
        std::uint32_t const k = bodies.element[bodies.elements_begin(b)];
        Place const& p = state_.particles.place[k];
        out.put(Hull{state_.particles.id[k],
                     bodies.hull[b],
                     {p.x, p.y, p.z},
                     bodies.pose[b].orientation,
                     bodies.mass[b].radius});
    }
    std::vector<HullPlace> hulls;
    for (auto const& bytes : partition_->gather(std::move(mine)))
        for (ByteReader in(bytes); !in.at_end();) {
            auto const hull = in.get<Hull>();
            hulls.push_back({ParticleId{hull.id}, hull.place, hull.orientation, hull.radius,
                             bodies.hull_shapes[hull.shape]});
        }
    std::sort(hulls.begin(), hulls.end(),
              [](HullPlace const& a, HullPlace const& b) { return a.id.value < b.id.value; });
    return hulls;
}

std::vector<WallLoad> CpuEngine::read_wall_loads()
{
    return partition_->sum(present().wall_loads);
}

double CpuEngine::largest_speed()
{
    return partition_->largest(std::max(dem::largest_speed(state_.particles, catch_up(*params_, state_)),
                                        largest_speed_of_bodies(*params_, state_)));
}

double CpuEngine::kinetic_energy()
{
    return partition_->sum(dem::kinetic_energy(*params_, state_));
}

EnergyLedger CpuEngine::energy()
{
    DEMENS_EXPECT(params_->options.energy_ledger, "the simulation was made with the ledger");
    EnergyLedger ledger = partition_->sum(present().ledger);
    note_turn_over(state_.tally, ledger);
    return ledger;
}

namespace {

double count_touching(std::vector<ContactList> const& lists)
{
    double count = 0;
    for (ContactList const& list : lists)
        count += share_of(list.kind) *
                 static_cast<double>(std::count(list.touching.begin(), list.touching.end(), 1));
    return count;
}
double count_touching(std::vector<HullContactList> const& lists)
{
    double count = 0;
    for (HullContactList const& list : lists)
        count += share_of(list.kind) * static_cast<double>(list.touching());
    return count;
}

} // namespace

Counts CpuEngine::counts()
{
    ContactLists const& contacts = state_.contacts;
    HullContactLists const& hulls = state_.hulls;
    double const pairs = count_touching(contacts.pairs) + count_touching(contacts.ghosts) +
                         count_touching(hulls.pairs) + count_touching(hulls.ghosts);
    double const walls = count_touching(contacts.walls) + count_touching(hulls.walls);
    RigidBodies const& bodies = state_.bodies;
    double const beside = state_.particles.has_bodies
                              ? partition_->sum(static_cast<double>(bodies.all_ids() - bodies.size()))
                              : 0; // ids of bodies that are not the first one
    std::size_t const elements = state_.particles_added - state_.particles_removed;
    return {.particles = elements - static_cast<std::size_t>(beside),
            .elements = elements,
            .contacts = static_cast<std::size_t>(partition_->sum(pairs)),
            .wall_contacts = static_cast<std::size_t>(partition_->sum(walls)),
            .rebuilds = state_.lists.rebuilds,
            .particles_of_rank = state_.particles.owned(),
            .ghosts_of_rank = state_.particles.ghosts};
}

} // namespace demens::dem
