#pragma once

#include "demens/contact/kinematics.hpp"
#include "demens/contact/pair_material.hpp"

namespace demens::contact {

//! Where one law keeps what it remembers of a contact.
struct History
{
    double* scalars;  //!< `state_scalars` of them
    Vector3* vectors; //!< `state_vectors` of them, which turn with the contact
};

//! What a law says of itself; each of them hides what is otherwise with it. All laws are called alike,
//!
//!     response = law(contact, load, history);
//!
//! where `load` is what the laws before it have made of the normal force (a normal law is the first and reads
//! nothing there) and the response is a NormalResponse, CohesionResponse or Resistance. They are made from
//! the constants of a pair of materials and are values that can be copied to a device byte by byte.
struct LawTraits
{
    static constexpr int state_scalars = 0;
    static constexpr int state_vectors = 0;
    static constexpr bool history_is_load = false; //!< the vector remembered is the spring's force or torque
    static constexpr bool has_dashpot = false;     //!< the response has a viscous part
    static constexpr bool has_potential = true;    //!< normal law: `stored` is a function of the overlap
    static constexpr bool needs_contact = true;    //!< acts across a gap only after a contact
    static constexpr bool may_push = false;        //!< cohesion law: its force may be repulsive

    //! How far the law acts beyond contact, at this effective radius [m].
    double range(double) const { return 0; }
};

//! No force of that kind.
struct NoLaw : LawTraits
{
    NoLaw(PairMaterial const&, PairProperties const&) {}
};

} // namespace demens::contact
