#pragma once

#include "demens/base/contract.hpp"
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

//! Brings velocities, which records keep half a step behind the place, to the time of it.
struct CatchUp
{
    double duration; //!< half a step [s]; 0: they are there, before the first step
    Vector3 gravity; //!< [m/s^2]

    Vector3 velocity(Motion const& m, Load const& l) const
    {
        Vector3 const behind{m.vx, m.vy, m.vz};
        return duration > 0 ? behind + duration * (Vector3{l.fx, l.fy, l.fz} / m.mass + gravity) : behind;
    }
    Vector3 spin(Motion const& m, Load const& l) const
    {
        Vector3 const behind{m.wx, m.wy, m.wz};
        return duration > 0 ? behind + duration * (Vector3{l.tx, l.ty, l.tz} / m.inertia) : behind;
    }
};

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
    StateView(Records const& records, Fields read, CatchUp const& catch_up)
        : records_(records), read_(read), catch_up_(catch_up)
    {
    }

    std::size_t size() const { return records_.place.size(); }
    std::span<Place const> places() const { return records_.place; }

    Place const& place(std::size_t k) const
    {
        DEMENS_EXPECT(k < size(), "a particle that there is");
        return records_.place[k];
    }
    Vector3 position(std::size_t k) const { return {place(k).x, place(k).y, place(k).z}; } //!< [m]
    double radius(std::size_t k) const { return place(k).radius; }                         //!< [m]
    double mass(std::size_t k) const { return records_.motion[k].mass; }                   //!< [kg]
    double inertia(std::size_t k) const { return records_.motion[k].inertia; }             //!< [kg m^2]
    MaterialId material(std::size_t k) const { return MaterialId{records_.material[k]}; }
    ParticleId id(std::size_t k) const { return ParticleId{records_.id[k]}; }

    //! At the time of the place [m/s].
    Vector3 velocity(std::size_t k) const
    {
        DEMENS_EXPECT(includes(read_, Fields::motions) && k < size(), "motions were read");
        return catch_up_.velocity(records_.motion[k], records_.load[k]);
    }
    //! At the time of the place [rad/s].
    Vector3 spin(std::size_t k) const
    {
        DEMENS_EXPECT(includes(read_, Fields::motions) && k < size(), "motions were read");
        return catch_up_.spin(records_.motion[k], records_.load[k]);
    }
    //! Of the contacts; gravity is not in it [N].
    Vector3 force(std::size_t k) const
    {
        DEMENS_EXPECT(includes(read_, Fields::loads) && k < size(), "loads were read");
        Load const& l = records_.load[k];
        return {l.fx, l.fy, l.fz};
    }
    //! Of the contacts [N m].
    Vector3 torque(std::size_t k) const
    {
        DEMENS_EXPECT(includes(read_, Fields::loads) && k < size(), "loads were read");
        Load const& l = records_.load[k];
        return {l.tx, l.ty, l.tz};
    }

  private:
    Records records_;
    [[maybe_unused]] Fields read_; // for contracts
    CatchUp catch_up_;
};

} // namespace demens::dem
