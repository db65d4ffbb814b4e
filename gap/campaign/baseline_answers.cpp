#include "gap/campaign/baseline_answers.hpp"

#include "gap/statistics/baselines.hpp"

namespace demens::gap {
namespace {

//! Of classes none and the effects.
std::string name_of(Eigen::Index place, Diagnosis const& found)
{
    return place == 0 ? "none" : found.effects()[static_cast<std::size_t>(place - 1)].name;
}

Eigen::Index least(Eigen::VectorXd const& values)
{
    Eigen::Index place = 0;
    values.minCoeff(&place);
    return place;
}

} // namespace

BaselineAnswers baseline_answers(Diagnosis const& found)
{
    auto const& evidence = found.evidence();
    auto const residual = evidence.residual();
    if (found.effects().empty())
        return {"none", "none", "none"};
    Eigen::Index closest = 0;
    residual_cosines(evidence, found.effects(), residual).maxCoeff(&closest);
    return {name_of(closest + 1, found),
            name_of(least(refitted_misfits(evidence, found.projection(), found.effects(), residual)), found),
            name_of(least(information_criteria(evidence, found.effects(), residual)), found)};
}

} // namespace demens::gap
