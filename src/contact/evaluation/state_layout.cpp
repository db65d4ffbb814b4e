#include "demens/contact/evaluation/stored_energy.hpp"

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
    return stored_energy_in(laws, layout, state);
}

} // namespace demens::contact
