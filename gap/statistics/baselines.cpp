#include "gap/statistics/baselines.hpp"

#include "gap/statistics/floor.hpp"
#include "gap/statistics/refit.hpp"

#include <cmath>

namespace demens::gap {

Eigen::VectorXd residual_cosines(Evidence const& evidence, std::vector<Signature> const& effects,
                                 Eigen::VectorXd const& residual)
{
    auto const floor = make_floor(evidence);
    Eigen::VectorXd const sd = (floor.experiment + floor.seed).diagonal().cwiseSqrt();
    auto over_errors = [&](Eigen::VectorXd const& v) {
        return Eigen::VectorXd((sd.array() > 0).select(v.array() / sd.array(), 0.0));
    };
    Eigen::VectorXd const r = over_errors(residual);
    Eigen::VectorXd cosines = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(effects.size()));
    for (std::size_t k = 0; k < effects.size(); ++k) {
        Eigen::VectorXd const s = over_errors(effects[k].first);
        double const both = s.norm() * r.norm();
        cosines[static_cast<int>(k)] = both > 0 ? std::abs(s.dot(r)) / both : 0;
    }
    return cosines;
}

Eigen::VectorXd refitted_misfits(Evidence const& evidence, Projection const& projection,
                                 std::vector<Signature> const& effects, Eigen::VectorXd const& residual)
{
    Eigen::VectorXd misfits(static_cast<Eigen::Index>(effects.size()) + 1);
    misfits[0] = refit(evidence, projection, residual).misfit;
    for (std::size_t k = 0; k < effects.size(); ++k)
        misfits[static_cast<int>(k) + 1] =
            refit_with(evidence, projection, {effects[k]}, residual, AmplitudePrior::flat).misfit;
    return misfits;
}

Eigen::VectorXd information_criteria(Evidence const& evidence, std::vector<Signature> const& effects,
                                     Eigen::VectorXd const& residual)
{
    auto const floor = make_floor(evidence);
    Projection const projection(evidence, floor.experiment + floor.seed);
    Eigen::VectorXd criteria = refitted_misfits(evidence, projection, effects, residual);
    criteria.tail(criteria.size() - 1).array() += std::log(static_cast<double>(evidence.size()));
    return criteria;
}

} // namespace demens::gap
