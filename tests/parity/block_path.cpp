#include "tests/parity/block_path.hpp"

#include "src/dem/cpu/block_transfer.hpp"
#include "src/dem/cpu/law_stages.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

namespace demens::parity {
namespace {

using dem::ContactBlock;

//! The bodies of the scene as the engine keeps them: i of contact c at c, j behind all of these.
class Bodies
{
  public:
    Bodies(Scene const& scene, Case const& the_case)
        : scene_(scene), with_wall_(the_case.partner == Partner::wall)
    {
        list.state_size = the_case.layout.size;
        list.state_scalars = the_case.layout.scalars;
        list.kind = with_wall_ ? dem::ContactKind::wall : dem::ContactKind::pair;
        particles.resize(2 * contacts);
        for (unsigned c = 0; c < contacts; ++c)
            list.add(c, with_wall_ ? (c < contacts_of_first_wall ? 0 : 1) : contacts + c);
        for (contact::WallSurface const& surface : scene.wall)
            walls.push_back({.shape = dem::Rectangle{},
                             .velocity = surface.velocity,
                             .spin = surface.spin,
                             .pivot = surface.pivot});
    }

    void move_to(int moment)
    {
        for (std::size_t c = 0; c < contacts; ++c) {
            auto const& [i, j, apart] = scene_.encounters[c][moment];
            put(c, i);
            put(contacts + c, j);
            if (with_wall_)
                list.offset[c] = apart;
        }
        wall_loads.assign(walls.size(), {});
    }

    dem::ContactList list;
    dem::Particles particles;
    std::vector<dem::Wall> walls;
    std::vector<dem::WallLoad> wall_loads;

  private:
    void put(std::size_t k, contact::Sphere const& s)
    {
        particles.place[k] = {s.centre.x, s.centre.y, s.centre.z, s.radius};
        particles.motion[k] = {s.velocity.x, s.velocity.y, s.velocity.z, s.mass,
                               s.spin.x,     s.spin.y,     s.spin.z,     0.4 * s.mass * s.radius * s.radius};
        particles.load[k] = {};
    }

    Scene const& scene_;
    bool with_wall_;
};

} // namespace

BlockResults evaluate_in_blocks(Scene const& scene, Case const& the_case)
{
    auto const [laws, layout, partner] = the_case;
    bool const with_wall = partner == Partner::wall;
    Bodies bodies(scene, the_case);
    auto const block = std::make_unique<ContactBlock>();
    BlockResults found{Results(contacts * moments, Result{}), {}};
    for (int moment = 0; moment < moments; ++moment) {
        bodies.move_to(moment);
        for (int from = 0; from < contacts; from += ContactBlock::lanes) {
            ContactBlock& b = *block;
            b.count = std::min(ContactBlock::lanes, contacts - from);
            std::iota(b.slot, b.slot + b.count, static_cast<unsigned>(from));
            if (with_wall)
                gather_wall_contacts(b, bodies.list, bodies.particles, bodies.walls);
            else
                gather_pairs(b, bodies.list, bodies.particles, {});
            derive_geometry(b, with_wall, 0.5);
            evaluate_laws(b, laws, layout, time_step);
            for (int l = 0; l < b.count && layout.ledger; ++l) {
                Result& result = found.results[static_cast<std::size_t>((from + l) * moments + moment)];
                result.lost_to_damping = b.lost_to_damping[l],
                result.lost_to_friction = b.lost_to_friction[l];
                result.lost_to_rolling = b.lost_to_rolling[l],
                result.lost_to_cohesion = b.lost_to_cohesion[l];
            }
            if (with_wall)
                scatter_wall_contacts(b, bodies.list, bodies.particles, bodies.walls, bodies.wall_loads);
            else
                scatter_pairs(b, bodies.list, bodies.particles);
        }
        auto const torque = [](dem::Load const& l) { return Vector3{l.tx, l.ty, l.tz}; };
        for (std::size_t c = 0; c < contacts; ++c) {
            Result& result = found.results[c * moments + static_cast<std::size_t>(moment)];
            dem::Load const& i = bodies.particles.load[c];
            result.force = {i.fx, i.fy, i.fz};
            result.torque_i = torque(i);
            result.torque_j = with_wall ? Vector3{} : torque(bodies.particles.load[contacts + c]);
            auto const size = static_cast<std::size_t>(layout.size);
            std::copy_n(bodies.list.state.data() + c * size, size, result.state);
        }
        for (dem::WallLoad const& load : bodies.wall_loads)
            found.wall_sums.push_back({load.force, load.torque});
    }
    return found;
}

} // namespace demens::parity
