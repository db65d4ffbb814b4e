#pragma once

#include "demens/dem/body.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "src/dem/rotation.hpp"

#include <memory>
#include <span>
#include <vector>

namespace demens::dem {

//! Where a rigid body is.
struct BodyPose
{
    Vector3 position; //!< of the centre of mass [m]
    Quaternion orientation;
};

//! How it moves: half a time step behind its place, except before the first step.
struct BodyMotion
{
    Vector3 velocity;         //!< [m/s]
    Vector3 angular_momentum; //!< in the axes of space [kg m^2/s]
};

//! What stays.
struct BodyMass
{
    double mass;     //!< [kg]
    Vector3 inertia; //!< principal moments [kg m^2]
    double radius;   //!< of the sphere of the same volume [m]
};

//! Hulls of other processes that come near. Their bodies are numbered on from those that are here.
struct GhostHulls
{
    std::vector<Quaternion> orientation;
    std::vector<double> radius; //!< of the sphere of the same volume [m]
    std::vector<std::uint32_t> shape;

    std::size_t size() const { return shape.size(); }
    void add(Quaternion const& turned, double of_radius, std::uint32_t of_shape)
    {
        orientation.push_back(turned), radius.push_back(of_radius), shape.push_back(of_shape);
    }
};

//! Force and torque about the centre of mass.
struct BodyLoad
{
    Vector3 force, torque; //!< [N], [N m]
};

//! Bodies of several elements, or hulls, whose one element is the sphere that holds it. The elements are
//! particles like others for search, walls and contacts; their places and motions follow from those of their
//! body, and the mass of each is that of the body. A sphere is its own body and is not in here. Bodies keep
//! their order. Where several processes share a simulation, each has the bodies whose centre is in its box,
//! with all of their elements.
struct RigidBodies
{
    std::vector<BodyPose> pose;
    std::vector<BodyMotion> motion;
    std::vector<BodyMass> mass;
    std::vector<BodyLoad> load; //!< of the surroundings; what its elements bear is in their loads
    std::vector<std::uint32_t> elements_end; //!< where its elements end in the columns below
    std::vector<std::uint32_t> hull; //!< its number among the shapes, or `no_hull`; empty without shapes
    static constexpr std::uint32_t no_hull = 0xffffffff;
    //! Each once, of the hulls of all processes.
    std::vector<std::shared_ptr<grain::BodyShape const>> hull_shapes;
    GhostHulls ghosts;

    // Of the elements, body after body
    std::vector<std::uint32_t> element; //!< number of the particle
    std::vector<Vector3> arm;           //!< from the centre, in the body's axes [m]
    std::vector<Vector3> image;         //!< whole periods from where it would be to where it is [m]
    std::vector<Vector3> arm_now;       //!< from the centre, in the axes of space; follows from the rest [m]

    std::size_t size() const { return pose.size(); }
    bool empty() const { return pose.empty(); }
    std::size_t elements_begin(std::size_t body) const { return body > 0 ? elements_end[body - 1] : 0; }
    bool is_hull(std::size_t body) const
    {
        return body >= size() || (!hull.empty() && hull[body] != no_hull);
    }
    // Of hulls, those of other processes too:
    std::uint32_t shape_number(std::size_t body) const
    {
        return body < size() ? hull[body] : ghosts.shape[body - size()];
    }
    grain::BodyShape const& hull_shape(std::size_t body) const { return *hull_shapes[shape_number(body)]; }
    double radius(std::size_t body) const
    {
        return body < size() ? mass[body].radius : ghosts.radius[body - size()];
    }
    Quaternion const& orientation(std::size_t body) const
    {
        return body < size() ? pose[body].orientation : ghosts.orientation[body - size()];
    }
    //! How many ids a body has: its elements', of a hull those of the balls that it is read as.
    std::size_t ids(std::size_t body) const
    {
        return is_hull(body) ? hull_shape(body).balls.size() : elements_end[body] - elements_begin(body);
    }
    std::size_t all_ids() const
    {
        std::size_t count = 0;
        for (std::size_t b = 0; b < size(); ++b)
            count += ids(b);
        return count;
    }
    //! Whether columns have the lengths that they should, for so many particles.
    bool is_whole(std::size_t particles) const;
};

//! A body like this comes, to this process or another: columns and shapes are there for it.
void expect_body(RigidBodies& bodies, Particles& particles, Body const& body);
//! Adds one that was expected and its elements, which get the ids from `first_id` on. \param velocity half a
//! step behind [m/s]
void add_body(RigidBodies& bodies, Particles& particles, Body const& body, Vector3 const& velocity,
              double mass, std::uint32_t first_id);
//! How far the centre of an element is from that of its body, at most [m].
double largest_arm(RigidBodies const& bodies);
//! The particles have other numbers.
void renumber(RigidBodies& bodies, std::span<std::uint32_t const> new_numbers);
//! Brings bodies, and each of their elements, into the periods.
void wrap(RigidBodies& bodies, Particles& particles, Periods const& periods);
//! Finds `arm_now` again.
void find_arms(RigidBodies& bodies);

//! As `move_particles`, for the bodies and their elements: uses the loads up, returns the largest speed of an
//! element [m/s].
double move_rigid(RigidBodies& bodies, Particles& particles, double kick, double time_step,
                  Vector3 const& gravity);
//! What a body bears: the sum over its elements, in their order.
BodyLoad load_of(RigidBodies const& bodies, Particles const& particles, std::size_t body);

} // namespace demens::dem
