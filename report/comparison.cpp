#include "report/comparison.hpp"

#include "demens/base/error.hpp"

#include <algorithm>

namespace demens::report {

using nlohmann::json;

namespace {

constexpr std::size_t most_points = 1000; // of a curve, that a plot can show

//! Numbers of the targets of a kind that an experiment has: among its own, and where those begin among all of
//! the campaign.
struct TargetsOf
{
    std::size_t own, before;

    TargetsOf(ensemble::CampaignInput const& input, std::size_t experiment, ensemble::TargetSource source)
        : before(0)
    {
        for (std::size_t e = 0; e < experiment; ++e)
            before += input.experiments[e].targets.size();
        auto const& targets = input.experiments[experiment].targets;
        own = static_cast<std::size_t>(
            std::find_if(targets.begin(), targets.end(),
                         [&](ensemble::Target const& target) { return target.comes_of == source; }) -
            targets.begin());
    }
    std::size_t next() { return before + own++; }
};

json points_of(ensemble::MeasuredCurve const& curve)
{
    json axis = json::array(), values = json::array();
    std::size_t const stride = std::max<std::size_t>(1, curve.size() / most_points);
    for (std::size_t k = 0; k < curve.size(); k += stride) {
        axis.push_back(curve.axis[k]);
        values.push_back(curve.values[k]);
    }
    return {{"axis", axis}, {"values", values}};
}

json runs_of(observe::Mask const& mask)
{
    json runs = json::array();
    std::size_t length = 0;
    bool dark = false;
    for (auto const covered : mask.covered) {
        if ((covered != 0) != dark) {
            runs.push_back(length);
            dark = !dark;
            length = 0;
        }
        ++length;
    }
    runs.push_back(length);
    return runs;
}

} // namespace

json curves_beside(ensemble::CampaignInput const& input, std::size_t experiment,
                   ensemble::RunDetails const& details)
{
    json list = json::array();
    auto const& described = input.experiments[experiment];
    TargetsOf targets(input, experiment, ensemble::TargetSource::curve);
    for (auto const& curve : described.curves) {
        auto const response = static_cast<std::size_t>(described.targets[targets.own].response_index);
        auto simulated = simulated_curve(curve, details.series, details.profiles);
        double const shift = shift_of(curve, simulated);
        for (double& place : simulated.axis)
            place -= shift;
        json windows = json::array();
        for (auto const& window : curve.windows)
            windows.push_back({{"name", window.name},
                               {"from", window.from},
                               {"to", window.to},
                               {"target", targets.next()}});
        list.push_back({{"name", curve.name},
                        {"units", described.responses[response].units},
                        {"axis", curve.is_profile ? "axis" : "time"},
                        {"axis_units", curve.is_profile ? "" : "s"},
                        {"sd", curve.sd},
                        {"shift", shift},
                        {"measured", points_of(curve.curve)},
                        {"simulated", points_of(simulated)},
                        {"windows", windows}});
    }
    return list;
}

json picture_beside(ensemble::CampaignInput const& input, std::size_t experiment,
                    ensemble::RunDetails const& details)
{
    auto const& target = input.experiments[experiment].picture;
    if (!target)
        return nullptr;
    observe::BedPicture bed;
    try {
        bed = read_bed(cut_through(simulated_picture(*target, details.profiles), target->simulated_cut),
                       target->frame, target->reading);
    } catch (InputError const&) {
        return nullptr; // kept by no run of earlier programs
    }
    json segments = json::array();
    TargetsOf targets(input, experiment, ensemble::TargetSource::picture);
    for (std::size_t const k : target->segments)
        segments.push_back({{"x", 1e3 * target->bed.profile.x[k]}, {"target", targets.next()}});
    auto const& circle = target->frame.circle;
    return {{"columns", target->frame.columns},
            {"rows", target->frame.rows},
            {"pixel_mm", 1e3 * target->frame.pixel_size()},
            {"circle", {circle.x, circle.y, circle.radius}},
            {"inside", target->reading.inside_radius},
            {"segment_mm", 2e3 * target->frame.radius / target->reading.segments},
            {"mismatch_mm2",
             1e6 * area_mismatch(bed.mask, target->bed.mask, target->frame, target->reading.inside_radius)},
            {"measured", runs_of(target->bed.mask)},
            {"simulated", runs_of(bed.mask)},
            {"segments", segments}};
}

} // namespace demens::report
