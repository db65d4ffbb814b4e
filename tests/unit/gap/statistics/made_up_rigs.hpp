#pragma once

#include "gap/statistics/rehearse.hpp"
#include "tests/unit/gap/statistics/small_evidence.hpp"

#include <cmath>

//! Drums at some speeds, draw-down slots and bulk density, with effects made up by a seed: what the diagnosis
//! is worth on a linear normal system of about the size of real ones.
namespace demens::gap::testing {

struct Rigs
{
    int drums = 3; //!< speeds, evenly spread over the condition 0 to 1
    int slots = 2; //!< widths, likewise
    bool density = true;
};

struct MadeUp
{
    Evidence evidence;
    std::vector<Signature> effects;
};

//! Each response depends on an effect by a constant and a slope over the condition. Effects of one group
//! (cohesion, friction, ...) share most of the constant, so that one condition hardly tells them apart.
class ResponseLaw
{
  public:
    static constexpr int families = 9; //!< 5 of drums, 3 of slots, density

    ResponseLaw(std::uint64_t seed, std::uint64_t group_seed)
    {
        RandomStream own(seed), shared(group_seed);
        constant_ = 0.85 * standard_normals(families, shared) + 0.53 * standard_normals(families, own);
        slope_ = standard_normals(families, own);
    }
    //! Over the scale of the response.
    double at(int family, double condition) const
    {
        return constant_[family] + slope_[family] * (condition - 0.5);
    }

  private:
    Eigen::VectorXd constant_, slope_;
};

//! \param size root mean square of an effect over the scales of the responses, at its typical amplitude
inline MadeUp make_up(Rigs const& rigs, double size, double form_floor = 0.04, std::uint64_t seed = 1)
{
    MadeUp made;
    auto& evidence = made.evidence;
    int experiment = 0;
    auto add = [&](int first_family, int families, int count) {
        for (int i = 0; i < count; ++i, ++experiment)
            for (int f = first_family; f < first_family + families; ++f)
                evidence.cells.push_back({"cell " + std::to_string(experiment) + "." + std::to_string(f),
                                          experiment,
                                          f,
                                          {count > 1 ? i / (count - 1.) : 0.5},
                                          10. + f});
    };
    add(0, 5, rigs.drums);
    add(5, 3, rigs.slots);
    add(8, 1, rigs.density ? 1 : 0);
    auto const n = evidence.size();
    Eigen::VectorXd const scale = scales(evidence.cells);
    evidence.predicted = evidence.measured = scale;
    evidence.experiment_variance = (0.01 * scale).cwiseAbs2();
    evidence.surrogate_variance = (0.005 * scale).cwiseAbs2();
    evidence.form_floor = form_floor;
    auto column = [&](std::uint64_t own, std::uint64_t group) {
        ResponseLaw const law(derive_seed(seed, own), derive_seed(seed, group));
        Eigen::VectorXd s(n);
        for (int i = 0; i < n; ++i)
            s[i] = law.at(evidence.cells[i].response_family, evidence.cells[i].condition[0]) * scale[i];
        return s;
    };
    constexpr int factors = 3; // as static friction, rolling friction, surface energy
    evidence.nuisance.resize(n, factors);
    for (int k = 0; k < factors; ++k)
        evidence.nuisance.col(k) = column(100 + k, 200 + k);
    evidence.nuisance_prior = 0.1 * Eigen::MatrixXd::Identity(factors, factors);
    // protocol, grains, walls, cohesion, friction, surroundings, measurement
    int const members[] = {3, 2, 3, 4, 3, 1, 1};
    for (std::uint64_t group = 0, effect = 0; group < std::size(members); ++group)
        for (int i = 0; i < members[group]; ++i, ++effect) {
            Signature signature;
            signature.name = "effect " + std::to_string(group) + "." + std::to_string(i);
            signature.first = size / std::sqrt(1 + 1 / 6.) * column(300 + effect, 400 + group);
            signature.sign = effect % 2 == 0 ? Sign::positive : Sign::either;
            made.effects.push_back(std::move(signature));
        }
    return made;
}

//! All that a diagnosis needs, at one place; not to be moved.
struct Diagnosis
{
    Diagnosis(MadeUp const& made, HypothesisOptions const& hypothesis_options = {},
              AttributeOptions const& options = {})
        : projection(made.evidence, make_floor(made.evidence).total()),
          locator(made.evidence, projection, groups_by_experiment(made.evidence.cells)),
          hypotheses(made.evidence, projection, made.effects, hypothesis_options),
          attributor(made.evidence, projection, locator, hypotheses, options)
    {
    }
    Diagnosis(Diagnosis const&) = delete;
    Diagnosis& operator=(Diagnosis const&) = delete;

    Projection projection;
    Locator locator;
    Hypotheses hypotheses;
    Attributor attributor;
};

//! Mean over the effects' rows.
inline double mean(Rehearsal const& rehearsal, double RehearsedRow::*share)
{
    double sum = 0;
    int rows = 0;
    for (auto const& row : rehearsal.rows)
        if (row.effect >= 0) {
            sum += row.*share;
            ++rows;
        }
    return sum / rows;
}

//! Share of the effects' twins in which the right effect came first.
inline double right_first(Rehearsal const& rehearsal)
{
    double sum = 0;
    int rows = 0;
    for (auto const& row : rehearsal.rows)
        if (row.effect >= 0) {
            sum += row.answers[1 + row.effect];
            ++rows;
        }
    return sum / rows;
}

} // namespace demens::gap::testing
