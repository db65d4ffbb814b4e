#pragma once

#include "demens/contact/normal/hertz.hpp"
#include "demens/contact/normal/hysteretic_spring.hpp"
#include "demens/contact/rolling/constant_torque.hpp"
#include "demens/contact/rolling/epsd.hpp"
#include "demens/contact/rolling/epsd2.hpp"
#include "demens/contact/tangential/linear_coulomb.hpp"
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
using AnyTangential = std::variant<NoLaw, MindlinRescaleTangential, LinearCoulombTangential>;
using AnyRolling = std::variant<NoLaw, ConstantTorqueRolling, EpsdRolling, Epsd2Rolling>;

//! The laws of one pair of materials, ready to be evaluated.
struct LawSet
{
    LawSet(Material const& i, Material const& j, PairProperties const& pair);

    AnyNormal normal;
    AnyTangential tangential;
    AnyRolling rolling;
};

} // namespace demens::contact
