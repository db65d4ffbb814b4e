#include "gap/rehearsal/draw.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "tao_calib/unit_cube.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <random>

namespace demens::gap {
namespace {

constexpr std::array<double, 4> shares = {12. / 48, 20. / 48, 6. / 48, 10. / 48}; // of kinds, as declared
constexpr std::array<double, 3> strengths = {0.5, 1, 2};
constexpr double margin = 0.1; //!< of a factor's range on either side that no truth lies in

void add_effect(CaseTruth& truth, CandidateEffect const& candidate, RandomStream& random)
{
    auto const& effect = candidate.effect;
    double const strength = strengths[random.below(strengths.size())];
    bool const negative = effect.sign == ensemble::EffectSign::negative ||
                          (effect.sign == ensemble::EffectSign::either && random.uniform() < 0.5);
    truth.effects.push_back(effect.name);
    truth.strengths.push_back(negative ? -strength : strength);
    truth.amplitudes.push_back(truth.strengths.back() * effect.typical);
}

using KindCounts = std::array<int, shares.size()>;

//! So many of so many cases are of each kind: their shares, what is left over to the largest remainders.
KindCounts counts_of(int cases)
{
    KindCounts counts{};
    std::array<double, shares.size()> left{};
    for (std::size_t k = 0; k < shares.size(); ++k) {
        counts[k] = static_cast<int>(shares[k] * cases);
        left[k] = shares[k] * cases - counts[k];
    }
    for (int more = cases - std::accumulate(counts.begin(), counts.end(), 0); more > 0; --more) {
        auto const most = static_cast<std::size_t>(std::max_element(left.begin(), left.end()) - left.begin());
        ++counts[most];
        left[most] -= 1;
    }
    return counts;
}

//! What a kind becomes where the rigs have too few effects for it.
CaseKind possible(CaseKind kind, RehearsedEffects const& effects)
{
    if (kind == CaseKind::pair && effects.listed.size() < 2)
        return CaseKind::single;
    if (kind == CaseKind::outside && effects.outside.empty())
        return CaseKind::none;
    return kind;
}

//! Of the effects beside the list those that are to be drawn, as strong as they are to be.
std::vector<CandidateEffect> chosen(std::vector<CandidateEffect> const& beside,
                                    std::vector<OutsideEffect> const& wanted)
{
    std::vector<CandidateEffect> effects;
    for (auto const& one : wanted) {
        auto const found = std::find_if(beside.begin(), beside.end(), [&](auto const& candidate) {
            return candidate.effect.name == one.name;
        });
        if (found == beside.end())
            throw InputError(fmt::format("`{}` cannot be drawn from outside the list: it is no effect that "
                                         "these rigs simulate, or `[gap] effects` lists it",
                                         one.name));
        if (one.typical && !(*one.typical > 0 && std::isfinite(*one.typical)))
            throw InputError(
                fmt::format("`{}={}`: a typical amplitude is above 0 and finite; the effect has its sign",
                            one.name, *one.typical));
        effects.push_back(*found);
        effects.back().effect.typical = one.typical.value_or(found->effect.typical);
    }
    return effects;
}

} // namespace

RehearsedEffects rehearsed_effects(ensemble::CampaignInput const& input,
                                   std::vector<OutsideEffect> const& outside)
{
    RehearsedEffects effects;
    auto const simulated = [](std::vector<CandidateEffect> candidates) {
        std::erase_if(candidates, [](auto const& candidate) { return candidate.measured != nullptr; });
        return candidates;
    };
    effects.listed = simulated(candidates_of(input));
    if (effects.listed.empty())
        throw InputError(
            "none of the effects that this campaign lists is simulated; there is nothing to rehearse");
    auto whole = input;
    if (!whole.gap)
        whole.gap.emplace();
    whole.gap->effects.clear();
    effects.outside = simulated(candidates_of(whole));
    std::erase_if(effects.outside, [&](auto const& candidate) {
        return std::any_of(effects.listed.begin(), effects.listed.end(),
                           [&](auto const& other) { return other.effect.name == candidate.effect.name; });
    });
    if (!outside.empty())
        effects.outside = chosen(effects.outside, outside);
    return effects;
}

CaseKind draw_kind(RehearsedEffects const& effects, std::vector<CaseKind> const& drawn, int cases,
                   std::uint64_t seed)
{
    KindCounts left{};
    auto const wanted = counts_of(cases);
    for (std::size_t k = 0; k < shares.size(); ++k)
        left[static_cast<std::size_t>(possible(static_cast<CaseKind>(k), effects))] += wanted[k];
    for (auto const kind : drawn)
        --left[static_cast<std::size_t>(kind)];
    for (int& count : left)
        count = std::max(0, count);
    auto const all = std::accumulate(left.begin(), left.end(), 0);
    if (all == 0)
        return CaseKind::none; // more were drawn than there are cases
    auto place = static_cast<int>(RandomStream(seed).below(static_cast<std::uint64_t>(all)));
    std::size_t kind = 0;
    while (place >= left[kind])
        place -= left[kind++];
    return static_cast<CaseKind>(kind);
}

CaseTruth draw_case(ensemble::CampaignInput const& input, RehearsedEffects const& effects, CaseKind kind,
                    std::string name, std::uint64_t seed)
{
    RandomStream random(seed);
    CaseTruth truth;
    truth.name = std::move(name);
    truth.kind = kind;
    switch (truth.kind) {
    case CaseKind::none:
        break;
    case CaseKind::single:
        add_effect(truth, effects.listed[random.below(effects.listed.size())], random);
        break;
    case CaseKind::pair: {
        auto const first = random.below(effects.listed.size());
        auto second = random.below(effects.listed.size() - 1);
        second += second >= first;
        add_effect(truth, effects.listed[std::min(first, second)], random);
        add_effect(truth, effects.listed[std::max(first, second)], random);
        break;
    }
    case CaseKind::outside:
        add_effect(truth, effects.outside[random.below(effects.outside.size())], random);
        break;
    }
    tao_calib::UnitCube const cube(input.factors, input.constraints);
    Eigen::VectorXd place(cube.size());
    for (double& x : place)
        x = margin + (1 - 2 * margin) * random.uniform();
    truth.factors = cube.to_design_point(cube.project(place));
    return truth;
}

std::uint64_t entropy()
{
    std::random_device device;
    return (std::uint64_t{device()} << 32) | device();
}

std::string new_salt()
{
    return fmt::format("{:016x}{:016x}", entropy(), entropy());
}

} // namespace demens::gap
