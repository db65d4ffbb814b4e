#pragma once

#include "demens/contact/evaluation/geometry.hpp"
#include "demens/contact/evaluation/loads.hpp"
#include "demens/contact/evaluation/state_layout.hpp"

namespace demens::contact {

//! What a contact has lost since the step before [J].
struct Losses
{
    double damping = 0, friction = 0, rolling = 0, cohesion = 0;
};

//! What the laws of a contact make of its kinematics.
struct ContactAction
{
    Vector3 force = {};  //!< on i, at the contact point [N]
    Vector3 torque = {}; //!< rolling torque on i [N m]
    Losses lost = {};    //!< with the ledger
};

//! What one contact does in one step.
struct ContactOutcome
{
    ContactGeometry geometry;
    BodyLoads<double> loads;
    Losses lost;
};

//! A contact whose laws are being evaluated, one kind after another: each visitor adds what its kind gives.
//! They have names, since lambdas of one header need not have the same names for two compilers whose objects
//! are linked together.
template <bool ledger, class Laws, class State>
struct ContactProgress
{
    Laws const& laws;
    StateLayout const& at;
    ContactKinematics const& contact;
    State const& state;
    NormalResponse load = {}; //!< limit and stiffness, as the laws after the normal one read them
    ContactAction action = {};

    struct Normal
    {
        ContactProgress& p;

        template <class Law>
        DEMENS_FUNCTION void operator()(Law const& law) const
        {
            auto const result = NormalStage<Law, ledger>{law, p.at.normal}(p.contact, p.state);
            // Not with designated initialisers: nvcc's host code would take them for the first members.
            p.load.limit = result.response.limit;
            p.load.stiffness = result.response.stiffness;
            p.action.force = result.response.force * p.contact.normal;
            p.action.lost.damping = result.lost;
        }
    };

    struct Cohesion
    {
        ContactProgress& p;
        int scalars_at;

        DEMENS_FUNCTION void operator()(NoLaw const&) const {}
        template <class Law>
        DEMENS_FUNCTION void operator()(Law const& law) const
        {
            CohesionStage<Law, ledger> const stage{law, scalars_at, p.laws.share_in_limit()};
            auto const result = stage(p.contact, p.load, p.state);
            p.load.limit = result.limit;
            p.action.force += result.force * p.contact.normal;
            p.action.lost.cohesion += result.lost;
        }
    };

    struct Tangential
    {
        ContactProgress& p;

        DEMENS_FUNCTION void operator()(NoLaw const&) const {}
        template <class Law>
        DEMENS_FUNCTION void operator()(Law const& law) const
        {
            TangentialStage<Law, ledger> const stage{law, p.at.tangential, p.at.tangential_vector};
            auto const result = stage(p.contact, p.load, p.state);
            p.action.force += result.force;
            p.action.lost.damping += result.lost_in_dashpot;
            p.action.lost.friction = result.lost_in_slip;
        }
    };

    struct Rolling
    {
        ContactProgress& p;

        DEMENS_FUNCTION void operator()(NoLaw const&) const {}
        template <class Law>
        DEMENS_FUNCTION void operator()(Law const& law) const
        {
            RollingStage<Law, ledger> const stage{law, p.at.rolling, p.at.rolling_vector};
            auto const result = stage(p.contact, p.load, p.state);
            p.action.torque = result.torque;
            p.action.lost.rolling = result.lost;
        }
    };
};

//! Normal force, cohesion, friction and rolling resistance one after another, with the new history. `Laws` is
//! a LawSet or what reads like one.
template <bool ledger, class Laws, class State>
DEMENS_FUNCTION ContactAction act(Laws const& laws, StateLayout const& at, ContactKinematics const& contact,
                                  State const& state)
{
    using Progress = ContactProgress<ledger, Laws, State>;
    Progress progress{laws, at, contact, state};
    laws.normal.visit(typename Progress::Normal{progress});
    laws.cohesion.visit(typename Progress::Cohesion{progress, at.cohesion});
    laws.added.visit(typename Progress::Cohesion{progress, at.added});
    laws.tangential.visit(typename Progress::Tangential{progress});
    laws.rolling.visit(typename Progress::Rolling{progress});
    return progress.action;
}

//! A vector as components.
DEMENS_INLINE DEMENS_FUNCTION Components<double> components_of(Vector3 const& v)
{
    return {v.x, v.y, v.z};
}

//! One contact from the records of its bodies to what acts on them: geometry, laws, loads, new history.
template <Partner partner, class Laws, class State>
DEMENS_FUNCTION ContactOutcome evaluate_contact(Meeting const& meeting, Laws const& laws,
                                                StateLayout const& layout, double time_step,
                                                State const& state)
{
    ContactGeometry const geometry = geometry_of<partner>(meeting);
    ContactKinematics const kinematics = kinematics_of(meeting, geometry, time_step);
    ContactAction const action = layout.ledger ? act<true>(laws, layout, kinematics, state)
                                               : act<false>(laws, layout, kinematics, state);
    return {geometry,
            body_loads(components_of(geometry.normal), geometry.arm_i, geometry.arm_j,
                       components_of(action.force), components_of(action.torque)),
            action.lost};
}

} // namespace demens::contact
