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

//! Where the triangles and the tree of a mesh begin among those of all meshes.
struct MeshPlace
{
    std::uint32_t facet = 0, node = 0;

    friend bool operator==(MeshPlace const&, MeshPlace const&) = default;
};

//! A mesh where it is now.
struct PlacedMesh
{
    Placement placement; //!< of the mesh's own coordinates
    MeshPlace at;
};

//! A wall as the device reads it.
struct FlatWall
{
    enum class Kind : std::uint32_t
    {
        absent, //!< inactive: touches nothing
        mesh,
        rectangle,
        round
    };
    Kind kind;
    std::uint32_t material;
    contact::WallSurface surface;
    union Shape {
        Rectangle rectangle; //!< of this kind
        Round round;         //!< of this kind
        PlacedMesh mesh;     //!< of this kind

        Shape() : rectangle{} {}
    } shape;

    //! Whether it is felt at its nearest point, and only there.
    DEMENS_FUNCTION bool has_one_place() const { return kind >= Kind::rectangle; }
    //! Of such a wall: from the nearest point to p; where p lies on the shape, a short way along its normal
    //! [m].
    DEMENS_FUNCTION Vector3 offset(Vector3 const& p, double radius) const
    {
        return kind == Kind::rectangle ? offset_from(shape.rectangle, p, radius)
                                       : offset_from(shape.round, p, radius);
    }
};

//! \param mesh where its mesh is, if it is one
FlatWall flattened(Wall const& wall, MeshPlace const& mesh);

} // namespace demens::dem::cuda
