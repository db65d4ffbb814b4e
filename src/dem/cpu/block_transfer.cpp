#include "src/dem/cpu/block_transfer.hpp"

#include "demens/base/lanes.hpp"
#include "demens/contact/evaluation/loads.hpp"

namespace demens::dem {
namespace {

//! Slot of lane l; lanes past the last contact repeat it.
DEMENS_INLINE std::uint32_t slot_of(ContactBlock const& b, int l)
{
    return b.slot[l < b.count ? l : b.count - 1];
}

//! Lanes l to l + 3 of four arrays get the numbers of four records each.
DEMENS_INLINE void spread(Four r0, Four r1, Four r2, Four r3, double* a, double* b, double* c, double* d)
{
    transpose(r0, r1, r2, r3);
    store_four(a, r0), store_four(b, r1), store_four(c, r2), store_four(d, r3);
}

DEMENS_INLINE void load_history(ContactBlock& b, int l, double const* state, std::size_t stride)
{
    double const* record[4];
    for (int k = 0; k < 4; ++k)
        record[k] = state + slot_of(b, l + k) * stride;
    for (std::size_t c = 0; c < stride; c += 4)
        spread(load_four(record[0] + c), load_four(record[1] + c), load_four(record[2] + c),
               load_four(record[3] + c), b.state[c] + l, b.state[c + 1] + l, b.state[c + 2] + l,
               b.state[c + 3] + l);
}

DEMENS_INLINE void store_history(ContactBlock const& b, int l, int count, double* state, std::size_t stride)
{
    for (std::size_t c = 0; c < stride; c += 4) {
        Four row[4];
        for (std::size_t k = 0; k < 4; ++k)
            row[k] = load_four(b.state[c + k] + l);
        transpose(row[0], row[1], row[2], row[3]);
        for (int k = 0; k < count; ++k)
            store_four(state + b.slot[l + k] * stride + c, row[k]);
    }
}

//! Force on i, and torques on i and j, as rows of a load record.
struct LoadRows
{
    Four force[4], torque_i[4], torque_j[4];
};

DEMENS_INLINE LoadRows load_rows(ContactBlock const& b, int l)
{
    auto const three = [l](double const* x, double const* y, double const* z) {
        return contact::Components<FourValues>{load_four(x + l), load_four(y + l), load_four(z + l)};
    };
    FourValues const arm_i = load_four(b.arm_i + l), arm_j = load_four(b.arm_j + l);
    auto const loads = contact::body_loads<FourValues>(three(b.nx, b.ny, b.nz), arm_i, arm_j,
                                                       three(b.fx, b.fy, b.fz), three(b.mx, b.my, b.mz));
    auto const& [force, torque_i, torque_j] = loads;
    Four const zero{};
    LoadRows rows{{force.x, force.y, force.z, zero},
                  {torque_i.x, torque_i.y, torque_i.z, zero},
                  {torque_j.x, torque_j.y, torque_j.z, zero}};
    transpose(rows.force[0], rows.force[1], rows.force[2], rows.force[3]);
    transpose(rows.torque_i[0], rows.torque_i[1], rows.torque_i[2], rows.torque_i[3]);
    transpose(rows.torque_j[0], rows.torque_j[1], rows.torque_j[2], rows.torque_j[3]);
    return rows;
}

DEMENS_INLINE void add_to(double* sum, Four const& row)
{
    store_four(sum, load_four(sum) + row);
}
DEMENS_INLINE void subtract_from(double* sum, Four const& row)
{
    store_four(sum, load_four(sum) - row);
}

template <bool periodic>
DEMENS_MULTIVERSION void gather_pairs_into(ContactBlock& b, ContactList const& list, Place const* places,
                                           Motion const* motions, Load const* loads, Periods const& periods)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    Four const half{periods.x.half(), periods.y.half(), never, never};
    Four const length{periods.x.length(), periods.y.length(), 0, 0}, none{};
    auto const stride = static_cast<std::size_t>(list.state_size);
    int const padded = ContactBlock::padded(b.count);
    for (int l = 0; l < padded; l += 4) {
        Four apart[4], place_i[4], place_j[4], faster[4], motion_i[4], motion_j[4], spin_i[4], spin_j[4];
        for (int k = 0; k < 4; ++k) {
            std::uint32_t const slot = slot_of(b, l + k);
            std::uint32_t const i = list.first[slot], j = list.second[slot];
            place_i[k] = load_four(&places[i].x), place_j[k] = load_four(&places[j].x);
            __builtin_prefetch(&loads[j], 1); // for the scatter
            motion_i[k] = load_four(&motions[i].vx), motion_j[k] = load_four(&motions[j].vx);
            spin_i[k] = load_four(&motions[i].wx), spin_j[k] = load_four(&motions[j].wx);
            // The fourth number of each record, radius or mass, travels in the place of a difference not
            // needed.
            Four difference = place_i[k] - place_j[k];
            if constexpr (periodic)
                difference =
                    difference - (difference > half ? length : none) + (difference < -half ? length : none);
            apart[k] = picked<0, 1, 2, 7>(difference, place_i[k]);
            faster[k] = picked<0, 1, 2, 7>(motion_i[k] - motion_j[k], motion_i[k]);
            spin_i[k] = picked<0, 1, 2, 7>(spin_i[k], place_j[k]);
            spin_j[k] = picked<0, 1, 2, 7>(spin_j[k], motion_j[k]);
        }
        spread(apart[0], apart[1], apart[2], apart[3], b.dx + l, b.dy + l, b.dz + l, b.radius_i + l);
        spread(faster[0], faster[1], faster[2], faster[3], b.vx + l, b.vy + l, b.vz + l, b.mass_i + l);
        spread(spin_i[0], spin_i[1], spin_i[2], spin_i[3], b.wix + l, b.wiy + l, b.wiz + l, b.radius_j + l);
        spread(spin_j[0], spin_j[1], spin_j[2], spin_j[3], b.wjx + l, b.wjy + l, b.wjz + l, b.mass_j + l);
        load_history(b, l, list.state.data(), stride);
    }
}

DEMENS_MULTIVERSION void scatter_pairs_from(ContactBlock const& b, ContactList& list, Load* loads)
{
    auto const stride = static_cast<std::size_t>(list.state_size);
    for (int l = 0; l < b.count; l += 4) {
        int const count = b.count - l < 4 ? b.count - l : 4;
        LoadRows const rows = load_rows(b, l);
        for (int k = 0; k < count; ++k) {
            std::uint32_t const slot = b.slot[l + k];
            Load& i = loads[list.first[slot]];
            Load& j = loads[list.second[slot]];
            add_to(&i.fx, rows.force[k]);
            add_to(&i.tx, rows.torque_i[k]);
            subtract_from(&j.fx, rows.force[k]);
            add_to(&j.tx, rows.torque_j[k]);
        }
        store_history(b, l, count, list.state.data(), stride);
    }
}

//! First lane after `from` that touches another wall.
DEMENS_INLINE int end_of_wall(ContactBlock const& b, ContactList const& list, int from)
{
    int end = from + 1;
    while (end < b.count && list.second[b.slot[end]] == list.second[b.slot[from]])
        ++end;
    return end;
}

DEMENS_MULTIVERSION void gather_wall_contacts_into(ContactBlock& b, ContactList const& list,
                                                   Place const* places, Motion const* motions,
                                                   Wall const* walls)
{
    auto const stride = static_cast<std::size_t>(list.state_size);
    int const padded = ContactBlock::padded(b.count);
    ContactBlock::Lane x, y, z;
    for (int l = 0; l < padded; l += 4) {
        Four place[4], motion[4], spin[4];
        for (int k = 0; k < 4; ++k) {
            std::uint32_t const slot = slot_of(b, l + k), i = list.first[slot];
            place[k] = load_four(&places[i].x);
            motion[k] = load_four(&motions[i].vx);
            spin[k] = load_four(&motions[i].wx);
            Vector3 const& offset = list.offset[slot];
            b.dx[l + k] = offset.x, b.dy[l + k] = offset.y, b.dz[l + k] = offset.z;
        }
        spread(place[0], place[1], place[2], place[3], x + l, y + l, z + l, b.radius_i + l);
        spread(motion[0], motion[1], motion[2], motion[3], b.vx + l, b.vy + l, b.vz + l, b.mass_i + l);
        // The moment of inertia goes where the mass of a wall is written below.
        spread(spin[0], spin[1], spin[2], spin[3], b.wix + l, b.wiy + l, b.wiz + l, b.mass_j + l);
        load_history(b, l, list.state.data(), stride);
    }
    for (int from = 0, to = 0; from < b.count; from = to) {
        to = end_of_wall(b, list, from);
        contact::WallSurface const moving = walls[list.second[b.slot[from]]].surface();
        for (int l = from; l < (to < b.count ? to : padded); ++l) {
            Vector3 const surface = moving.velocity_at({x[l], y[l], z[l]}, {b.dx[l], b.dy[l], b.dz[l]});
            b.vx[l] -= surface.x, b.vy[l] -= surface.y, b.vz[l] -= surface.z;
            b.wjx[l] = moving.spin.x, b.wjy[l] = moving.spin.y, b.wjz[l] = moving.spin.z;
            b.radius_j[l] = b.radius_i[l];
            b.mass_j[l] = contact::wall_mass;
        }
    }
}

DEMENS_MULTIVERSION void scatter_wall_contacts_from(ContactBlock const& b, ContactList& list,
                                                    Place const* places, Load* loads, Wall const* walls,
                                                    WallLoad* wall_loads)
{
    auto const stride = static_cast<std::size_t>(list.state_size);
    for (int l = 0; l < b.count; l += 4) {
        int const count = b.count - l < 4 ? b.count - l : 4;
        LoadRows const rows = load_rows(b, l);
        for (int k = 0; k < count; ++k) {
            std::uint32_t const i = list.first[b.slot[l + k]], second = list.second[b.slot[l + k]];
            add_to(&loads[i].fx, rows.force[k]);
            add_to(&loads[i].tx, rows.torque_i[k]);
            Vector3 const force{rows.force[k][0], rows.force[k][1], rows.force[k][2]};
            Vector3 const torque{rows.torque_i[k][0], rows.torque_i[k][1], rows.torque_i[k][2]};
            Vector3 const arm = Vector3{places[i].x, places[i].y, places[i].z} - walls[second].pivot;
            wall_loads[second].force -= force;
            wall_loads[second].torque += contact::torque_on_wall(arm, force, torque);
        }
        store_history(b, l, count, list.state.data(), stride);
    }
}

} // namespace

void gather_pairs(ContactBlock& block, ContactList const& list, Particles const& particles,
                  Periods const& periods)
{
    auto const gather = periods.any() ? gather_pairs_into<true> : gather_pairs_into<false>;
    gather(block, list, particles.place.data(), particles.motion.data(), particles.load.data(), periods);
}

void scatter_pairs(ContactBlock const& block, ContactList& list, Particles& particles)
{
    scatter_pairs_from(block, list, particles.load.data());
}

void gather_wall_contacts(ContactBlock& block, ContactList const& list, Particles const& particles,
                          std::vector<Wall> const& walls)
{
    gather_wall_contacts_into(block, list, particles.place.data(), particles.motion.data(), walls.data());
}

void scatter_wall_contacts(ContactBlock const& block, ContactList& list, Particles& particles,
                           std::vector<Wall> const& walls, std::vector<WallLoad>& wall_loads)
{
    scatter_wall_contacts_from(block, list, particles.place.data(), particles.load.data(), walls.data(),
                               wall_loads.data());
}

} // namespace demens::dem
