#pragma once

#include "demens/base/words.hpp"

namespace demens::ensemble {

//! How the points of the first wave are chosen.
enum class DesignKind
{
    latin_hypercube,
    sobol,
    full_factorial,
    fractional_factorial,
    central_composite,
    box_behnken,
    d_optimal,
    table
};

//! What is minimised.
enum class ObjectiveKind
{
    wmse,
    weighted_least_squares,
    root_sum_of_squares,
    relative_deviations
};

//! Monotone function in which a response is fitted.
enum class TransformKind
{
    none,
    log,
    logit,
    asinh
};

//! How the points of the next waves are chosen.
enum class SearchKind
{
    surrogate_minima,
    rbf_distance,
    response_surface,
    expected_improvement,
    pounders_direct
};

//! What finds the minimum of the surrogates.
enum class SolverKind
{
    pounders,
    quasi_newton,
    bobyqa,
    praxis,
    simplex,
    genetic
};

} // namespace demens::ensemble

namespace demens {

template <>
std::vector<Word<ensemble::DesignKind>> const& words_of();
template <>
std::vector<Word<ensemble::ObjectiveKind>> const& words_of();
template <>
std::vector<Word<ensemble::TransformKind>> const& words_of();
template <>
std::vector<Word<ensemble::SearchKind>> const& words_of();
template <>
std::vector<Word<ensemble::SolverKind>> const& words_of();

} // namespace demens
