#include "gap/catalogue/measured_response.hpp"

#include <algorithm>
#include <map>
#include <span>

namespace demens::gap {
namespace {

using ensemble::CurveTarget, ensemble::Experiment, ensemble::PictureTarget, ensemble::TargetSource;

constexpr std::size_t least_points = 3; //!< that a slope is taken of, where there are as many
constexpr double mm = 1e3;              //!< in a metre

//! Of the line through the points `first` to `end` and, where these are few, those beside them.
double slope_about(std::span<double const> axis, std::span<double const> values, std::size_t first,
                   std::size_t end)
{
    while (end - first < least_points && end - first < axis.size()) {
        first -= first > 0;
        end += end < axis.size();
    }
    auto const n = static_cast<double>(end - first);
    double middle = 0, mean = 0;
    for (std::size_t k = first; k < end; ++k) {
        middle += axis[k] / n;
        mean += values[k] / n;
    }
    double both = 0, square = 0;
    for (std::size_t k = first; k < end; ++k) {
        both += (axis[k] - middle) * (values[k] - mean);
        square += (axis[k] - middle) * (axis[k] - middle);
    }
    return square > 0 ? both / square : 0;
}

void add_window(MeasuredResponse& response, CurveTarget const& target, std::size_t window)
{
    auto const& of = target.windows.at(window);
    response.over_time = !target.is_profile;
    response.zero_known = target.shift == ensemble::CurveShift::fixed;
    response.place = (of.from + of.to) / 2;
    response.slope = slope_about(target.curve.axis, target.curve.values, of.first, of.end);
}

void add_segment(MeasuredResponse& response, PictureTarget const& target, std::size_t segment)
{
    std::vector<double> x, z;
    for (auto const k : target.segments) {
        x.push_back(mm * target.bed.profile.x[k]);
        z.push_back(mm * target.bed.profile.z[k]);
    }
    response.place = x.at(segment);
    response.slope = slope_about(x, z, segment, segment + 1);
}

CurveTarget const* curve_of(Experiment const& experiment, std::string const& response)
{
    auto const curve = std::find_if(experiment.curves.begin(), experiment.curves.end(),
                                    [&](auto const& one) { return response.starts_with(one.name + "_"); });
    return curve == experiment.curves.end() ? nullptr : &*curve;
}

} // namespace

std::vector<MeasuredResponse> measured_responses(Experiment const& experiment,
                                                 std::vector<ensemble::Target> const& targets)
{
    std::vector<MeasuredResponse> responses;
    std::map<CurveTarget const*, std::size_t> windows; // seen so far, as segments
    std::size_t segments = 0;
    for (auto const& target : targets) {
        auto const& of = experiment.responses.at(static_cast<std::size_t>(target.response_index));
        responses.push_back({of.name, of.units, target.value, target.comes_of});
        if (target.comes_of == TargetSource::picture && experiment.picture)
            add_segment(responses.back(), *experiment.picture, segments++);
        if (target.comes_of == TargetSource::curve)
            if (auto const* curve = curve_of(experiment, target.response))
                add_window(responses.back(), *curve, windows[curve]++);
    }
    return responses;
}

} // namespace demens::gap
