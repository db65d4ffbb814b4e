#include "gap/catalogue/measured_response.hpp"

#include "demens/observe/surface.hpp"

namespace demens::gap {
namespace {

using ensemble::CurveTarget, ensemble::Experiment, ensemble::PictureTarget, ensemble::TargetSource;

constexpr std::size_t least_points = 3; //!< that a slope is taken of, where there are as many
constexpr double mm = 1e3;              //!< in a metre

//! Of the line through the points `first` to `end` and, where these are few, those beside them.
double slope_about(std::vector<double> const& axis, std::vector<double> const& values, std::size_t first,
                   std::size_t end)
{
    while (end - first < least_points && end - first < axis.size()) {
        first -= first > 0;
        end += end < axis.size();
    }
    return observe::fit_line({&axis[first], &axis[first] + (end - first)},
                             {&values[first], &values[first] + (end - first)})
        .slope;
}

void add_window(MeasuredResponse& response, CurveTarget const& target, ensemble::CurveWindow const& window)
{
    response.over_time = !target.is_profile;
    response.zero_known = target.shift == ensemble::CurveShift::fixed;
    response.place = (window.from + window.to) / 2;
    response.slope = slope_about(target.curve.axis, target.curve.values, window.first, window.end);
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

} // namespace

std::vector<MeasuredResponse> measured_responses(Experiment const& experiment,
                                                 std::vector<ensemble::Target> const& targets)
{
    std::vector<MeasuredResponse> responses;
    std::size_t segments = 0; // seen so far, which are targets in their order
    for (auto const& target : targets) {
        auto const& of = experiment.responses.at(static_cast<std::size_t>(target.response_index));
        responses.push_back({of.name, of.units, target.value, target.comes_of});
        if (target.comes_of == TargetSource::picture && experiment.picture)
            add_segment(responses.back(), *experiment.picture, segments++);
        for (auto const& curve : experiment.curves)
            if (auto const* window = window_of(curve, target.response))
                add_window(responses.back(), curve, *window);
    }
    return responses;
}

} // namespace demens::gap
