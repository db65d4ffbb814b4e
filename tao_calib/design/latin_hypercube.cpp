#include "tao_calib/design/latin_hypercube.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

// Both designs minimise the criterion of Morris and Mitchell (1995, J. Stat. Plan. Inference 43:381),
// phi = sum over pairs of distance^-p, which for large p orders designs by their smallest distance and then
// by how many pairs are that close, with simulated annealing.

namespace demens::tao_calib {
namespace {

constexpr int restarts = 10;
constexpr double pair_evaluations = 4e6; //!< work of one design, shared by the restarts
constexpr double first_temperature = 0.5, last_temperature = 1e-4;

//! One pair's part of phi with p = 20.
double pair_repulsion(double squared_distance)
{
    double const inverse = 1 / std::max(squared_distance, 1e-12);
    double const fifth = inverse * inverse * inverse * inverse * inverse;
    return fifth * fifth;
}

double cooling(int steps)
{
    return std::pow(last_temperature / first_temperature, 1.0 / steps);
}

int steps_per_restart(int points)
{
    return static_cast<int>(std::clamp(pair_evaluations / (2.0 * points * restarts), 500.0, 20000.0));
}

bool accepts(double relative_change, double temperature, RandomStream& random)
{
    return relative_change <= 0 || random.uniform() < std::exp(-relative_change / temperature);
}

Eigen::MatrixXi random_latin_hypercube(int points, int factors, RandomStream& random)
{
    Eigen::MatrixXi places(points, factors);
    for (int k = 0; k < factors; ++k) {
        for (int i = 0; i < points; ++i)
            places(i, k) = i;
        for (int i = points - 1; i > 0; --i)
            std::swap(places(i, k), places(static_cast<int>(random.below(i + 1)), k));
    }
    return places;
}

//! Repulsion of row `row` from all rows but itself and `other`.
double repulsion(Eigen::MatrixXi const& places, int row, int other)
{
    double sum = 0;
    for (int i = 0; i < places.rows(); ++i)
        if (i != row && i != other)
            sum += pair_repulsion((places.row(i) - places.row(row)).squaredNorm());
    return sum;
}

double repulsion(Eigen::MatrixXi const& places)
{
    double sum = 0;
    for (int i = 0; i < places.rows(); ++i)
        sum += 0.5 * repulsion(places, i, i);
    return sum;
}

} // namespace

int smallest_squared_distance(Eigen::MatrixXi const& places)
{
    int smallest = std::numeric_limits<int>::max();
    for (int i = 0; i < places.rows(); ++i)
        for (int j = 0; j < i; ++j)
            smallest = std::min(smallest, (places.row(i) - places.row(j)).squaredNorm());
    return smallest;
}

Eigen::MatrixXi maximin_latin_hypercube(int points, int factors, std::uint64_t seed)
{
    RandomStream random(seed);
    Eigen::MatrixXi best = random_latin_hypercube(points, factors, random);
    bool const is_too_large = 0.5 * points * points > pair_evaluations; // to be looked at even once
    if (points < 3 || factors < 2 || is_too_large)
        return best;

    double best_phi = repulsion(best);
    int const steps = steps_per_restart(points);
    double const cool = cooling(steps);
    for (int restart = 0; restart < restarts; ++restart) {
        auto places = random_latin_hypercube(points, factors, random);
        double phi = repulsion(places);
        double temperature = first_temperature;
        for (int step = 0; step < steps; ++step, temperature *= cool) {
            int const k = static_cast<int>(random.below(factors));
            int const i = static_cast<int>(random.below(points));
            int const j = static_cast<int>((i + 1 + random.below(points - 1)) % points);
            // Swapping two rows' places in one column leaves the distance between these two rows as it is.
            double const before = repulsion(places, i, j) + repulsion(places, j, i);
            std::swap(places(i, k), places(j, k));
            double const change = repulsion(places, i, j) + repulsion(places, j, i) - before;
            if (!accepts(change / phi, temperature, random)) {
                std::swap(places(i, k), places(j, k));
                continue;
            }
            phi += change;
            if (phi < best_phi * (1 - 1e-9)) {
                phi = repulsion(places); // without the rounding of many small changes
                if (phi < best_phi) {
                    best_phi = phi;
                    best = places;
                }
            }
        }
    }
    return best;
}

namespace {

//! A choice of candidates: strata that stand empty, and repulsion of the points.
class Selection
{
  public:
    Selection(Eigen::MatrixXd const& candidates, Eigen::MatrixXi const& strata, std::vector<int> chosen)
        : candidates_(candidates), strata_(strata), chosen_(std::move(chosen)),
          counts_(Eigen::MatrixXi::Zero(static_cast<Eigen::Index>(chosen_.size()), strata.cols()))
    {
        for (int candidate : chosen_)
            count(candidate, 1);
    }

    std::vector<int> const& chosen() const { return chosen_; }
    int empty_strata() const { return static_cast<int>((counts_.array() == 0).count()); }

    double repulsion_of(int place) const
    {
        double sum = 0;
        for (int other = 0; other < static_cast<int>(chosen_.size()); ++other)
            if (other != place)
                sum += pair_repulsion(
                    (candidates_.row(chosen_[other]) - candidates_.row(chosen_[place])).squaredNorm());
        return sum;
    }

    //! Puts another candidate in a place and returns the one that was there.
    int replace(int place, int candidate)
    {
        count(chosen_[place], -1);
        count(candidate, 1);
        return std::exchange(chosen_[place], candidate);
    }

  private:
    void count(int candidate, int sign)
    {
        for (Eigen::Index k = 0; k < strata_.cols(); ++k)
            counts_(strata_(candidate, k), k) += sign;
    }

    Eigen::MatrixXd const& candidates_;
    Eigen::MatrixXi const& strata_;
    std::vector<int> chosen_;
    Eigen::MatrixXi counts_; //!< points in each stratum of each factor
};

//! Numbers of equally filled strata, per column.
Eigen::MatrixXi strata_of(Eigen::MatrixXd const& candidates, int count)
{
    auto const rows = candidates.rows();
    Eigen::MatrixXi strata(rows, candidates.cols());
    std::vector<Eigen::Index> order(rows);
    for (Eigen::Index k = 0; k < candidates.cols(); ++k) {
        std::iota(order.begin(), order.end(), Eigen::Index{0});
        std::stable_sort(order.begin(), order.end(),
                         [&](auto a, auto b) { return candidates(a, k) < candidates(b, k); });
        for (Eigen::Index place = 0; place < rows; ++place)
            strata(order[place], k) = static_cast<int>(place * count / rows);
    }
    return strata;
}

} // namespace

// In a cut region no exact Latin hypercube need exist (kinetic <= static over equal bounds leaves only the
// diagonal). So the strata of a factor are made equally likely over the region itself, and points are picked
// from many random feasible ones such that few strata stay empty and the points keep apart.
ConstrainedLatinHypercube constrained_latin_hypercube(FactorSpace const& space, int points,
                                                      std::uint64_t seed)
{
    RandomStream random(seed);
    int const candidate_count = std::max(2000, 50 * points);
    Eigen::MatrixXd candidates(candidate_count, space.size());
    for (int i = 0; i < candidate_count; ++i)
        candidates.row(i) = space.sample(random).transpose();
    auto const strata = strata_of(candidates, points);

    std::vector<int> first(points);
    std::iota(first.begin(), first.end(), 0);
    Selection selection(candidates, strata, first);
    std::vector<int> best = selection.chosen();
    double best_cost = std::numeric_limits<double>::infinity();

    int const steps = steps_per_restart(points) * restarts;
    double const cool = cooling(steps);
    double temperature = first_temperature;
    auto phi = [&] {
        double sum = 0;
        for (int place = 0; place < points; ++place)
            sum += 0.5 * selection.repulsion_of(place);
        return sum;
    };
    // One empty stratum counts as much as halving the smallest distance would.
    auto cost = [&](double repulsion) {
        return std::log(repulsion) + selection.empty_strata() * 10 * std::log(4.0);
    };
    double repulsion = points > 1 ? phi() : 1;
    double current = cost(repulsion);
    for (int step = 0; step < steps && points > 1; ++step, temperature *= cool) {
        int const place = static_cast<int>(random.below(points));
        double const before = selection.repulsion_of(place);
        int const old = selection.replace(place, static_cast<int>(random.below(candidate_count)));
        double const changed = std::max(repulsion + selection.repulsion_of(place) - before, 1e-300);
        double const next = cost(changed);
        if (!accepts(next - current, temperature, random)) {
            selection.replace(place, old);
            continue;
        }
        repulsion = changed;
        current = next;
        if (current < best_cost) {
            repulsion = phi();
            current = cost(repulsion);
            best_cost = current;
            best = selection.chosen();
        }
    }

    ConstrainedLatinHypercube result{Eigen::MatrixXd(points, space.size()), 0};
    for (int i = 0; i < points; ++i)
        result.unit.row(i) = candidates.row(best[i]);
    result.empty_strata = Selection(candidates, strata, best).empty_strata();
    return result;
}

} // namespace demens::tao_calib
