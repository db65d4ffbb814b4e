#include "report/analysis.hpp"

#include "demens/base/not_a_number.hpp"
#include "ensemble/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::report {

using nlohmann::json;
namespace stored = ensemble::stored;

namespace {

bool is_analysed(ensemble::Wave const& wave)
{
    return wave.find(stored::history::wmse) != nullptr;
}

//! Row-major data as lists in lists.
json nested(ensemble::NamedArray const& array, std::size_t dimension, std::size_t& next)
{
    json list = json::array();
    for (std::size_t i = 0; i < array.shape[dimension]; ++i)
        list.push_back(dimension + 1 < array.shape.size() ? nested(array, dimension + 1, next)
                                                          : json(array.data.at(next++)));
    return list;
}

//! By factor, what the targets tell of it; null before it is judged.
json verdict_texts(Analysis const& analysis)
{
    auto const* verdicts = analysis.find(stored::optimum::factor_verdict);
    if (!verdicts)
        return nullptr;
    json texts = json::array();
    for (double const verdict : verdicts->data)
        texts.push_back(std::isfinite(verdict) ? json(name_of(static_cast<ensemble::Verdict>(verdict)))
                                               : nullptr);
    return texts;
}

//! Numbers by factor, null where the verdict is that no run supports any; verdict_texts() says why.
json supported(Analysis const& analysis, stored::ArrayName const& name)
{
    auto const* verdicts = analysis.find(stored::optimum::factor_verdict);
    json values = analysis.values(name);
    if (!verdicts || !values.is_array())
        return values;
    for (std::size_t k = 0; k < std::min(values.size(), verdicts->data.size()); ++k)
        if (!has_interval(static_cast<ensemble::Verdict>(verdicts->data[k])))
            values[k] = values[k].is_array() ? json(std::vector<double>(values[k].size(), not_a_number))
                                             : json(not_a_number);
    return values;
}

} // namespace

Analysis::Analysis(ensemble::Campaign const& campaign)
{
    auto const last = std::find_if(campaign.waves.rbegin(), campaign.waves.rend(), is_analysed);
    if (last != campaign.waves.rend())
        wave_ = &*last;
}

ensemble::NamedArray const* Analysis::find(stored::ArrayName const& name) const
{
    return wave_ ? wave_->find(name) : nullptr;
}

json Analysis::values(stored::ArrayName const& name) const
{
    auto const* array = find(name);
    if (!array || array->shape.empty())
        return nullptr;
    std::size_t next = 0;
    return nested(*array, 0, next);
}

double Analysis::scalar(stored::ArrayName const& name) const
{
    auto const* array = find(name);
    return array && !array->data.empty() ? array->data.front() : std::numeric_limits<double>::quiet_NaN();
}

json optimum_of(Analysis const& analysis)
{
    if (!analysis.has_best())
        return nullptr;
    return {
        {"wave", analysis.wave()},
        {"point", analysis.values(stored::optimum::best_point)},
        {"point_number", analysis.scalar(stored::optimum::best_point_number)},
        {"run", analysis.scalar(stored::optimum::best_run)},
        {"repetitions", analysis.scalar(stored::optimum::best_repetitions)},
        {"responses", analysis.values(stored::optimum::best_responses)},
        {"residuals", analysis.values(stored::optimum::best_residuals)},
        {"wmse", analysis.scalar(stored::optimum::wmse)},
        {"mean_square_residual", analysis.scalar(stored::optimum::mean_square_residual)},
        {"predicted_point", analysis.values(stored::optimum::predicted_point)},
        {"predicted_responses", analysis.values(stored::optimum::predicted_responses)},
        {"predicted_sd", analysis.values(stored::optimum::predicted_sd)},
        {"predicted_wmse", analysis.scalar(stored::optimum::predicted_wmse)},
        {"estimate", supported(analysis, stored::optimum::estimate)},
        {"estimate_responses", analysis.values(stored::optimum::estimate_responses)},
        {"estimate_sd", analysis.values(stored::optimum::estimate_sd)},
        {"least_misfit", analysis.scalar(stored::optimum::least_misfit)},
        {"degrees", analysis.scalar(stored::optimum::degrees)},
        {"p_value", analysis.scalar(stored::optimum::p_value)},
        {"noise_inflation", analysis.scalar(stored::optimum::noise_inflation)},
        {"spread", supported(analysis, stored::optimum::factor_spread)},
        {"on_bound", analysis.values(stored::optimum::factor_on_bound)},
        {"standard_error", supported(analysis, stored::optimum::factor_standard_error)},
        {"interval", supported(analysis, stored::optimum::factor_interval)},
        {"correlation", analysis.values(stored::optimum::factor_correlation)},
        {"verdict", analysis.values(stored::optimum::factor_verdict)},
        {"verdict_text", verdict_texts(analysis)},
        {"verdict_rule", ensemble::verdict_rule()},
        {"objective", analysis.scalar(stored::optimum::objective)},
        {"out_of_reach", analysis.values(stored::optimum::out_of_reach)},
    };
}

json findings_of(Analysis const& analysis)
{
    if (!analysis.find(stored::region::share))
        return nullptr;
    return {
        {"by_tolerance", analysis.scalar(stored::region::by_tolerance) == 1},
        {"share", analysis.scalar(stored::region::share)},
        {"part_shares", analysis.values(stored::region::part_shares)},
        {"part_lower", analysis.values(stored::region::part_lower)},
        {"part_upper", analysis.values(stored::region::part_upper)},
        {"pairs", analysis.values(stored::tradeoff::factors)},
        {"correlation", analysis.values(stored::tradeoff::correlation)},
        {"separated_by", analysis.values(stored::tradeoff::response)},
        {"variance_removed", analysis.values(stored::tradeoff::variance_removed)},
    };
}

json screening_of(Analysis const& analysis)
{
    if (!analysis.find(stored::screening::active))
        return nullptr;
    return {
        {"active", analysis.values(stored::screening::active)},
        {"fixed_value", analysis.values(stored::screening::fixed_value)},
        {"effects", analysis.values(stored::screening::effects)},
        {"p_values", analysis.values(stored::screening::p_values)},
        {"curvature", analysis.values(stored::screening::curvature)},
        {"curvature_p", analysis.values(stored::screening::curvature_p)},
        {"curved", analysis.values(stored::screening::curved)},
        {"error_degrees", analysis.values(stored::screening::error_degrees)},
        {"from_replicates", analysis.scalar(stored::screening::error_from_replicates) == 1},
    };
}

json surrogate_of(Analysis const& analysis)
{
    if (!analysis.find(stored::surrogate::slices))
        return nullptr;
    return {
        {"locations", analysis.scalar(stored::surrogate::locations)},
        {"complete_locations", analysis.scalar(stored::surrogate::complete_locations)},
        {"informs", analysis.values(stored::surrogate::informs)},
        {"kind", analysis.values(stored::surrogate::kind)},
        {"leave_one_out_rmse", analysis.values(stored::surrogate::leave_one_out_rmse)},
        {"leave_one_out_r2", analysis.values(stored::surrogate::leave_one_out_r2)},
        {"left_out", analysis.values(stored::surrogate::left_out)},
        {"replicate_sd", analysis.values(stored::surrogate::replicate_sd)},
        {"slice_values", analysis.values(stored::surrogate::slice_values)},
        {"slices", analysis.values(stored::surrogate::slices)},
        {"slice_sd", analysis.values(stored::surrogate::slice_sd)},
    };
}

} // namespace demens::report
