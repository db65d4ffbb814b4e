#pragma once

#include "demens/contact/laws.hpp"
#include "demens/dem/simulation.hpp"

#include <map>
#include <utility>
#include <vector>

namespace demens::test {

//! The steps of `dem::Simulation` as one would write them down first: every pair of bodies in every step, one
//! after another, without neighbour lists, blocks or lanes. The laws and the shapes of the walls are the
//! engine's; everything between them is written a second time, from the textbook. Walls move steadily only.
class ReferenceLoop
{
  public:
    struct Body
    {
        double radius, mass, inertia; //!< [m], [kg], [kg m^2]
        std::uint32_t material;
        Vector3 position;          //!< [m]
        Vector3 velocity, spin;    //!< half a step behind the position, except before the first step
        Vector3 force{}, torque{}; //!< of the contacts at the position [N], [N m]
    };

    ReferenceLoop(contact::Model const& model, dem::SimulationOptions const& options);

    //! As those of `dem::Simulation`; bodies are numbered in the order in which they were added.
    void add(dem::Body const& body);
    void add(dem::Wall const& wall);
    void step();
    void steps(int count)
    {
        for (int k = 0; k < count; ++k)
            step();
    }

    std::vector<Body> const& bodies() const { return bodies_; }
    std::vector<dem::WallLoad> const& wall_loads() const { return wall_loads_; }
    //! Velocity and spin at the time of the positions.
    Vector3 velocity(std::size_t k) const;
    Vector3 spin(std::size_t k) const;
    //! Pairs with a force, or within reach of one, and the same with walls, of the last step.
    std::size_t particle_contacts() const { return pairs_.size(); }
    std::size_t wall_contacts() const { return wall_contacts_.size(); }

  private:
    //! What the laws of one contact remember.
    struct History
    {
        double normal[4] = {}, cohesion[4] = {}, added[4] = {}, tangential[4] = {}, rolling[4] = {};
        Vector3 sliding{}, turning{};
    };
    //! Two bodies that meet, with the distances of their centres from the contact point; a wall has none.
    struct Meeting
    {
        contact::ContactKinematics kinematics;
        double arm_i, arm_j;
    };
    //! Force and torques on i, and torque on j.
    struct Action
    {
        Vector3 force, torque_i, torque_j;
    };
    //! Of one body with one wall: a mesh may be touched in several places.
    struct WallContact
    {
        Vector3 offset; //!< from the wall's point to the centre [m]
        History history;
    };
    using Pair = std::pair<std::size_t, std::size_t>;

    contact::LawSet const& laws_of(std::uint32_t a, std::uint32_t b) const { return laws_.at({a, b}); }
    Vector3 from_j_to_i(Body const& i, Body const& j) const;
    Meeting meet(Body const& i, Body const& j) const;
    Meeting meet(Body const& i, dem::Wall const& wall, Vector3 const& offset) const;
    Action act(Meeting const& meeting, contact::LawSet const& laws, History& history) const;
    void find_loads();
    void find_pair_loads(double largest_radius, double furthest);
    void find_wall_loads(double largest_radius);

    dem::SimulationOptions options_;
    std::vector<contact::Material> materials_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, contact::LawSet> laws_;
    std::vector<Body> bodies_;
    std::vector<dem::Wall> walls_;
    std::vector<dem::WallLoad> wall_loads_;
    std::map<Pair, History> pairs_;                  //!< that touched in the last step
    std::multimap<Pair, WallContact> wall_contacts_; //!< of body and wall
    bool first_step_ = true;
};

} // namespace demens::test
