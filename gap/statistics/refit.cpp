#include "gap/statistics/refit.hpp"

namespace demens::gap {

Refit refit(Evidence const& evidence, Projection const& projection, Eigen::VectorXd const& residual)
{
    Eigen::VectorXd const solved = projection.solve(residual);
    Eigen::MatrixXd const gain = evidence.nuisance_prior * evidence.nuisance.transpose();
    Refit found;
    found.factors = gain * solved;
    found.factor_covariance =
        evidence.nuisance_prior - gain * projection.solve(evidence.nuisance) * evidence.nuisance_prior;
    found.residual = projection.floor() * solved;
    found.misfit = residual.dot(solved);
    return found;
}

Eigen::MatrixXd refitted_covariance(Projection const& projection)
{
    Eigen::MatrixXd const reduced = projection.reduce(projection.floor());
    return reduced.transpose() * reduced;
}

Refit refit_with(Evidence const& evidence, Projection const& projection,
                 std::vector<Signature> const& effects, Eigen::VectorXd const& residual, AmplitudePrior prior)
{
    AmplitudeModel const model(evidence, projection.floor(), effects);
    auto const data = model.project(residual);
    auto const best = best_amplitudes(model, data, prior);
    Refit found;
    found.factors = model.factors(data, best);
    found.factor_covariance = model.factor_covariance(best);
    found.amplitudes = best;
    for (int k = 0; k < model.effects(); ++k)
        found.amplitudes[k] *= model.unit(k);
    found.misfit = model.misfit(data, best);
    found.residual = residual - change(evidence, effects, found.amplitudes, found.factors);
    return found;
}

Eigen::VectorXd change(Evidence const& evidence, std::vector<Signature> const& effects,
                       Eigen::VectorXd const& amplitudes, Eigen::VectorXd const& factors)
{
    Eigen::VectorXd sum = evidence.nuisance * factors;
    for (std::size_t k = 0; k < effects.size(); ++k) {
        double const a = amplitudes[static_cast<int>(k)];
        sum += a * effects[k].first;
        if (effects[k].interaction.size() > 0)
            sum += a * (effects[k].interaction * factors);
        if (effects[k].second.size() > 0)
            sum += a * a * effects[k].second;
    }
    return sum;
}

} // namespace demens::gap
