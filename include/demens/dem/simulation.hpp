#pragma once

#include "demens/contact/laws.hpp"
#include "demens/contact/model.hpp"
#include "demens/dem/body.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "demens/dem/state_view.hpp"
#include "demens/dem/wall.hpp"
#include "demens/dem/wall_motion.hpp"
#include "src/dem/cpu/contact_block.hpp"
#include "src/dem/cpu/contact_list.hpp"
#include "src/dem/cpu/contact_renewal.hpp"
#include "src/dem/cpu/decomposition/decomposition.hpp"
#include "src/dem/cpu/energy_meter.hpp"
#include "src/dem/cpu/law_stages.hpp"
#include "src/dem/cpu/neighbours.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace demens::dem {

struct SimulationOptions
{
    double time_step = 1e-5;         //!< [s]
    Vector3 gravity = {0, 0, -9.81}; //!< [m/s^2]
    double skin = 1e-3;              //!< distance beyond contact that a neighbour list covers [m]
    double overlap_limit = 0.5;      //!< largest overlap over the smaller radius that counts as healthy
    Vector3 domain_lower = {-1e9, -1e9, -1e9}; //!< particles outside have escaped [m]
    Vector3 domain_upper = {1e9, 1e9, 1e9};
    Periods periodic = {};       //!< particles that leave a period come back on its other side
    bool energy_ledger = false;  //!< account for all energy; the motion is the same, bit for bit
    double closure_limit = 0.05; //!< largest closure error of the ledger that counts as healthy
    Team* team = nullptr;        //!< who shares the simulation; null: nobody
};

enum class Health
{
    good,
    not_a_number,
    escaped,
    overlapping,
    unbalanced //!< the energy ledger does not close
};

//! How many of everything there are. Contacts: with a force in the last step, or within reach of one.
struct Counts
{
    std::size_t particles = 0;
    std::size_t contacts = 0; //!< among particles
    std::size_t wall_contacts = 0;
    std::int64_t rebuilds = 0;                             //!< of the neighbour lists, since the start
    std::size_t particles_of_rank = 0, ghosts_of_rank = 0; //!< this rank of a team, and copies from others
};

//! Spheres and walls that move and touch: the state and one time step of it. With a team, all its ranks make
//! the same calls, const ones too, and see the same state of the whole.
class Simulation
{
  public:
    //! \throws InputError when a pair of `model` names a material that is not in it.
    Simulation(contact::Model const& model, SimulationOptions const& options);

    //! Spheres that enter now; the density of their materials is that of the model.
    IdRange add(BodyBatch const& bodies);
    ParticleId add(Body const& body);
    WallId add(Wall const& wall);
    //! Puts a wall elsewhere, or gives it another shape; it stands still there. The pivot stays.
    void place(WallId wall, WallShape const& shape);
    //! Lets a wall move steadily; ends its motions.
    void move(WallId wall, WallVelocity const& velocity);
    //! Lets a wall move from where it stands; times are those of the simulation. \throws InputError
    void move(WallId wall, std::vector<WallMotion> motions);
    //! An inactive wall touches nothing and stays where it is; motions that are prescribed go on in time.
    void activate(WallId wall, bool on);
    //! New coefficients for the same laws; contacts keep their histories.
    void set_model(contact::Model const& model);

    void advance(std::int64_t steps);

    //! State as of the last step; overlaps are judged since the last call.
    Health health() { return check_health(); }
    //! The particles as they are now. Of a team, all read together, and all of the particles.
    StateView read(Fields fields);
    Wall const& wall(WallId id) const { return walls_[id.value]; }
    //! What the particles did to each wall in the last step. Of a team, all read together.
    std::vector<WallLoad> read_wall_loads() { return wall_loads(); }
    Counts counts();

    // Below: on their way out.

    //! Adds a sphere; returns its id. Solid density and material come from the model.
    std::uint32_t add_particle(Vector3 const& position, double radius, std::uint32_t material,
                               Vector3 const& velocity = {}, Vector3 const& spin = {});
    //! Adds a wall; returns its number.
    std::uint32_t add_wall(Wall const& wall);
    //! Replaces a wall, e.g. to move or remove it; ends its motions.
    void set_wall(std::uint32_t number, Wall const& wall);
    //! Lets a wall move from where it stands; times are those of the simulation. \throws InputError
    void set_motions(std::uint32_t number, std::vector<WallMotion> motions);

    //! One time step.
    void step();
    void steps(std::int64_t count)
    {
        for (std::int64_t k = 0; k < count; ++k)
            step();
    }

    //! State of the particles as of the last rebuild or step; overlaps are judged since the last call.
    Health check_health();

    double time() const { return static_cast<double>(steps_done_) * options_.time_step; }
    std::int64_t steps_done() const { return steps_done_; }
    SimulationOptions const& options() const { return options_; }
    Particles const& particles() const { return parts_ ? parts_->all(particles_) : particles_; }
    std::vector<Wall> const& walls() const { return walls_; }
    //! Force and torque of the particles on each wall in the last step.
    std::vector<WallLoad> const& wall_loads() const
    {
        return parts_ ? parts_->all(wall_loads_) : wall_loads_;
    }
    //! Velocity and spin of particle number k (not id) at the time of its place [m/s], [rad/s].
    Vector3 velocity(std::size_t k) const;
    Vector3 spin(std::size_t k) const;
    double largest_speed() const;  //!< [m/s]
    double kinetic_energy() const; //!< translation and rotation [J]
    //! All energy as of now; the simulation must have been made with the ledger.
    EnergyLedger energy();
    //! Pairs with a force, or within reach of one, and the same with walls, of the last step.
    std::size_t particle_contacts() const;
    std::size_t wall_contacts() const;
    std::int64_t rebuilds() const { return rebuilds_; }
    //! Of a team: particles of this rank alone, and copies of those of others.
    std::size_t particles_here() const { return particles_.owned(); }
    std::size_t ghosts_here() const { return particles_.ghosts; }

  private:
    Wall& stopped(WallId wall);
    void make_law_sets(contact::Model const& model);
    void move();
    double move_walls();
    void rebuild_if_needed();
    void compute_loads();
    void compute_contacts(ContactList& list);
    void evaluate_contacts(ContactList& list, std::uint32_t const* slots, std::size_t count);
    double update_ranges();
    void search_neighbours();
    bool is_outside_domain() const;
    EnergyLedger present_energy() const;
    double potential_energy() const;
    contact::StoredEnergy stored_energy() const;
    Vector3 velocity(Motion const& motion, Load const& load) const;
    Vector3 spin(Motion const& motion, Load const& load) const;
    //! Over all ranks.
    double sum(double value) const { return parts_ ? parts_->sum(value) : value; }
    double largest(double value) const { return parts_ ? parts_->team().largest(value) : value; }

    SimulationOptions options_;
    std::vector<contact::Material> materials_;
    std::vector<contact::LawSet> laws_;
    std::vector<contact::StateLayout> layouts_; //!< of each law set's history
    std::vector<contact::Range> ranges_;        //!< of each law set, for the largest particle
    std::vector<std::uint32_t> interaction_;    //!< law set of materials (a, b) at a * materials + b
    Particles particles_;
    std::vector<Wall> walls_;
    std::vector<WallLoad> wall_loads_;
    std::map<std::uint32_t, MovedWall> moved_walls_; //!< by number
    std::vector<ContactList> lists_; //!< among particles, with walls, and, in a team, with ghosts
    std::vector<std::uint32_t> touching_, parted_; //!< slots found by the pair test
    std::unique_ptr<NeighbourSearch> search_;
    std::unique_ptr<ContactBlock> block_;
    std::unique_ptr<EnergyMeter> meter_;   //!< null without the ledger; of this rank's part
    std::unique_ptr<Decomposition> parts_; //!< null without a team
    std::uint32_t particles_added_ = 0;
    double travelled_ = 0;  //!< bound on how far any body moved since the rebuild [m]
    double near_until_ = 0; //!< distance travelled after which contacts are renewed [m]
    NeighbourReach reach_ = {};
    ContactRenewal renewal_;
    bool list_is_stale_ = true;
    bool first_step_ = true;
    bool left_domain_ = false;
    bool overlapping_ = false; //!< an overlap was beyond the limit since the last check
    std::int64_t steps_done_ = 0, rebuilds_ = 0;
};

//! Rayleigh time of a sphere: a wave crosses its surface (Ning and Thornton 1993) [s].
double rayleigh_time(double radius, contact::Material const& material);

} // namespace demens::dem
