#pragma once

#include "demens/dem/wall.hpp"

#include <limits>
#include <variant>
#include <vector>

namespace demens::dem {

// Laws of motion, from the start of the motion at time 0. An oscillation begins where the wall stands: with a
// phase it is the displacement since the start, A (sin(2 pi f t + phase) - sin(phase)).

//! Straight at a steady velocity.
struct Translate
{
    Vector3 velocity; //!< [m/s]
};
//! About a fixed line at a steady rate.
struct Rotate
{
    Vector3 point; //!< on the line [m]
    Vector3 axis;  //!< along the line, of any length
    double rate;   //!< [rad/s], counter-clockwise seen against the axis
};
//! To and fro along a line.
struct Shake
{
    Vector3 amplitude; //!< [m]
    double frequency;  //!< [Hz]
    double phase = 0;  //!< [rad]
};
//! To and fro about a fixed line.
struct Swing
{
    Vector3 point;    //!< on the line [m]
    Vector3 axis;     //!< along the line, of any length
    double amplitude; //!< [rad]
    double frequency; //!< [Hz]
    double phase = 0; //!< [rad]
};
//! The surface runs, the wall stays: a conveyor belt.
struct Convey
{
    Vector3 velocity; //!< [m/s]
};

// The numbers of each law, to be written and read, as those of shapes.

void fields(Translate& m, auto&& of)
{
    of.direction(m.velocity);
}
void fields(Rotate& m, auto&& of)
{
    of.point(m.point), of.direction(m.axis), of.number(m.rate);
}
void fields(Shake& m, auto&& of)
{
    of.direction(m.amplitude), of.number(m.frequency), of.number(m.phase);
}
void fields(Swing& m, auto&& of)
{
    of.point(m.point), of.direction(m.axis), of.number(m.amplitude), of.number(m.frequency);
    of.number(m.phase);
}
void fields(Convey& m, auto&& of)
{
    of.direction(m.velocity);
}

//! One motion of a wall and when it lasts; after its end the wall stays where it has brought it.
struct WallMotion
{
    std::variant<Translate, Rotate, Shake, Swing, Convey> law;
    double start = 0;                                     //!< [s]
    double end = std::numeric_limits<double>::infinity(); //!< [s]
};

//! Moves a wall from where it stands at first. Each motion moves it as the ones before it in the list have
//! placed it, along directions and about lines that are fixed in space; they may follow or overlap each other
//! in time. The place is a function of time alone, without drift.
class MovedWall
{
  public:
    //! What it consists of, to be stored.
    struct Parts
    {
        WallShape shape; //!< where the wall stood at first
        Vector3 pivot;
        std::vector<WallMotion> motions;
        std::size_t spinning =
            0; //!< so many of the first motions map the shape onto itself: they do not move it
    };
    explicit MovedWall(Parts parts) : parts_(std::move(parts)) {}
    //! Motions that should have started before `now` [s] start then. \throws InputError for an axis of no
    //! length, a negative frequency or an end before the start.
    MovedWall(Wall const& at_first, std::vector<WallMotion> motions, double now = 0);

    //! Puts the wall where it is at `time` [s], with its velocity, spin and belt at `velocity_time` [s].
    void move(Wall& wall, double time, double velocity_time) const;

    Parts const& parts() const { return parts_; }

  private:
    Parts parts_;
};

} // namespace demens::dem
