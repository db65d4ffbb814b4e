#include "gap/statistics/decoys.hpp"

#include "gap/statistics/gaussian.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace demens::gap {

double linear_closure(Evidence const& fitted, Projection const& projection, Evidence const& held_out,
                      Signature const& on_fitted, Signature const& on_held_out)
{
    auto const others = gap::held_out(held_out);
    auto predict = [&](Refit const& fit, std::vector<Signature> const& effects) {
        Eigen::VectorXd const mean =
            held_out.predicted + change(held_out, effects, fit.amplitudes, fit.factors);
        return Eigen::MatrixXd(mean.transpose());
    };
    Eigen::VectorXd const residual = fitted.residual();
    HeldOutPrediction const before{predict(refit(fitted, projection, residual), {}),
                                   estimation_covariance(fitted, projection, held_out)};
    HeldOutPrediction const after{
        predict(refit_with(fitted, projection, {on_fitted}, residual), {on_held_out}),
        estimation_covariance(fitted, projection, held_out, {on_fitted}, {on_held_out})};
    return quantify(others, before, after, {.resamples = 1}).closure;
}

std::vector<Eigen::VectorXd> random_smooth_signatures(std::vector<Cell> const& cells,
                                                      Eigen::VectorXd const& like, double correlation_length,
                                                      int count, std::uint64_t seed)
{
    Eigen::VectorXd const scale = scales(cells);
    auto size = [&](Eigen::VectorXd const& signature) {
        double sum = 0;
        for (Eigen::Index i = 0; i < scale.size(); ++i)
            sum += scale[i] > 0 ? std::pow(signature[i] / scale[i], 2) : 0;
        return std::sqrt(sum);
    };
    Eigen::MatrixXd const root = square_root(form_correlation(cells, cells, correlation_length));
    std::vector<Eigen::VectorXd> made;
    for (int i = 0; i < count; ++i) {
        RandomStream random(derive_seed(seed, static_cast<std::uint64_t>(i)));
        Eigen::VectorXd signature = scale.cwiseProduct(root * standard_normals(scale.size(), random));
        double const own = size(signature);
        made.push_back(own > 0 ? Eigen::VectorXd(signature * (size(like) / own)) : signature);
    }
    return made;
}

Eigen::VectorXd permuted_signature(std::vector<Cell> const& cells, Eigen::VectorXd const& signature,
                                   int shift)
{
    std::map<int, std::vector<int>> places, families; // by experiment
    for (int i = 0; i < static_cast<int>(cells.size()); ++i) {
        places[cells[i].experiment].push_back(i);
        families[cells[i].experiment].push_back(cells[i].response_family);
    }
    std::map<std::vector<int>, std::vector<int>>
        alike; // experiments with the same families in the same order
    for (auto const& [experiment, own] : families)
        alike[own].push_back(experiment);
    Eigen::VectorXd permuted = signature;
    for (auto const& [own, experiments] : alike)
        for (std::size_t e = 0; e < experiments.size(); ++e) {
            auto const& from =
                places[experiments[(e + static_cast<std::size_t>(shift)) % experiments.size()]];
            auto const& to = places[experiments[e]];
            for (std::size_t i = 0; i < to.size(); ++i)
                permuted[to[i]] = signature[from[i]];
        }
    return permuted;
}

double decoy_p_value(double closure, std::vector<double> const& decoys)
{
    auto const as_good = std::count_if(decoys.begin(), decoys.end(), [&](double d) { return d >= closure; });
    return (1 + static_cast<double>(as_good)) / (1 + static_cast<double>(decoys.size()));
}

} // namespace demens::gap
