#pragma once

#include "demens/contact/evaluation/evaluate_contact.hpp"
#include "src/dem/cuda/law_kernel.hpp"

#include <algorithm>

namespace demens::dem::cuda {

//! A law of which the compiler knows which it is.
template <std::size_t k, class Any>
struct KnownLaw
{
    Any const& any;

    DEMENS_RUNS_WHERE_ITS_ARGUMENT_DOES
    template <class Visitor>
    DEMENS_FUNCTION decltype(auto) visit(Visitor&& visitor) const
    {
        return visitor(any.template get<k>());
    }
};

//! A set of laws that are known when a kernel is compiled; it reads like a LawSet.
template <contact::NormalLaw normal_law, contact::TangentialLaw tangential_law,
          contact::RollingLaw rolling_law, contact::CohesionLaw cohesion_law>
struct KnownLaws
{
    static constexpr auto n = static_cast<std::size_t>(normal_law);
    static constexpr auto t = static_cast<std::size_t>(tangential_law);
    static constexpr auto r = static_cast<std::size_t>(rolling_law);
    static constexpr auto c = static_cast<std::size_t>(cohesion_law);

    KnownLaw<n, contact::AnyNormal> normal;
    KnownLaw<t, contact::AnyTangential> tangential;
    KnownLaw<r, contact::AnyRolling> rolling;
    KnownLaw<c, contact::AnyCohesion> cohesion;
    KnownLaw<0, contact::AnyAdded> added;
    double share;

    DEMENS_FUNCTION explicit KnownLaws(contact::LawSet const& laws)
        : normal{laws.normal},
          tangential{laws.tangential}, rolling{laws.rolling}, cohesion{laws.cohesion}, added{laws.added},
          share(laws.share_in_limit())
    {
    }
    DEMENS_FUNCTION double share_in_limit() const { return share; }

    static bool are(contact::LawSet const& laws)
    {
        return laws.normal.index() == n && laws.tangential.index() == t && laws.rolling.index() == r &&
               laws.cohesion.index() == c && laws.added.index() == 0;
    }

    static constexpr contact::StateLayout layout = contact::state_layout(
        contact::state_size<contact::NormalStage, contact::AnyNormal::Law<n>>(false),
        contact::state_size<contact::CohesionStage, contact::AnyCohesion::Law<c>>(false),
        contact::StateSize{},
        contact::state_size<contact::TangentialStage, contact::AnyTangential::Law<t>>(false),
        contact::state_size<contact::RollingStage, contact::AnyRolling::Law<r>>(false), false);
};

//! Copies a history of so many doubles, two in one access: those of pairs begin where such pairs do, those of
//! walls anywhere.
template <contact::Partner partner, int size>
DEMENS_INLINE DEMENS_FUNCTION void copy_history(double const* from, double* to)
{
    struct alignas(partner == contact::Partner::sphere ? 16 : 8) Two
    {
        double a, b;
    };
    static_assert(size % 2 == 0);
    for (int k = 0; k < size / 2; ++k)
        reinterpret_cast<Two*>(to)[k] = reinterpret_cast<Two const*>(from)[k];
}

//! A contact whose laws are known: its history is in registers meanwhile.
template <class Laws>
struct EvaluateKnown
{
    template <contact::Partner partner>
    DEMENS_INLINE DEMENS_FUNCTION static contact::ContactOutcome
    evaluate(contact::Meeting const& meeting, contact::LawSet const& set, contact::StateLayout const&,
             double time_step, double* history, bool is_new)
    {
        constexpr contact::StateLayout layout = Laws::layout;
        constexpr int size = layout.size > 0 ? layout.size : 1;
        alignas(16) double own[size];
        if (is_new)
            for (int k = 0; k < layout.size; ++k)
                own[k] = 0;
        else
            copy_history<partner, layout.size>(history, own);
        Laws const laws(set);
        auto const outcome =
            contact::evaluate_contact<partner>(meeting, laws, layout, time_step, contact::HistoryRecord{own});
        copy_history<partner, layout.size>(own, history);
        return outcome;
    }
};

//! A contact of any laws.
struct EvaluateAny
{
    template <contact::Partner partner>
    DEMENS_FUNCTION static contact::ContactOutcome
    evaluate(contact::Meeting const& meeting, contact::LawSet const& laws, contact::StateLayout const& layout,
             double time_step, double* history, bool is_new)
    {
        if (is_new)
            for (int k = 0; k < layout.size; ++k)
                history[k] = 0;
        return contact::evaluate_contact<partner>(meeting, laws, layout, time_step,
                                                  contact::HistoryRecord{history});
    }
};

using HertzMindlin = KnownLaws<contact::NormalLaw::hertz, contact::TangentialLaw::mindlin,
                               contact::RollingLaw::none, contact::CohesionLaw::none>;
using HertzMindlinEpsd2 = KnownLaws<contact::NormalLaw::hertz, contact::TangentialLaw::mindlin,
                                    contact::RollingLaw::epsd2, contact::CohesionLaw::none>;
using HertzMindlinConstantTorque =
    KnownLaws<contact::NormalLaw::hertz, contact::TangentialLaw::mindlin,
              contact::RollingLaw::constant_torque, contact::CohesionLaw::none>;
using HertzRescale = KnownLaws<contact::NormalLaw::hertz, contact::TangentialLaw::mindlin_rescale,
                               contact::RollingLaw::none, contact::CohesionLaw::none>;
using HertzRescaleEpsd2 = KnownLaws<contact::NormalLaw::hertz, contact::TangentialLaw::mindlin_rescale,
                                    contact::RollingLaw::epsd2, contact::CohesionLaw::none>;

//! The kernel of these laws.
template <class LawSets>
LawKernel kernel_of(LawSets const& sets, bool with_ledger)
{
    auto const all_are = [&](auto const& test) { return std::all_of(sets.begin(), sets.end(), test); };
    return with_ledger                                ? LawKernel::any_with_ledger
           : all_are(HertzMindlin::are)               ? LawKernel::hertz_mindlin
           : all_are(HertzMindlinEpsd2::are)          ? LawKernel::hertz_mindlin_epsd2
           : all_are(HertzMindlinConstantTorque::are) ? LawKernel::hertz_mindlin_constant_torque
           : all_are(HertzRescale::are)               ? LawKernel::hertz_rescale
           : all_are(HertzRescaleEpsd2::are)          ? LawKernel::hertz_rescale_epsd2
                                                      : LawKernel::any;
}

//! Calls `visitor` with what evaluates contacts.
template <class Visitor>
void with_evaluation(LawKernel kernel, Visitor&& visitor)
{
    switch (kernel) {
    case LawKernel::any:
    case LawKernel::any_with_ledger:
    case LawKernel::count:
        return visitor(EvaluateAny{});
    case LawKernel::hertz_mindlin:
        return visitor(EvaluateKnown<HertzMindlin>{});
    case LawKernel::hertz_mindlin_epsd2:
        return visitor(EvaluateKnown<HertzMindlinEpsd2>{});
    case LawKernel::hertz_mindlin_constant_torque:
        return visitor(EvaluateKnown<HertzMindlinConstantTorque>{});
    case LawKernel::hertz_rescale:
        return visitor(EvaluateKnown<HertzRescale>{});
    case LawKernel::hertz_rescale_epsd2:
        return visitor(EvaluateKnown<HertzRescaleEpsd2>{});
    }
}

} // namespace demens::dem::cuda
