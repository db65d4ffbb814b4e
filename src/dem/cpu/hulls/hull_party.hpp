#pragma once

#include "demens/grain/contact/core.hpp"
#include "src/dem/cpu/state.hpp"

#include <vector>

namespace demens::dem {

//! One side of a contact of hulls: a hull, or a ball, whose core is a point.
struct HullParty
{
    grain::CoreView core;
    grain::CorePose pose;
    double rounding; //!< [m]
    double ball;     //!< radius of the ball that stands for it in laws: that of the sphere of its volume [m]
};

//! What hulls are in a step, each found once.
class HullParties
{
  public:
    //! Finds those of this process anew, and how far each has moved since the last time.
    void update(State const& state);
    //! The same of the ghosts, after it.
    void update_ghosts(State const& state);

    HullParty const& hull(Particles const& particles, std::uint32_t particle) const
    {
        return hulls_[particles.body[particle]];
    }
    //! A hull, or a ball: that one till the next is asked for.
    HullParty const& any(Particles const& particles, std::uint32_t particle)
    {
        if (particles.is_hull(particle))
            return hull(particles, particle);
        Place const& p = particles.place[particle];
        ball_.pose.place = {p.x, p.y, p.z};
        ball_.rounding = ball_.ball = p.radius;
        return ball_;
    }
    //! Length of the way that no point of a particle's hull has exceeded since the loop began; it only grows.
    //! Without limit for balls [m].
    double travelled(std::uint32_t particle) const { return travelled_[particle]; }

  private:
    void update(State const& state, std::size_t body, std::uint32_t particle);

    //! What hulls of a shape have in common.
    struct Shape
    {
        grain::CoreView core;
        double rounding, reach;
    };
    std::vector<Shape> shapes_;
    grain::Hull point_ = grain::point_hull();
    HullParty ball_{grain::CoreView(point_), {}, 0, 0};
    std::vector<HullParty> hulls_;       //!< by body
    std::vector<double> body_travelled_; //!< by body [m]
    std::vector<double> travelled_;      //!< by particle [m]
};

} // namespace demens::dem
