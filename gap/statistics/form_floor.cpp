#include "gap/statistics/form_floor.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/amplitude_model.hpp"
#include "gap/statistics/floor.hpp"
#include "gap/statistics/golden_section.hpp"

namespace demens::gap {

namespace {

constexpr double largest = 0.5, tolerance = 1e-5;
constexpr double one_sided_95 = 0.5 * 1.645 * 1.645; //!< of the logarithm of the likelihood

double log_likelihood(std::vector<Evidence>& cases, double form_floor)
{
    double sum = 0;
    for (auto& evidence : cases) {
        evidence.form_floor = form_floor;
        AmplitudeModel const model(evidence, make_floor(evidence).total(), {});
        sum += model.log_likelihood(model.project(evidence.residual()), {});
    }
    return sum;
}

} // namespace

FormFloor estimate_form_floor(std::vector<Evidence> cases)
{
    if (cases.empty())
        throw InputError(
            "the form floor is estimated from no case: give cases in which nothing is missing, or "
            "say a floor");
    auto const at = [&](double form_floor) { return log_likelihood(cases, form_floor); };
    FormFloor floor{argmax_between(0, largest, tolerance, at), largest};
    double const least = at(floor.most_likely) - one_sided_95;
    double inside = floor.most_likely;
    while (floor.upper - inside > tolerance) {
        double const half = 0.5 * (inside + floor.upper);
        (at(half) >= least ? inside : floor.upper) = half;
    }
    return floor;
}

} // namespace demens::gap
