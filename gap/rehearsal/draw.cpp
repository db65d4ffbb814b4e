#include "gap/rehearsal/draw.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "tao_calib/unit_cube.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <random>

namespace demens::gap {
namespace {

constexpr double share_none = 0.25, share_single = 0.42, share_pair = 0.125;
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

CaseKind draw_kind(RehearsedEffects const& effects, RandomStream& random)
{
    double const u = random.uniform();
    if (u < share_none)
        return CaseKind::none;
    if (u < share_none + share_single)
        return CaseKind::single;
    if (u < share_none + share_single + share_pair)
        return effects.listed.size() > 1 ? CaseKind::pair : CaseKind::single;
    return effects.outside.empty() ? CaseKind::none : CaseKind::outside;
}

} // namespace

RehearsedEffects rehearsed_effects(ensemble::CampaignInput const& input)
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
    return effects;
}

CaseTruth draw_case(ensemble::CampaignInput const& input, RehearsedEffects const& effects, std::string name,
                    std::uint64_t seed)
{
    RandomStream random(seed);
    CaseTruth truth;
    truth.name = std::move(name);
    truth.kind = draw_kind(effects, random);
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
