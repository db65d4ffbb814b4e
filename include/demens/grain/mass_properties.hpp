#pragma once

#include "demens/base/quaternion.hpp"

namespace demens::grain {

//! A symmetric 3 x 3 matrix.
struct SymmetricTensor
{
    double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    SymmetricTensor& operator+=(SymmetricTensor const& b);
    friend bool operator==(SymmetricTensor const&, SymmetricTensor const&) = default;
};

SymmetricTensor operator+(SymmetricTensor a, SymmetricTensor const& b);
SymmetricTensor operator*(double s, SymmetricTensor const& a);
Vector3 operator*(SymmetricTensor const& a, Vector3 const& v);
//! Root of the sum of the squares of all nine components.
double frobenius(SymmetricTensor const& a);
//! All products of a vector's components.
SymmetricTensor products(Vector3 const& v);
//! The sum of a b^T and b a^T, halved.
SymmetricTensor products(Vector3 const& a, Vector3 const& b);

//! Integrals over a solid of 1, of the place and of the products of its components.
struct VolumeMoments
{
    double volume = 0;      //!< [m^3]
    Vector3 first;          //!< [m^4]
    SymmetricTensor second; //!< [m^5]

    VolumeMoments& operator+=(VolumeMoments const& b);
    //! Of the same solid, shifted.
    VolumeMoments shifted(Vector3 const& shift) const;
};

//! What a rigid body needs to move, for a density of 1 kg/m^3.
struct MassProperties
{
    double volume = 0;       //!< [m^3]
    Vector3 centre;          //!< of mass [m]
    SymmetricTensor inertia; //!< about the centre, along the axes that the solid is given in [m^5]
    Vector3 moments;         //!< principal moments, from the smallest to the largest [m^5]
    Quaternion axes;         //!< turns the principal axes into the axes that the solid is given in

    //! Of the solid grown by a factor about the origin.
    MassProperties scaled(double factor) const;
    //! Diameter of the sphere of the same volume [m].
    double equivalent_diameter() const;
};

//! From integrals that belong to a solid: a volume above 0, the moments of a body.
//!
//! Conventions, so that the same solid has the same bits: moments ascend, and those within 1e-9 of the
//! largest are one, their mean. Axes are right-handed. All moments equal: no turn. Two of them equal: of the
//! axes at a right angle to the third that of `any_normal_to`. Of each of the first two axes the first
//! component of more than half the largest one's size is positive.
MassProperties mass_properties_of(VolumeMoments const& moments);

} // namespace demens::grain
