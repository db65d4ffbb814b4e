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

//! What stands in for each response between the runs.
enum class SurrogateChoice
{
    quadratic, //!< polynomials up to it
    rbf,
    gaussian_process,
    automatic //!< the one that predicts best what is left out
};

//! Which products of the factors a polynomial holds.
enum class PolynomialModel
{
    linear,      //!< constant and main effects
    interaction, //!< and products of two factors
    quadratic    //!< and squares
};

//! Whether equal steps or equal ratios of a factor count the same.
enum class FactorScale
{
    linear,
    log
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
inline std::vector<Word<ensemble::DesignKind>> const& words_of()
{
    using enum ensemble::DesignKind;
    static std::vector<Word<ensemble::DesignKind>> const words = {
        {latin_hypercube, "latin_hypercube"},
        {sobol, "sobol"},
        {full_factorial, "full_factorial"},
        {fractional_factorial, "fractional_factorial"},
        {central_composite, "central_composite"},
        {box_behnken, "box_behnken"},
        {d_optimal, "d_optimal"},
        {table, "table"}};
    return words;
}

template <>
inline std::vector<Word<ensemble::ObjectiveKind>> const& words_of()
{
    using enum ensemble::ObjectiveKind;
    static std::vector<Word<ensemble::ObjectiveKind>> const words = {
        {wmse, "wmse"},
        {weighted_least_squares, "weighted_least_squares"},
        {root_sum_of_squares, "root_sum_of_squares"},
        {relative_deviations, "relative_deviations"}};
    return words;
}

template <>
inline std::vector<Word<ensemble::TransformKind>> const& words_of()
{
    using enum ensemble::TransformKind;
    static std::vector<Word<ensemble::TransformKind>> const words = {
        {none, "none"}, {log, "log"}, {logit, "logit"}, {asinh, "asinh"}};
    return words;
}

template <>
inline std::vector<Word<ensemble::SurrogateChoice>> const& words_of()
{
    using enum ensemble::SurrogateChoice;
    static std::vector<Word<ensemble::SurrogateChoice>> const words = {
        {quadratic, "quadratic"}, {rbf, "rbf"}, {gaussian_process, "gaussian_process"}, {automatic, "auto"}};
    return words;
}

template <>
inline std::vector<Word<ensemble::PolynomialModel>> const& words_of()
{
    using enum ensemble::PolynomialModel;
    static std::vector<Word<ensemble::PolynomialModel>> const words = {
        {linear, "linear"}, {interaction, "interaction"}, {quadratic, "quadratic"}};
    return words;
}

template <>
inline std::vector<Word<ensemble::FactorScale>> const& words_of()
{
    using enum ensemble::FactorScale;
    static std::vector<Word<ensemble::FactorScale>> const words = {{linear, "linear"}, {log, "log"}};
    return words;
}

template <>
inline std::vector<Word<ensemble::SearchKind>> const& words_of()
{
    using enum ensemble::SearchKind;
    static std::vector<Word<ensemble::SearchKind>> const words = {
        {surrogate_minima, "surrogate_minima"},
        {rbf_distance, "rbf_distance"},
        {response_surface, "response_surface"},
        {expected_improvement, "expected_improvement"},
        {pounders_direct, "pounders_direct"}};
    return words;
}

template <>
inline std::vector<Word<ensemble::SolverKind>> const& words_of()
{
    using enum ensemble::SolverKind;
    static std::vector<Word<ensemble::SolverKind>> const words = {
        {pounders, "pounders"}, {quasi_newton, "quasi_newton"}, {bobyqa, "bobyqa"},
        {praxis, "praxis"},     {simplex, "simplex"},           {genetic, "genetic"}};
    return words;
}

} // namespace demens
