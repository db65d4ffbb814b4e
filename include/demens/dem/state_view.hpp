#pragma once

#include "demens/dem/ids.hpp"
#include "demens/dem/particles.hpp"

#include <span>

namespace demens::dem {

//! What is read of the particles; may be combined with |.
enum class Fields : unsigned
{
    places = 1,  //!< where they are, and what stays: radius, mass, material, id
    motions = 2, //!< velocities and spins
    loads = 4,   //!< forces and torques of contacts
    all = 7
};
constexpr Fields operator|(Fields a, Fields b)
{
    return static_cast<Fields>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool includes(Fields all, Fields some)
{
    return (static_cast<unsigned>(all) & static_cast<unsigned>(some)) == static_cast<unsigned>(some);
}

//! The particles as they were when they were read, in the order of the engine. Valid until the simulation
//! changes or is read again.
class StateView
{
  public:
    //! Records of all particles; those of fields that were not read may be empty.
    struct Records
    {
        std::span<Place const> place;
        std::span<Motion const> motion;
        std::span<Load const> load;
        std::span<std::uint32_t const> material, id;
    };
    //! What brings the velocities of the records to the time of the places.
    struct Kick
    {
        double duration; //!< [s]; 0: they are there
        Vector3 gravity; //!< [m/s^2]
    };

    StateView(Records const& records, Kick const& kick) : records_(records), kick_(kick) {}

    std::size_t size() const { return records_.place.size(); }
    std::span<Place const> places() const { return records_.place; }

    Place const& place(std::size_t k) const { return records_.place[k]; }
    Vector3 position(std::size_t k) const { return {place(k).x, place(k).y, place(k).z}; } //!< [m]
    double radius(std::size_t k) const { return place(k).radius; }                         //!< [m]
    double mass(std::size_t k) const { return records_.motion[k].mass; }                   //!< [kg]
    double inertia(std::size_t k) const { return records_.motion[k].inertia; }             //!< [kg m^2]
    MaterialId material(std::size_t k) const { return MaterialId{records_.material[k]}; }
    ParticleId id(std::size_t k) const { return ParticleId{records_.id[k]}; }

    //! At the time of the place [m/s].
    Vector3 velocity(std::size_t k) const
    {
        Motion const& m = records_.motion[k];
        Vector3 const behind{m.vx, m.vy, m.vz};
        return kick_.duration > 0 ? behind + kick_.duration * (force(k) / m.mass + kick_.gravity) : behind;
    }
    //! At the time of the place [rad/s].
    Vector3 spin(std::size_t k) const
    {
        Motion const& m = records_.motion[k];
        Vector3 const behind{m.wx, m.wy, m.wz};
        return kick_.duration > 0 ? behind + kick_.duration * (torque(k) / m.inertia) : behind;
    }
    //! Of the contacts; gravity is not in it [N].
    Vector3 force(std::size_t k) const
    {
        Load const& l = records_.load[k];
        return {l.fx, l.fy, l.fz};
    }
    //! Of the contacts [N m].
    Vector3 torque(std::size_t k) const
    {
        Load const& l = records_.load[k];
        return {l.tx, l.ty, l.tz};
    }

  private:
    Records records_;
    Kick kick_;
};

} // namespace demens::dem
