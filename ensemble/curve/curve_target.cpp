#include "ensemble/curve/curve_target.hpp"

#include "demens/base/not_a_number.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace demens::ensemble {
namespace {

double value_at(CurveTarget const& target, MeasuredCurve const& simulated, double place)
{
    if (!target.is_profile && simulated.size() > 0)
        place = std::clamp(place, simulated.axis.front(), simulated.axis.back());
    return simulated.at(place);
}

//! Mean square deviation of the points that all windows have, at a shift; NaN where there is nothing to
//! compare.
double misfit(CurveTarget const& target, MeasuredCurve const& simulated, std::vector<double> const& shares,
              double shift)
{
    double sum = 0, all = 0;
    for (auto const& window : target.windows)
        for (std::size_t k = window.first; k < window.end; ++k) {
            double const deviation =
                value_at(target, simulated, target.curve.axis[k] + shift) - target.curve.values[k];
            if (std::isnan(deviation))
                continue;
            sum += window.weight * shares[k] * deviation * deviation;
            all += window.weight * shares[k];
        }
    return all > 0 ? sum / all : not_a_number;
}

std::string response_name(CurveTarget const& target, CurveWindow const& window)
{
    return fmt::format("{}_{}", target.name, window.name);
}

} // namespace

CurveWindow const* window_of(CurveTarget const& target, std::string const& response)
{
    for (auto const& window : target.windows)
        if (response_name(target, window) == response)
            return &window;
    return nullptr;
}

std::vector<rig::ResponseInfo> responses_of(CurveTarget const& target, std::string const& axis_units,
                                            std::string const& units)
{
    std::vector<rig::ResponseInfo> responses;
    for (auto const& window : target.windows)
        responses.push_back({response_name(target, window), units,
                             fmt::format("mean of {} from {:.4g} to {:.4g} {}", target.name, window.from,
                                         window.to, axis_units)});
    if (target.shift == CurveShift::free)
        responses.push_back({target.name + "_shift", axis_units,
                             fmt::format("what is added to the measured axis of {}", target.name),
                             rig::ResponseKind::accuracy});
    return responses;
}

double shift_of(CurveTarget const& target, MeasuredCurve const& simulated)
{
    if (target.shift == CurveShift::fixed || target.largest_shift <= 0)
        return target.offset;
    // The misfit may have several minima: the best of a grid, then halves of its steps.
    constexpr int steps = 100;
    auto const shares = target.curve.shares();
    double best = target.offset, least = misfit(target, simulated, shares, best),
           step = target.largest_shift / steps;
    auto const try_shift = [&](double shift) {
        if (std::abs(shift - target.offset) > target.largest_shift * (1 + 1e-12))
            return;
        double const value = misfit(target, simulated, shares, shift);
        if (value < least || (std::isnan(least) && !std::isnan(value))) {
            least = value;
            best = shift;
        }
    };
    for (int k = 1; k <= steps; ++k)
        for (int const sign : {1, -1})
            try_shift(target.offset + sign * k * step);
    for (int halving = 0; halving < 20; ++halving) {
        step *= 0.5;
        for (double const centre = best; int const sign : {1, -1})
            try_shift(centre + sign * step);
    }
    return best;
}

MeasuredCurve simulated_curve(CurveTarget const& target, rig::Series const& series,
                              std::vector<rig::Profile> const& profiles)
{
    rig::Series const* found = nullptr;
    std::size_t column = 0;
    if (target.is_profile) {
        for (auto const& profile : profiles)
            if (profile.name == target.name) {
                found = &profile.curve;
                column = 1;
            }
    } else if (auto const at = std::find(series.names.begin(), series.names.end(), target.name);
               at != series.names.end()) {
        found = &series;
        column = static_cast<std::size_t>(at - series.names.begin());
    }
    MeasuredCurve curve;
    if (found == nullptr)
        return curve;
    for (std::size_t row = 0; row < found->rows(); ++row) {
        double const place = found->columns[0][row], value = found->columns[column][row];
        if (std::isnan(place) || std::isnan(value))
            continue;
        while (curve.size() > 0 &&
               place <= curve.axis.back()) { // one stage ends where the next begins: that counts
            curve.axis.pop_back();
            curve.values.pop_back();
        }
        curve.axis.push_back(place);
        curve.values.push_back(value);
    }
    return curve;
}

std::vector<double> responses_of(CurveTarget const& target, rig::RunResult const& result)
{
    auto const simulated = simulated_curve(target, result.series, result.profiles);
    auto const shares = target.curve.shares();
    double const shift = shift_of(target, simulated);
    std::vector<double> responses;
    for (auto const& window : target.windows) {
        double sum = 0, all = 0;
        for (std::size_t k = window.first; k < window.end; ++k) {
            sum += shares[k] * value_at(target, simulated, target.curve.axis[k] + shift);
            all += shares[k];
        }
        responses.push_back(sum / all);
    }
    if (target.shift == CurveShift::free)
        responses.push_back(shift);
    return responses;
}

} // namespace demens::ensemble
