#include "tao_calib/solver/genetic.hpp"

#include "demens/base/random.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

struct Member
{
    VectorXd point;
    double value;
};

std::uint64_t seed_of(VectorXd const& start)
{
    std::uint64_t seed = 0;
    for (double x : start)
        seed = derive_seed(seed, std::bit_cast<std::uint64_t>(x));
    return seed;
}

Member const& winner(std::vector<Member> const& population, RandomStream& random)
{
    auto const& a = population[random.below(population.size())];
    auto const& b = population[random.below(population.size())];
    return a.value < b.value ? a : b;
}

//! Between the parents and half as far beyond either.
VectorXd child_of(Member const& a, Member const& b, double mutation, RandomStream& random)
{
    VectorXd child(a.point.size());
    for (Eigen::Index k = 0; k < child.size(); ++k) {
        double const share = 2 * random.uniform() - 0.5;
        child[k] = a.point[k] + share * (b.point[k] - a.point[k]);
        if (random.uniform() < 0.2)
            child[k] += mutation * 2 * (random.uniform() + random.uniform() + random.uniform() - 1.5);
    }
    return child.cwiseMax(0).cwiseMin(1);
}

} // namespace

LeastSquaresResult Genetic::minimise(LeastSquaresProblem const& problem, VectorXd const& start,
                                     LeastSquaresSettings const& settings) const
{
    int const size = std::max(20, 10 * problem.factors);
    int const generations = std::max(2, 4 * settings.evaluations / size);
    RandomStream random(seed_of(start));
    LeastSquaresResult result;
    auto member = [&](VectorXd const& point) {
        double const value = problem.evaluate(point).squaredNorm();
        ++result.evaluations;
        return Member{point, std::isfinite(value) ? value : std::numeric_limits<double>::infinity()};
    };
    std::vector<Member> population{member(start.cwiseMax(0).cwiseMin(1))};
    while (static_cast<int>(population.size()) < size) {
        VectorXd point(problem.factors);
        for (double& x : point)
            x = random.uniform();
        population.push_back(member(point));
    }
    auto const better = [](Member const& a, Member const& b) { return a.value < b.value; };
    for (int generation = 0; generation < generations; ++generation) {
        std::stable_sort(population.begin(), population.end(), better);
        std::vector<Member> next(population.begin(), population.begin() + 2);
        double const mutation = 0.2 * std::pow(1e-4, static_cast<double>(generation) / generations);
        while (static_cast<int>(next.size()) < size) {
            auto const &a = winner(population, random), &b = winner(population, random);
            next.push_back(member(child_of(a, b, mutation, random)));
        }
        population = std::move(next);
    }
    auto const best = std::min_element(population.begin(), population.end(), better);
    result.point = best->point;
    result.sum_of_squares = best->value;
    result.converged = true;
    result.ending = "all generations have lived";
    return result;
}

} // namespace demens::tao_calib
