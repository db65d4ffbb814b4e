#include "demens/contact/laws.hpp"

namespace demens::contact {
namespace {

//! The alternative number `index` of a variant, made from the pair's constants.
template <class Any, std::size_t k = 0>
Any make_law(std::size_t index, PairMaterial const& material, PairProperties const& pair)
{
    if constexpr (k + 1 < std::variant_size_v<Any>)
        if (index != k)
            return make_law<Any, k + 1>(index, material, pair);
    using Law = std::variant_alternative_t<k, Any>;
    if constexpr (std::is_same_v<Law, NoLaw>)
        return NoLaw{};
    else
        return Law(material, pair);
}

} // namespace

LawSet::LawSet(Material const& i, Material const& j, PairProperties const& pair)
    : normal(make_law<AnyNormal>(static_cast<std::size_t>(pair.normal), {i, j, pair}, pair)),
      tangential(make_law<AnyTangential>(static_cast<std::size_t>(pair.tangential), {i, j, pair}, pair)),
      rolling(make_law<AnyRolling>(static_cast<std::size_t>(pair.rolling), {i, j, pair}, pair)),
      cohesion(make_law<AnyCohesion>(static_cast<std::size_t>(pair.cohesion), {i, j, pair}, pair)),
      cohesion_in_limit(pair.cohesion_in_limit)
{
}

Range range_of(LawSet const& laws, double largest_radius)
{
    return std::visit(
        [&]<class Law>(Law const& law) -> Range {
            if constexpr (requires { law.range(largest_radius); })
                return {law.range(largest_radius), Law::needs_contact};
            else
                return {};
        },
        laws.cohesion);
}

} // namespace demens::contact
