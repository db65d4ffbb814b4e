// What a rehearsal draws.
#include "gap/rehearsal/draw.hpp"

#include <gtest/gtest.h>
#include <map>

namespace {

using namespace demens;
using gap::CaseKind;

gap::RehearsedEffects effects(int listed, int outside)
{
    gap::RehearsedEffects all;
    all.listed.resize(static_cast<std::size_t>(listed));
    all.outside.resize(static_cast<std::size_t>(outside));
    return all;
}

std::map<CaseKind, int> kinds_of(gap::RehearsedEffects const& all, int cases, std::uint64_t seed)
{
    std::vector<CaseKind> drawn;
    std::map<CaseKind, int> count;
    for (int k = 0; k < cases; ++k) {
        drawn.push_back(gap::draw_kind(all, drawn, cases, seed + static_cast<std::uint64_t>(k)));
        ++count[drawn.back()];
    }
    return count;
}

TEST(Draw, OfAllCasesEachKindHasItsShare)
{
    std::map<CaseKind, int> const shares = {
        {CaseKind::none, 12}, {CaseKind::single, 20}, {CaseKind::pair, 6}, {CaseKind::outside, 10}};
    for (std::uint64_t seed : {1, 100, 2000})
        EXPECT_EQ(kinds_of(effects(5, 3), 48, seed), shares) << seed;
    auto drawn = kinds_of(effects(5, 3), 12, 7);
    EXPECT_EQ(drawn[CaseKind::none], 3);
    EXPECT_EQ(drawn[CaseKind::single], 5);
    EXPECT_EQ(drawn[CaseKind::pair] + drawn[CaseKind::outside], 4);
}

TEST(Draw, TheOrderOfKindsIsDrawn)
{
    auto const all = effects(5, 3);
    std::map<CaseKind, int> firsts;
    for (std::uint64_t seed = 0; seed < 4800; ++seed)
        ++firsts[gap::draw_kind(all, {}, 48, seed)];
    // 4800 draws: standard deviations of 30, 34, 23 and 28
    EXPECT_NEAR(firsts[CaseKind::none], 1200, 120);
    EXPECT_NEAR(firsts[CaseKind::single], 2000, 136);
    EXPECT_NEAR(firsts[CaseKind::pair], 600, 92);
    EXPECT_NEAR(firsts[CaseKind::outside], 1000, 112);
}

TEST(Draw, WhatTheRigsHaveNoEffectForBecomesAnotherKind)
{
    std::map<CaseKind, int> const one_effect = {{CaseKind::none, 22}, {CaseKind::single, 26}};
    EXPECT_EQ(kinds_of(effects(1, 0), 48, 3), one_effect);
}

TEST(Draw, MoreDrawnThanThereAreCasesIsNoError)
{
    std::vector<CaseKind> const drawn(12, CaseKind::single);
    EXPECT_EQ(gap::draw_kind(effects(5, 3), drawn, 1, 1), CaseKind::none);
}

} // namespace
