#include "tao_calib/wave/response_surface_search.hpp"

#include "tao_calib/wave/progress.hpp"

#include <algorithm>
#include <cmath>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

constexpr double widest_move = 0.35,
                 narrowest_move = 0.01; // move limits, half widths in shares of the ranges

std::vector<std::unique_ptr<Surrogate>> local_quadratics(Assessment const& assessment, VectorXd const& centre,
                                                         double limit)
{
    std::vector<std::unique_ptr<Surrogate>> fits;
    for (int t = 0; t < assessment.objective().size(); ++t) {
        Samples samples = assessment.samples(t);
        double const reach = 2 * limit * std::sqrt(static_cast<double>(centre.size()));
        for (Eigen::Index i = 0; i < samples.values.size(); ++i) {
            double const distance = (samples.points.row(i).transpose() - centre).norm() / reach;
            samples.weights[i] *= std::max(std::exp(-0.5 * distance * distance), 1e-3);
        }
        fits.push_back(fit_surrogate(SurrogateChoice::quadratic, samples));
    }
    return fits;
}

} // namespace

void take_response_surface_points(ensemble::Campaign const& campaign, Assessment const& assessment, int count,
                                  std::uint64_t seed, Choice& choice)
{
    Location const* best = assessment.locations().best();
    if (!best)
        return;
    auto const& cube = assessment.cube();
    auto const& objective = assessment.objective();
    double const limit =
        std::max(narrowest_move, widest_move * std::pow(0.5, waves_in_vain(campaign, assessment)));
    auto const fits = local_quadratics(assessment, best->unit, limit);
    VectorXd const lower = (best->unit.array() - limit).max(0), upper = (best->unit.array() + limit).min(1);
    auto inside = [&](VectorXd const& share) {
        return cube.project(lower + share.cwiseProduct(upper - lower));
    };
    LeastSquaresProblem const problem{cube.size(), objective.residual_count(), [&](VectorXd const& share) {
                                          VectorXd const unit = inside(share);
                                          VectorXd responses(objective.size());
                                          for (int t = 0; t < objective.size(); ++t)
                                              responses[t] = fits[t]->value(unit);
                                          return objective.search_residuals(responses);
                                      }};
    VectorXd const start = (best->unit - lower).cwiseQuotient((upper - lower).cwiseMax(1e-9));
    VectorXd const minimum = choice.simulated(inside(assessment.solver().minimise(problem, start, {}).point));
    if (choice.is_other(minimum))
        choice.take(minimum);

    constexpr int candidates = 300;
    RandomStream random(seed);
    while (choice.size() < count) {
        VectorXd farthest;
        double distance = 0;
        for (int i = 0; i < candidates; ++i) {
            VectorXd share(cube.size());
            for (double& x : share)
                x = random.uniform();
            VectorXd const unit = choice.simulated(inside(share));
            if (choice.is_new(unit) && choice.distance(unit) > distance)
                farthest = unit, distance = choice.distance(unit);
        }
        if (farthest.size() == 0)
            return; // full: the caller looks elsewhere
        choice.take(farthest);
    }
}

} // namespace demens::tao_calib
