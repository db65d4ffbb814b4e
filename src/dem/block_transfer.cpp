#include "demens/dem/block_transfer.hpp"

#include "demens/base/lanes.hpp"

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
    Four const zero{};
    LoadRows rows{{load_four(b.fx + l), load_four(b.fy + l), load_four(b.fz + l), zero},
                  {load_four(b.tix + l), load_four(b.tiy + l), load_four(b.tiz + l), zero},
                  {load_four(b.tjx + l), load_four(b.tjy + l), load_four(b.tjz + l), zero}};
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
                                           Motion const* motions, Periods const& periods)
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
            motion_i[k] = load_four(&motions[i].vx), motion_j[k] = load_four(&motions[j].vx);
            spin_i[k] = load_four(&motions[i].wx), spin_j[k] = load_four(&motions[j].wx);
            // The fourth number of each record, radius or mass, travels in the place of a difference not
            // needed.
            Four difference = place_i[k] - place_j[k];
            if constexpr (periodic)
                difference =
                    difference - (difference > half ? length : none) + (difference < -half ? length : none);
            apart[k] = __builtin_shuffle(difference, place_i[k], FourMask{0, 1, 2, 7});
            faster[k] = __builtin_shuffle(motion_i[k] - motion_j[k], motion_i[k], FourMask{0, 1, 2, 7});
            spin_i[k] = __builtin_shuffle(spin_i[k], place_j[k], FourMask{0, 1, 2, 7});
            spin_j[k] = __builtin_shuffle(spin_j[k], motion_j[k], FourMask{0, 1, 2, 7});
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

} // namespace

void prefetch_contacts(ContactList const& list, std::uint32_t const* slot, std::uint32_t const* end,
                       Particles const& particles)
{
    auto const stride = static_cast<std::size_t>(list.state_size);
    for (; slot < end; ++slot) {
        char const* state = reinterpret_cast<char const*>(list.state.data() + *slot * stride);
        __builtin_prefetch(state, 1);
        __builtin_prefetch(state + 64, 1);
        if (list.with_wall)
            continue;
        std::uint32_t const j = list.second[*slot];
        __builtin_prefetch(&particles.place[j]);
        __builtin_prefetch(&particles.motion[j]);
        __builtin_prefetch(&particles.load[j], 1);
    }
}

void gather_pairs(ContactBlock& block, ContactList const& list, Particles const& particles,
                  Periods const& periods)
{
    auto const gather = periods.any() ? gather_pairs_into<true> : gather_pairs_into<false>;
    gather(block, list, particles.place.data(), particles.motion.data(), periods);
}

void scatter_pairs(ContactBlock const& block, ContactList& list, Particles& particles)
{
    scatter_pairs_from(block, list, particles.load.data());
}

void gather_wall_contacts(ContactBlock& b, ContactList const& list, Particles const& particles,
                          std::vector<Wall> const& walls)
{
    auto const stride = static_cast<std::size_t>(list.state_size);
    for (int l = 0; l < ContactBlock::padded(b.count); ++l) {
        std::uint32_t const slot = slot_of(b, l);
        Place const& p = particles.place[list.first[slot]];
        Motion const& m = particles.motion[list.first[slot]];
        Wall const& wall = walls[list.second[slot]];
        Vector3 const offset = list.offset[slot];
        Vector3 const surface = wall.surface_velocity(Vector3{p.x, p.y, p.z} - offset);
        b.dx[l] = offset.x, b.dy[l] = offset.y, b.dz[l] = offset.z;
        b.radius_i[l] = b.radius_j[l] = p.radius;
        b.mass_i[l] = m.mass, b.mass_j[l] = 1e300;
        b.vx[l] = m.vx - surface.x;
        b.vy[l] = m.vy - surface.y;
        b.vz[l] = m.vz - surface.z;
        b.wix[l] = m.wx, b.wiy[l] = m.wy, b.wiz[l] = m.wz;
        b.wjx[l] = wall.spin.x, b.wjy[l] = wall.spin.y, b.wjz[l] = wall.spin.z;
    }
    for (int l = 0; l < ContactBlock::padded(b.count); l += 4)
        load_history(b, l, list.state.data(), stride);
}

void scatter_wall_contacts(ContactBlock const& b, ContactList& list, Particles& particles,
                           std::vector<Wall> const& walls, std::vector<WallLoad>& wall_loads)
{
    auto const stride = static_cast<std::size_t>(list.state_size);
    for (int l = 0; l < b.count; ++l) {
        std::uint32_t const first = list.first[b.slot[l]], second = list.second[b.slot[l]];
        Vector3 const force{b.fx[l], b.fy[l], b.fz[l]}, torque{b.tix[l], b.tiy[l], b.tiz[l]};
        Load& i = particles.load[first];
        i.fx += force.x, i.fy += force.y, i.fz += force.z;
        i.tx += torque.x, i.ty += torque.y, i.tz += torque.z;
        Place const& p = particles.place[first];
        WallLoad& wall = wall_loads[second];
        wall.force -= force;
        wall.torque -= cross(Vector3{p.x, p.y, p.z} - walls[second].pivot, force) + torque;
    }
    for (int l = 0; l < b.count; l += 4)
        store_history(b, l, b.count - l < 4 ? b.count - l : 4, list.state.data(), stride);
}

} // namespace demens::dem
