// How often the right cause is found on made-up systems, by the experiments that there are. Writes tables in
// Markdown.
//   gap_study [TWINS] [SYSTEMS] [SIZE]
#include "gap/statistics/baselines.hpp"
#include "gap/statistics/decoys.hpp"
#include "gap/statistics/twins.hpp"
#include "tests/unit/gap/statistics/closure_coverage.hpp"
#include "tests/unit/gap/statistics/made_up_rigs.hpp"

#include <chrono>
#include <fmt/format.h>

namespace demens::gap::testing {
namespace {

struct Study
{
    int twins, systems;
    double size; //!< of effects at their typical amplitude, over the scales of the responses
};

struct Means
{
    double right = 0, group = 0, named = 0, wrong = 0, alarm = 0, named_alarm = 0, outside = 0,
           outside_named = 0;
};

Means study(Study const& study, Rigs const& rigs, double strength)
{
    Means means;
    for (int system = 0; system < study.systems; ++system) {
        auto const made = make_up(rigs, study.size, 0.04, 1 + system);
        Diagnosis const diagnosis(made);
        auto const found =
            rehearse(made.evidence, diagnosis.projection, diagnosis.hypotheses, diagnosis.attributor,
                     {.twins = study.twins, .strengths = {strength}, .outside = {0.1}});
        double const share = 1. / study.systems;
        means.right += share * right_first(found);
        means.group += share * mean(found, &RehearsedRow::in_group);
        means.named += share * mean(found, &RehearsedRow::named);
        means.wrong += share * mean(found, &RehearsedRow::wrongly_named);
        means.alarm += share * (1 - found.rows.front().answers[0]);
        means.named_alarm += share * found.rows.front().named;
        means.outside += share * found.rows.back().flagged;
        means.outside_named += share * found.rows.back().wrongly_named;
    }
    return means;
}

void experiments_table(Study const& options)
{
    fmt::print("| experiments | strength | right first | in its group | named | wrongly named | none: "
               "another answer | "
               "none: something named |\n|---|---|---|---|---|---|---|---|\n");
    struct Row
    {
        char const* name;
        Rigs rigs;
        double strength;
    };
    for (auto const& [name, rigs, strength] :
         {Row{"one drum", {1, 0, false}, 1}, Row{"three speeds", {3, 0, false}, 1},
          Row{"three speeds, two slots, density", {3, 2, true}, 1},
          Row{"three speeds, two slots, density", {3, 2, true}, 0.5},
          Row{"three speeds, two slots, density", {3, 2, true}, 2}}) {
        auto const m = study(options, rigs, strength);
        fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.3f} |\n", name, strength,
                   m.right, m.group, m.named, m.wrong, m.alarm, m.named_alarm);
        std::fflush(stdout);
    }
}

//! Residuals of a system whose laws are off by 1 %, judged with and without a floor for that.
void floor_table(Study const& options)
{
    fmt::print(
        "\n| assumed form floor | none: another answer | something named | BIC without floor: another answer "
        "|\n|---|---|---|---|\n");
    for (double assumed : {0.0, 0.01, 0.04}) {
        double alarms = 0, named = 0, criterion = 0;
        int const cases = options.systems * options.twins;
        for (int system = 0; system < options.systems; ++system) {
            auto const truth = make_up({}, options.size, 0.01, 1 + system),
                       made = make_up({}, options.size, assumed, 1 + system);
            Diagnosis const diagnosis(made);
            Eigen::MatrixXd const floor = make_floor(truth.evidence).total();
            Twins const twins(truth.evidence, floor, 77);
            for (int i = 0; i < options.twins; ++i) {
                auto const r = twins.base(i);
                auto const found = diagnosis.attributor.attribute(r);
                alarms += answer(found) != 0;
                named += !(found.named.empty() && found.named_groups.empty());
                Eigen::Index least = 0;
                information_criteria(made.evidence, made.effects, r).minCoeff(&least);
                criterion += least != 0;
            }
        }
        fmt::print("| {} % | {:.3f} | {:.3f} | {:.3f} |\n", 100 * assumed, alarms / cases, named / cases,
                   criterion / cases);
        std::fflush(stdout);
    }
}

//! A linear effect that is in no list: signatures of another system.
void outside_table(Study const& options)
{
    fmt::print(
        "\n| outside the list, size over the typical effect | flagged unknown | without the gate | something "
        "named |\n|---|---|---|---|\n");
    for (double strength : {0.5, 1.0, 2.0}) {
        double flagged = 0, without = 0, named = 0;
        int cases = 0;
        for (int system = 0; system < options.systems; ++system) {
            auto const made = make_up({}, options.size, 0.04, 1 + system),
                       other = make_up({}, options.size, 0.04, 1001 + system);
            Diagnosis const diagnosis(made);
            Twins const twins(made.evidence, diagnosis.projection.floor(), 78);
            for (int i = 0; i < options.twins; ++i, ++cases) {
                auto const r = twins.with({other.effects[i % other.effects.size()]},
                                          Eigen::VectorXd::Constant(1, strength), i);
                auto const found = diagnosis.attributor.attribute(r);
                auto const unknown = static_cast<int>(made.effects.size()) + 1;
                flagged += answer(found) == unknown;
                double best = found.probability_none;
                for (auto const& effect : found.effects)
                    best = std::max(best, effect.probability);
                without += found.probability_unknown > best;
                named += !(found.named.empty() && found.named_groups.empty());
            }
        }
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} |\n", strength, flagged / cases, without / cases,
                   named / cases);
        std::fflush(stdout);
    }
}

void pairs_table(Study const& options)
{
    double one = 0, both = 0, wrong = 0;
    int cases = 0;
    for (int system = 0; system < options.systems; ++system) {
        auto const made = make_up({}, options.size, 0.04, 1 + system);
        Diagnosis const diagnosis(made);
        Twins const twins(made.evidence, diagnosis.projection.floor(), 79);
        for (int i = 0; i < options.twins; ++i, ++cases) {
            auto const count = static_cast<int>(made.effects.size());
            RandomStream random(derive_seed(80, i));
            int const k = static_cast<int>(random.below(count));
            int const l = static_cast<int>((k + 1 + random.below(count - 1)) % count);
            auto const found = diagnosis.attributor.attribute(
                twins.with({made.effects[k], made.effects[l]}, Eigen::Vector2d(1, 1), i));
            int best = 0, second = -1;
            for (int e = 1; e < count; ++e)
                if (found.effects[e].probability > found.effects[best].probability)
                    best = e;
            for (int e = 0; e < count; ++e)
                if (e != best &&
                    (second < 0 || found.effects[e].probability > found.effects[second].probability))
                    second = e;
            one += best == k || best == l;
            both += (best == k && second == l) || (best == l && second == k);
            wrong +=
                std::any_of(found.named.begin(), found.named.end(), [&](int e) { return e != k && e != l; });
        }
    }
    fmt::print("\nPairs: first is one of the two {:.2f}, first two are both {:.2f}, another named {:.3f}\n",
               one / cases, both / cases, wrong / cases);
}

//! Closure on the fastest of four drums and the widest of three slots, by the linear model: of the effect
//! that acts, and of its decoys.
void closure_table(Study const& options)
{
    fmt::print("\n| strength | at the floor | median closure | p among decoys at most 5 % | best other "
               "closes .2 less |\n"
               "|---|---|---|---|---|\n");
    for (double strength : {0.5, 1.0, 2.0}) {
        int cases = 0, at_floor = 0, beats = 0, ahead = 0, judged = 0;
        std::vector<double> closures;
        for (int system = 0; system < options.systems; ++system) {
            auto const made = make_up({4, 3, true}, options.size, 0.04, 1 + system);
            std::vector<int> in, out;
            for (int i = 0; i < made.evidence.size(); ++i)
                (made.evidence.cells[i].experiment == 3 || made.evidence.cells[i].experiment == 6 ? out : in)
                    .push_back(i);
            auto fitted = subset(made.evidence, in), others = subset(made.evidence, out);
            Projection const projection(fitted, make_floor(fitted).total());
            Twins const twins(made.evidence, make_floor(made.evidence).total(), 81);
            for (int i = 0; i < options.twins; ++i) {
                auto const& effect = made.effects[i % made.effects.size()];
                auto const r = twins.with({effect}, Eigen::VectorXd::Constant(1, strength), i);
                fitted.measured = fitted.predicted + r(in);
                others.measured = others.predicted + r(out);
                auto closure = [&](Signature const& signature) {
                    return linear_closure(fitted, projection, others, subset(signature, in),
                                          subset(signature, out));
                };
                ++cases;
                double const own = closure(effect);
                if (std::isnan(own)) {
                    ++at_floor;
                    continue;
                }
                ++judged;
                closures.push_back(own);
                std::vector<double> decoys;
                for (auto const& other : made.effects)
                    if (other.name != effect.name)
                        decoys.push_back(closure(other));
                double const best = *std::max_element(decoys.begin(), decoys.end());
                auto made_up = effect;
                for (auto const& shape :
                     random_smooth_signatures(made.evidence.cells, effect.first, 0.5, 19, i)) {
                    made_up.first = shape;
                    decoys.push_back(closure(made_up));
                }
                made_up.first = permuted_signature(made.evidence.cells, effect.first, 1);
                decoys.push_back(closure(made_up));
                beats += decoy_p_value(own, decoys) <= 0.05;
                ahead += own >= best + 0.2;
            }
        }
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", strength, 1. * at_floor / cases,
                   closures.empty() ? 0 : quantile(closures, 0.5), 1. * beats / judged, 1. * ahead / judged);
        std::fflush(stdout);
    }
}

void interval_table()
{
    fmt::print(
        "\n| held-out experiments | not at the floor | 90 % interval holds the closure | median width |\n"
        "|---|---|---|---|\n");
    for (int experiments : {1, 2, 3, 6, 12}) {
        int const cases = 500;
        auto const found = closure_coverage(experiments, cases);
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} |\n", experiments, 1. * found.judged / cases,
                   1. * found.held / found.judged, quantile(found.widths, 0.5));
    }
}

//! Seconds a diagnosis takes, linear effects and such with T and q.
void time_table()
{
    fmt::print("\n| cells | effects | pairs | effects are | prepared [s] | one diagnosis [s] "
               "|\n|---|---|---|---|---|---|\n");
    for (bool linear : {true, false})
        for (Rigs const& rigs : {Rigs{3, 2, true}, Rigs{24, 26, true}}) {
            auto made = make_up(rigs, 0.1);
            if (!linear)
                for (std::size_t k = 0; k < made.effects.size(); ++k) {
                    made.effects[k].second = 0.2 * made.effects[(k + 1) % made.effects.size()].first;
                    made.effects[k].interaction = 0.1 * made.evidence.nuisance;
                }
            auto const begin = std::chrono::steady_clock::now();
            Diagnosis const diagnosis(made);
            auto const ready = std::chrono::steady_clock::now();
            Twins const twins(made.evidence, diagnosis.projection.floor(), 1);
            auto const count = static_cast<int>(made.effects.size());
            for (int i = 0; i < count; ++i)
                diagnosis.attributor.attribute(twins.with({made.effects[i]}, Eigen::VectorXd::Ones(1), i));
            std::chrono::duration<double> const prepared = ready - begin,
                                                each = std::chrono::steady_clock::now() - ready;
            fmt::print("| {} | {} | {} | {} | {:.2f} | {:.4f} |\n", made.evidence.size(), count,
                       count * (count - 1) / 2, linear ? "linear" : "curved", prepared.count(),
                       each.count() / count);
        }
}

} // namespace
} // namespace demens::gap::testing

int main(int argc, char** argv)
{
    using namespace demens::gap::testing;
    Study const study{argc > 1 ? std::stoi(argv[1]) : 50, argc > 2 ? std::stoi(argv[2]) : 5,
                      argc > 3 ? std::stod(argv[3]) : 0.1};
    time_table();
    experiments_table(study);
    floor_table(study);
    outside_table(study);
    pairs_table(study);
    closure_table(study);
    interval_table();
    return 0;
}
