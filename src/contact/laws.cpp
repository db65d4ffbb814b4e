#include "demens/contact/laws.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <type_traits>

namespace demens::contact {
namespace {

//! Place of a law in the list of its kind.
template <class Law>
std::size_t number(Law law)
{
    return static_cast<std::size_t>(law);
}

} // namespace

LawSet::LawSet(Material const& i, Material const& j, PairProperties const& pair)
    : LawSet(PairMaterial(i, j, pair), pair)
{
}

LawSet::LawSet(PairMaterial const& material, PairProperties const& pair)
    : normal(number(pair.normal), material, pair), tangential(number(pair.tangential), material, pair),
      rolling(number(pair.rolling), material, pair), cohesion(number(pair.cohesion), material, pair),
      added(AddedCohesion::is_any(pair) ? 1 : 0, material, pair), cohesion_in_limit(pair.cohesion_in_limit)
{
}

Range range_of(LawSet const& laws, double largest_radius)
{
    DEMENS_EXPECT(largest_radius >= 0, "a radius");
    Range const named = laws.cohesion.visit([&]<class Law>(Law const& law) -> Range {
        return {law.range(largest_radius), Law::needs_contact};
    });
    return laws.added.visit([&]<class Law>(Law const& law) -> Range {
        if constexpr (std::is_same_v<Law, NoLaw>) {
            return named;
        } else {
            Range const added = law.reach(largest_radius);
            return {std::max(named.gap, added.gap),
                    (named.needs_contact || !(named.gap > 0)) && added.needs_contact};
        }
    });
}

} // namespace demens::contact
