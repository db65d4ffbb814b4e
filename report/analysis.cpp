#include "report/analysis.hpp"

#include <algorithm>
#include <limits>
#include <ranges>

namespace demens::report {

using nlohmann::json;

namespace {

bool is_analysed(ensemble::Wave const& wave)
{
    return std::ranges::any_of(wave.analysis, [](auto const& array) { return array.path == "history/wmse"; });
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

} // namespace

Analysis::Analysis(ensemble::Campaign const& campaign)
{
    for (auto const& wave : campaign.waves | std::views::reverse) {
        if (is_analysed(wave)) {
            wave_ = &wave;
            return;
        }
    }
}

ensemble::NamedArray const* Analysis::find(std::string const& path) const
{
    if (!wave_)
        return nullptr;
    auto const found = std::ranges::find(wave_->analysis, path, &ensemble::NamedArray::path);
    return found == wave_->analysis.end() ? nullptr : &*found;
}

json Analysis::values(std::string const& path) const
{
    auto const* array = find(path);
    if (!array || array->shape.empty())
        return nullptr;
    std::size_t next = 0;
    return nested(*array, 0, next);
}

double Analysis::scalar(std::string const& path) const
{
    auto const* array = find(path);
    return array && !array->data.empty() ? array->data.front() : std::numeric_limits<double>::quiet_NaN();
}

json optimum_of(Analysis const& analysis)
{
    if (!analysis.has_best())
        return nullptr;
    return {
        {"wave", analysis.wave()},
        {"point", analysis.values("optimum/best_point")},
        {"point_number", analysis.scalar("optimum/best_point_number")},
        {"run", analysis.scalar("optimum/best_run")},
        {"repetitions", analysis.scalar("optimum/best_repetitions")},
        {"responses", analysis.values("optimum/best_responses")},
        {"residuals", analysis.values("optimum/best_residuals")},
        {"wmse", analysis.scalar("optimum/wmse")},
        {"mean_square_residual", analysis.scalar("optimum/mean_square_residual")},
        {"predicted_point", analysis.values("optimum/predicted_point")},
        {"predicted_responses", analysis.values("optimum/predicted_responses")},
        {"predicted_sd", analysis.values("optimum/predicted_sd")},
        {"predicted_wmse", analysis.scalar("optimum/predicted_wmse")},
        {"standard_error", analysis.values("optimum/factor_standard_error")},
        {"interval", analysis.values("optimum/factor_interval")},
        {"correlation", analysis.values("optimum/factor_correlation")},
        {"verdict", analysis.values("optimum/factor_verdict")},
        {"objective", analysis.scalar("optimum/objective")},
        {"out_of_reach", analysis.values("optimum/out_of_reach")},
    };
}

json findings_of(Analysis const& analysis)
{
    if (!analysis.find("region/share"))
        return nullptr;
    return {
        {"by_tolerance", analysis.scalar("region/by_tolerance") == 1},
        {"share", analysis.scalar("region/share")},
        {"part_shares", analysis.values("region/part_shares")},
        {"part_lower", analysis.values("region/part_lower")},
        {"part_upper", analysis.values("region/part_upper")},
        {"pairs", analysis.values("tradeoff/factors")},
        {"correlation", analysis.values("tradeoff/correlation")},
        {"separated_by", analysis.values("tradeoff/response")},
        {"variance_removed", analysis.values("tradeoff/variance_removed")},
    };
}

json screening_of(Analysis const& analysis)
{
    if (!analysis.find("screening/active"))
        return nullptr;
    return {
        {"active", analysis.values("screening/active")},
        {"fixed_value", analysis.values("screening/fixed_value")},
        {"effects", analysis.values("screening/effects")},
        {"p_values", analysis.values("screening/p_values")},
        {"error_degrees", analysis.values("screening/error_degrees")},
        {"from_replicates", analysis.scalar("screening/error_from_replicates") == 1},
    };
}

json surrogate_of(Analysis const& analysis)
{
    if (!analysis.find("surrogate/slices"))
        return nullptr;
    return {
        {"locations", analysis.scalar("surrogate/locations")},
        {"kind", analysis.values("surrogate/kind")},
        {"leave_one_out_rmse", analysis.values("surrogate/leave_one_out_rmse")},
        {"leave_one_out_r2", analysis.values("surrogate/leave_one_out_r2")},
        {"replicate_sd", analysis.values("surrogate/replicate_sd")},
        {"slice_values", analysis.values("surrogate/slice_values")},
        {"slices", analysis.values("surrogate/slices")},
        {"slice_sd", analysis.values("surrogate/slice_sd")},
    };
}

} // namespace demens::report
