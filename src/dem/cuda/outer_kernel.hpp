#pragma once

#include "src/dem/cuda/known_laws.hpp"
#include "src/dem/cuda/mesh_contacts.hpp"
#include "src/dem/cuda/wall_kernel.hpp"
#include "src/dem/surrounding_forces.hpp"

namespace demens::dem::cuda {

//! The contacts of one particle with a mesh in one step, and where they keep their histories: behind the
//! walls that are near it, in places that any mesh may take.
class MeshSlots
{
  public:
    //! \param first its first place
    DEMENS_FUNCTION MeshSlots(View const& v, Replica const& r, std::uint64_t i, std::uint32_t first)
        : v_(v), i_(i), sorted_(r.sorted), first_(first), end_(first + r.mesh_slots),
          old_(v.touching_walls[r.sorted * v.all + i])
    {
    }

    //! Finds contacts with a wall that go on: a contact takes the history of the one whose normal was nearest
    //! to its own; the deepest comes first.
    DEMENS_FUNCTION void match(std::uint32_t wall, Vector3 const* contacts, std::uint32_t count)
    {
        for (std::uint32_t c = 0; c < count; ++c) {
            double best = like_normals;
            at_[c] = none;
            for (std::uint32_t k = first_; k < end_; ++k) {
                if (!(old_ >> k & 1) || taken_ >> k & 1 || wall_at(k) != wall)
                    continue;
                double const* const was = kept(k) + wall_offset_at;
                Vector3 const old{was[0], was[1], was[2]};
                double const cosine =
                    dot(contacts[c], old) / std::sqrt(norm_squared(contacts[c]) * norm_squared(old));
                if (cosine > best)
                    best = cosine, at_[c] = k;
            }
            if (at_[c] != none)
                taken_ |= 1u << at_[c];
        }
    }

    //! Forgets the contacts with a wall that have parted; visits their places first.
    template <class Visit>
    DEMENS_FUNCTION void part(std::uint32_t wall, Visit const& visit)
    {
        for (std::uint32_t k = first_; k < end_; ++k)
            if (old_ >> k & 1 && !(taken_ >> k & 1) && wall_at(k) == wall) {
                visit(k);
                old_ &= ~(1u << k);
            }
    }

    //! Gives the others new places, or `none` where there is no more room.
    DEMENS_FUNCTION void place(std::uint32_t wall, std::uint32_t count)
    {
        for (std::uint32_t c = 0; c < count; ++c)
            for (std::uint32_t k = first_; k < end_ && at_[c] == none; ++k)
                if (!((old_ | taken_) >> k & 1)) {
                    at_[c] = k;
                    taken_ |= 1u << k;
                    v_.near_wall[v_.at(sorted_, v_.room.walls, k, i_)] = wall;
                }
    }

    static constexpr std::uint32_t none = ~0u;

    //! The place of a contact that was given one last.
    DEMENS_FUNCTION std::uint32_t operator[](std::uint32_t contact) const { return at_[contact]; }
    DEMENS_FUNCTION bool is_new(std::uint32_t contact) const { return !(old_ >> at_[contact] & 1); }
    DEMENS_FUNCTION double* history(std::uint32_t contact) const
    {
        return v_.wall_history_of(sorted_, i_, at_[contact]);
    }
    //! A contact is felt, and goes on.
    DEMENS_FUNCTION void touches(std::uint32_t contact) { now_ |= 1u << at_[contact]; }
    //! Bits of the places of all contacts that are felt.
    DEMENS_FUNCTION std::uint32_t now() const { return now_; }
    DEMENS_FUNCTION std::uint32_t first() const { return first_; }

  private:
    DEMENS_FUNCTION std::uint32_t wall_at(std::uint32_t k) const
    {
        return v_.near_wall[v_.at(sorted_, v_.room.walls, k, i_)];
    }
    DEMENS_FUNCTION double const* kept(std::uint32_t k) const
    {
        return v_.wall_history_of(sorted_, i_, k) + v_.room.history;
    }

    View const& v_;
    std::uint64_t i_;
    std::uint32_t sorted_, first_, end_;
    std::uint32_t old_, taken_ = 0, now_ = 0;
    std::uint32_t at_[most_mesh_contacts];
};

//! One particle, one step, before the step kernel, which goes on from its sum: the loads that are rarely
//! there, which would take registers from those that always are.
template <class Evaluate, bool ledger = false>
struct OuterKernel
{
    View v;
    LawKernel kernel; //!< replicas of others are left alone

    DEMENS_FUNCTION void operator()(Where const& where) const
    {
        Replica& r = v.replica[where.slot];
        bool const finds_loads = r.phase == Phase::load_and_move || r.phase == Phase::load;
        if (!r.has_outer_loads || r.kernel != kernel || !finds_loads || where.local >= r.particles)
            return;
        std::uint64_t const i = v.first_of(where.slot) + where.local, set = r.current * v.all;
        Load load{};
        if (r.mesh_slots > 0 && v.near_meshes[i] != 0)
            add_meshes(r, where.slot, i, v.place[set + i], v.motion[set + i], load);
        if (r.has_surroundings)
            add_surroundings(r, v.place[set + i], v.motion[set + i], load);
        v.load[i] = load;
    }

  private:
    DEMENS_FUNCTION static void add_surroundings(Replica const& r, Place const& here, Motion const& motion,
                                                 Load& load)
    {
        Vector3 const acceleration =
            acceleration_in(r.surroundings, static_cast<double>(step_of(r)) * r.time_step);
        auto const [drag, shaking] = forces_on(r.surroundings, here, motion, acceleration);
        load.fx += drag.x + shaking.x, load.fy += drag.y + shaking.y, load.fz += drag.z + shaking.z;
    }

    DEMENS_FUNCTION void add_meshes(Replica& r, std::uint32_t slot, std::uint64_t i, Place const& here,
                                    Motion const& motion, Load& load) const
    {
        std::uint32_t const near = v.near_meshes[i], material = v.material[r.sorted * v.all + i];
        std::uint32_t const most = r.mesh_slots < most_mesh_contacts ? r.mesh_slots : most_mesh_contacts;
        FlatWall const* const walls = v.walls_of(slot);
        MeshSlots slots(v, r, i, v.near_walls[r.sorted * v.all + i]);
        if constexpr (ledger)
            tally_last_loads(v, r, i, walls, slots.first(), slots.first() + r.mesh_slots);
        for (std::uint32_t w = 0; w < r.walls; ++w) {
            FlatWall const& wall = walls[w];
            if (wall.kind != FlatWall::Kind::mesh || !(near >> w % bits_of_word & 1))
                continue;
            std::uint32_t const law = v.law_of(slot, material, wall.material);
            double const gap = v.ranges[std::uint64_t{slot} * v.room.laws + law].gap;
            PlacedMesh const& mesh = wall.shape.mesh;
            SphereAtMesh const sphere{mesh.placement.inverse({here.x, here.y, here.z}), here.radius,
                                      here.radius + gap};
            MeshTouch::Contact found[most_mesh_contacts];
            std::uint32_t count = MeshTouch(mesh_of(v, mesh), sphere).find(found, most);
            if (count > most) { // until then the deepest count
                want_slots(r);
                count = most;
            }
            Vector3 felt[most_mesh_contacts];
            for (std::uint32_t c = 0; c < count; ++c)
                felt[c] = mesh.placement.rotation(found[c].felt(here.radius));
            slots.match(w, felt, count);
            slots.part(w, [&](std::uint32_t k) {
                if constexpr (ledger)
                    tally_parted<Evaluate>(v, r, i, k,
                                           {wall, std::uint64_t{slot} * v.room.laws + law,
                                            parted_offset(v, r, i, k, sphere.reach)},
                                           here, motion);
            });
            slots.place(w, count);
            for (std::uint32_t c = 0; c < count; ++c)
                add_contact(r, i, slot, slots, c, {wall, law, felt[c]}, here, motion, load);
        }
        std::uint32_t& bits = v.touching_walls[r.sorted * v.all + i];
        bits = (bits & ~(~0u << slots.first())) | slots.now();
    }

    struct Touched
    {
        FlatWall const& wall;
        std::uint32_t law;
        Vector3 const& offset;
    };
    DEMENS_FUNCTION void add_contact(Replica& r, std::uint64_t i, std::uint32_t slot, MeshSlots& slots,
                                     std::uint32_t c, Touched const& touched, Place const& here,
                                     Motion const& motion, Load& load) const
    {
        if (slots[c] == MeshSlots::none)
            return want_slots(r);
        std::uint64_t const law = std::uint64_t{slot} * v.room.laws + touched.law;
        bool const is_new = slots.is_new(c);
        double const reach = here.radius + v.ranges[law].reach(!is_new);
        if (!(norm_squared(touched.offset) < reach * reach)) {
            if constexpr (ledger)
                if (!is_new)
                    tally_parted<Evaluate>(v, r, i, slots[c], {touched.wall, law, touched.offset}, here,
                                           motion);
            return;
        }
        slots.touches(c);
        add_wall_contact<Evaluate, ledger>(
            v, r, {touched.wall, law, i, touched.offset, slots.history(c), is_new}, here, motion, load);
    }

    //! Lists are made anew, with more room for contacts with meshes.
    DEMENS_FUNCTION static void want_slots(Replica& r) { r.mesh_slots_wanted = r.mesh_slots + 1; }
};

} // namespace demens::dem::cuda
