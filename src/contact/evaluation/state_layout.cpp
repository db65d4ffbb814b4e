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
    StateSize const normal = size_of<NormalStage>(laws.normal, ledger);
    StateSize const cohesion = size_of<CohesionStage>(laws.cohesion, ledger);
    StateSize const tangential = size_of<TangentialStage>(laws.tangential, ledger);
    StateSize const rolling = size_of<RollingStage>(laws.rolling, ledger);
    StateLayout layout{.ledger = ledger};
    int next = 0;
    auto const place = [&](int& at, int size) {
        at = next;
        next += size;
    };
    place(layout.normal, normal.scalars);
    place(layout.cohesion, cohesion.scalars);
    place(layout.tangential, tangential.scalars);
    place(layout.rolling, rolling.scalars);
    layout.scalars = next;
    place(layout.tangential_vector, 3 * tangential.vectors);
    place(layout.rolling_vector, 3 * rolling.vectors);
    layout.size = whole_fours(next);
    return layout;
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
            .cohesive = after(layout.cohesion, laws.cohesion)};
}

} // namespace demens::contact
