#include "demens/contact/laws.hpp"

#include "demens/base/contract.hpp"

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
      cohesion_in_limit(pair.cohesion_in_limit)
{
}

Range range_of(LawSet const& laws, double largest_radius)
{
    DEMENS_EXPECT(largest_radius >= 0, "a radius");
    return laws.cohesion.visit([&]<class Law>(Law const& law) -> Range {
        return {law.range(largest_radius), Law::needs_contact};
    });
}

} // namespace demens::contact
