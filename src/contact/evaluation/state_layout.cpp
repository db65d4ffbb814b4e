#include "demens/contact/evaluation/state_layout.hpp"

namespace demens::contact {
namespace {

template <template <class, bool> class Stage, class... Laws>
StateSize size_of(OneOf<Laws...> const& law, bool ledger)
{
    return law.visit([&]<class Law>(Law const&) { return state_size<Stage, Law>(ledger); });
}

} // namespace

StateLayout state_layout(LawSet const& laws, bool ledger)
{
    return state_layout(
        size_of<NormalStage>(laws.normal, ledger), size_of<CohesionStage>(laws.cohesion, ledger),
        size_of<CohesionStage>(laws.added, ledger), size_of<TangentialStage>(laws.tangential, ledger),
        size_of<RollingStage>(laws.rolling, ledger), ledger);
}

StoredEnergy stored_energy(LawSet const& laws, StateLayout const& layout, double const* state)
{
    auto const after = [&](int at, auto const& any) {
        return any.visit([&]<class Law>(Law const&) {
            return std::is_same_v<Law, NoLaw> ? 0.0 : state[at + Law::state_scalars];
        });
    };
    return {.normal = after(layout.normal + 1, laws.normal),
            .tangential = after(layout.tangential, laws.tangential),
            .rolling = after(layout.rolling, laws.rolling),
            .cohesive = after(layout.cohesion, laws.cohesion) + after(layout.added, laws.added)};
}

} // namespace demens::contact
