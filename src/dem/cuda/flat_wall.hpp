#pragma once

#include "demens/dem/wall.hpp"
#include "src/dem/wall_offset.hpp"

namespace demens::dem::cuda {

//! A round shape by its meridian: disc, cylinder or cone.
struct Round
{
    Vector3 centre, axis;
    Meridian line;
    RoundSide side;
};
DEMENS_FUNCTION constexpr Meridian meridian(Round const& round)
{
    return round.line;
}

//! Whether devices know walls of this shape.
template <class Shape>
constexpr bool is_known_shape = std::is_same_v<Shape, Rectangle> || RoundShape<Shape>;

//! A wall as the device reads it, of a shape that devices know.
struct FlatWall
{
    enum class Kind : std::uint32_t
    {
        absent, //!< inactive: touches nothing
        rectangle,
        round
    };
    Kind kind;
    std::uint32_t material;
    contact::WallSurface surface;
    Rectangle rectangle; //!< of this kind
    Round round;         //!< of this kind

    //! From the nearest point to p; where p lies on the shape, a short way along its normal [m].
    DEMENS_FUNCTION Vector3 offset(Vector3 const& p, double radius) const
    {
        return kind == Kind::rectangle ? offset_from(rectangle, p, radius) : offset_from(round, p, radius);
    }
};

//! \throws InputError for a shape that devices do not know.
FlatWall flattened(Wall const& wall);

} // namespace demens::dem::cuda
