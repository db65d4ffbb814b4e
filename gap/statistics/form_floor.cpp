#include "gap/statistics/form_floor.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/amplitude_model.hpp"
#include "gap/statistics/floor.hpp"
#include "gap/statistics/golden_section.hpp"

namespace demens::gap {

double estimate_form_floor(std::vector<Evidence> cases)
{
    if (cases.empty())
        throw InputError(
            "the form floor is estimated from no case: give cases in which nothing is missing, or "
            "say a floor");
    return argmax_between(0, 0.5, 1e-5, [&](double form_floor) {
        double sum = 0;
        for (auto& evidence : cases) {
            evidence.form_floor = form_floor;
            AmplitudeModel const model(evidence, make_floor(evidence).total(), {});
            sum += model.log_likelihood(model.project(evidence.residual()), {});
        }
        return sum;
    });
}

} // namespace demens::gap
