#pragma once

#include "demens/contact/cohesion/added_terms.hpp"
#include "demens/contact/cohesion/capillary.hpp"
#include "demens/contact/cohesion/dmt.hpp"
#include "demens/contact/cohesion/jkr.hpp"
#include "demens/contact/cohesion/linear_cohesion.hpp"
#include "demens/contact/cohesion/sjkr2.hpp"
#include "demens/contact/cohesion/van_der_waals.hpp"
#include "demens/contact/normal/hertz.hpp"
#include "demens/contact/normal/hysteretic_spring.hpp"
#include "demens/contact/one_of.hpp"
#include "demens/contact/range.hpp"
#include "demens/contact/rolling/constant_torque.hpp"
#include "demens/contact/rolling/epsd.hpp"
#include "demens/contact/rolling/epsd2.hpp"
#include "demens/contact/rolling/viscous.hpp"
#include "demens/contact/tangential/linear_coulomb.hpp"
#include "demens/contact/tangential/mindlin.hpp"
#include "demens/contact/tangential/mindlin_deresiewicz.hpp"
#include "demens/contact/tangential/mindlin_rescale.hpp"

namespace demens::contact {

// The list of laws. The order is that of the enumerations in law_words.hpp. To add one: its header, its line
// here, its word there, its test. Behind those of the words stand laws with a coefficient that others do not
// have, and that they need nothing of where it is 0.
using AnyNormal = OneOf<HertzNormal, HystereticSpringNormal, HertzNormalWith<true>>;
using AnyTangential = OneOf<
    NoLaw, MindlinTangential, MindlinRescaleTangential, MindlinDeresiewiczTangential, LinearCoulombTangential,
    MindlinTangentialWith<WeakeningFriction>, MindlinRescaleTangentialWith<WeakeningFriction>,
    MindlinDeresiewiczTangentialWith<WeakeningFriction>, LinearCoulombTangentialWith<WeakeningFriction>>;
using AnyRolling = OneOf<NoLaw, ConstantTorqueRolling, ViscousRolling, EpsdRolling, Epsd2Rolling>;
using AnyCohesion = OneOf<NoLaw, LinearCohesion, Sjkr2Cohesion, VanDerWaalsCohesion, DmtCohesion, JkrCohesion,
                          CapillaryCohesion>;
//! Terms that add to any cohesion law; none where all their amplitudes are 0.
using AnyAdded = OneOf<NoLaw, AddedCohesion>;

//! Which laws a pair has, by their places in the lists.
struct LawPlaces
{
    explicit LawPlaces(PairProperties const& pair);

    std::size_t normal, tangential, rolling, cohesion, added;

    friend bool operator==(LawPlaces const&, LawPlaces const&) = default;
};

//! The laws of one pair of materials, ready to be evaluated on the host or, copied byte by byte, on a device.
struct LawSet
{
    LawSet(Material const& i, Material const& j, PairProperties const& pair);
    LawSet(PairMaterial const& material, PairProperties const& pair);
    LawSet(LawPlaces const& at, PairMaterial const& material, PairProperties const& pair);

    AnyNormal normal;
    AnyTangential tangential;
    AnyRolling rolling;
    AnyCohesion cohesion;
    AnyAdded added;
    bool cohesion_in_limit; //!< attraction lowers the limit of friction and rolling

    //! Share of the attraction in the limit of friction and rolling.
    DEMENS_FUNCTION double share_in_limit() const { return cohesion_in_limit ? 1.0 : 0.0; }
};

//! How far beyond contact the laws act, for effective radii up to `largest_radius` [m].
Range range_of(LawSet const& laws, double largest_radius);

} // namespace demens::contact
