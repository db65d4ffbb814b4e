#pragma once

#include "demens/contact/cohesion/capillary.hpp"
#include "demens/contact/cohesion/dmt.hpp"
#include "demens/contact/cohesion/jkr.hpp"
#include "demens/contact/cohesion/linear_cohesion.hpp"
#include "demens/contact/cohesion/sjkr2.hpp"
#include "demens/contact/cohesion/van_der_waals.hpp"
#include "demens/contact/normal/hertz.hpp"
#include "demens/contact/normal/hysteretic_spring.hpp"
#include "demens/contact/range.hpp"
#include "demens/contact/rolling/constant_torque.hpp"
#include "demens/contact/rolling/epsd.hpp"
#include "demens/contact/rolling/epsd2.hpp"
#include "demens/contact/rolling/viscous.hpp"
#include "demens/contact/tangential/linear_coulomb.hpp"
#include "demens/contact/tangential/mindlin.hpp"
#include "demens/contact/tangential/mindlin_deresiewicz.hpp"
#include "demens/contact/tangential/mindlin_rescale.hpp"

#include <variant>

namespace demens::contact {

//! No force of that kind.
struct NoLaw
{
};

// The list of laws. The order is that of the enumerations in model.hpp. To add one: its header, its line
// here, its name in model.cpp, its test.
using AnyNormal = std::variant<HertzNormal, HystereticSpringNormal>;
using AnyTangential = std::variant<NoLaw, MindlinTangential, MindlinRescaleTangential,
                                   MindlinDeresiewiczTangential, LinearCoulombTangential>;
using AnyRolling = std::variant<NoLaw, ConstantTorqueRolling, ViscousRolling, EpsdRolling, Epsd2Rolling>;
using AnyCohesion = std::variant<NoLaw, LinearCohesion, Sjkr2Cohesion, VanDerWaalsCohesion, DmtCohesion,
                                 JkrCohesion, CapillaryCohesion>;

//! The laws of one pair of materials, ready to be evaluated.
struct LawSet
{
    LawSet(Material const& i, Material const& j, PairProperties const& pair);

    AnyNormal normal;
    AnyTangential tangential;
    AnyRolling rolling;
    AnyCohesion cohesion;
    bool cohesion_in_limit; //!< attraction lowers the limit of friction and rolling
};

//! How far beyond contact the laws act, for effective radii up to `largest_radius` [m].
Range range_of(LawSet const& laws, double largest_radius);

} // namespace demens::contact
