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
    : LawSet(LawPlaces(pair), material, pair)
{
}

LawSet::LawSet(LawPlaces const& at, PairMaterial const& material, PairProperties const& pair)
    : normal(at.normal, material, pair), tangential(at.tangential, material, pair),
      rolling(at.rolling, material, pair), cohesion(at.cohesion, material, pair),
      added(at.added, material, pair), cohesion_in_limit(pair.cohesion_in_limit)
{
}

LawPlaces::LawPlaces(PairProperties const& pair)
    : normal(number(pair.normal)), tangential(number(pair.tangential)), rolling(number(pair.rolling)),
      cohesion(number(pair.cohesion)), added(AddedCohesion::is_any(pair) ? 1 : 0)
{
    if (pair.viscoelastic_time > 0 && pair.normal == NormalLaw::hertz)
        normal = normal_laws.size();
    if (pair.friction_weakening > 0 && pair.tangential != TangentialLaw::none)
        tangential += tangential_laws.size() - 1; // there is none of that kind behind the others
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
