#include "ensemble/input/curves.hpp"

#include "demens/rig/programme/programme.hpp"
#include "ensemble/curve/units.hpp"
#include "ensemble/input/input_options.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

//! Reads one curve; what is wrong is said with its key.
class CurveReader
{
  public:
    CurveReader(InputTable const& table, RigCurve const& rig_curve) : table_(table), rig_(rig_curve)
    {
        given_ = table.read(curve_options(), {"window"});
    }

    CurveTarget read(FileSource const& source, rig::Files& files)
    {
        CurveTarget target{.name = rig_.name, .is_profile = rig_.is_profile};
        read_points(source, files, target);
        trim(target);
        auto const scatter = scatter_of(target.curve);
        read_sd(scatter, target);
        read_shift(target);
        read_windows(target);
        target.given = given_;
        return target;
    }
    //! Of a key in the unit of the values, in that of the simulated curve.
    double of_values(std::string const& key) const { return value_ratio_ * given_.number(key); }

  private:
    std::string axis_key() const { return rig_.is_profile ? "axis" : "time"; }
    double of_axis(OptionValues const& values, std::string const& key) const
    {
        return axis_ratio_ * values.number(key);
    }

    void read_points(FileSource const& source, rig::Files& files, CurveTarget& target)
    {
        auto const& key = axis_key();
        if (auto const* other = rig_.is_profile ? "time" : "axis"; table_.has(other))
            throw table_.error(
                other, fmt::format("{} is a {}; give {} = \"COLUMN\"", rig_.name,
                                   rig_.is_profile ? "profile" : "reading of the series, over time", key));
        if (given_.text(key).empty())
            throw table_.error(
                fmt::format("the key \"{0}\" is missing; give {0} = \"COLUMN\", the column of the {1} "
                            "[{2}]",
                            key, rig_.is_profile ? "axis" : "time", rig_.axis_units));
        auto const& file = given_.text("file");
        try {
            if (!files.count(file))
                files.emplace(file, std::make_shared<std::string const>(source(file)));
            target.curve = read_curve(*files.at(file), file,
                                      {given_.text(key), given_.text("value"), rig_.axis_units, rig_.units});
        } catch (InputError const& error) {
            throw table_.error("file", error.what());
        }
        auto const ratio = [](std::string const& column, std::string const& units) {
            auto const unit = unit_in_name(column);
            return unit.empty() ? 1 : unit_ratio(unit, units);
        };
        axis_ratio_ = ratio(given_.text(key), rig_.axis_units);
        value_ratio_ = ratio(given_.text("value"), rig_.units);
    }

    //! Leaves what is to be compared.
    void trim(CurveTarget& target)
    {
        MeasuredCurve const all = std::move(target.curve);
        double const from = of_axis(given_, "from"), to = of_axis(given_, "to");
        target.curve = {};
        for (std::size_t k = 0; k < all.size(); ++k)
            if (!(all.axis[k] < from) && !(all.axis[k] > to)) {
                target.curve.axis.push_back(all.axis[k]);
                target.curve.values.push_back(all.values[k]);
            }
        if (target.curve.size() < 2)
            throw table_.error(
                table_.has("from") ? "from" : "to",
                fmt::format("leaves {} points of the curve, which goes from {:.6g} to {:.6g} {}",
                            target.curve.size(), all.axis.front(), all.axis.back(), rig_.axis_units));
    }

    void read_sd(CurveScatter const& scatter, CurveTarget& target)
    {
        target.effective = scatter.effective;
        target.sd = of_values("sd");
        if (!std::isnan(target.sd))
            return;
        auto const& v = target.curve.values;
        auto const [least, most] = std::minmax_element(v.begin(), v.end());
        if (!(scatter.sd > 1e-9 * std::max(std::abs(*least), std::abs(*most))))
            throw table_.error(
                std::isnan(scatter.sd)
                    ? fmt::format("{} points are too few to tell how they scatter; give sd = ..., the "
                                  "standard deviation of a point",
                                  target.curve.size())
                    : "the curve is smooth, so that nothing tells how good it is; give sd = ..., the "
                      "standard deviation of a point");
        target.sd = scatter.sd;
    }

    void read_shift(CurveTarget& target)
    {
        target.shift = given_.text("shift") == "free" ? CurveShift::free : CurveShift::fixed;
        target.offset = of_axis(given_, "offset");
        target.largest_shift = of_axis(given_, "largest_shift");
        if (target.shift == CurveShift::fixed && table_.has("largest_shift"))
            throw table_.error("largest_shift", "is used by shift = \"free\" alone; leave it out");
        if (std::isnan(target.largest_shift))
            target.largest_shift = 0.25 * (target.curve.axis.back() - target.curve.axis.front());
    }

    void read_windows(CurveTarget& target)
    {
        auto const tables = table_.table_list("window");
        if (tables.empty()) {
            divide(target);
        } else {
            if (table_.has("windows"))
                throw table_.error("windows", "does not go with tables `window`; leave one of them out");
            for (auto const& table : tables)
                target.windows.push_back(read_window(table, target));
        }
        auto const shares = target.curve.shares();
        double const each = target.effective / static_cast<double>(target.curve.size());
        for (std::size_t w = 0; w < target.windows.size(); ++w) {
            auto& window = target.windows[w];
            double sum = 0, all = 0;
            for (std::size_t k = window.first; k < window.end; ++k) {
                sum += shares[k] * target.curve.values[k];
                all += shares[k];
            }
            window.measured = sum / all;
            window.effective = std::max(1.0, each * static_cast<double>(window.end - window.first));
        }
    }

    void divide(CurveTarget& target)
    {
        auto const& axis = target.curve.axis;
        auto count = static_cast<std::size_t>(given_.integer("windows"));
        if (count == 0)
            count = std::clamp<std::size_t>(static_cast<std::size_t>(target.effective), 1, most_windows);
        for (;; --count) {
            target.windows.clear();
            double const width = (axis.back() - axis.front()) / static_cast<double>(count);
            for (std::size_t w = 0; w < count; ++w) {
                double const from = axis.front() + static_cast<double>(w) * width;
                CurveWindow window{.name = fmt::format("{}", w + 1), .from = from, .to = from + width};
                find_points(target, window);
                if (window.first < window.end)
                    target.windows.push_back(window);
            }
            if (target.windows.size() == count)
                return;
            if (table_.has("windows"))
                throw table_.error(
                    "windows", fmt::format("are more than the curve has points for: one of them is empty; "
                                           "{} points lie there",
                                           axis.size()));
        }
    }

    CurveWindow read_window(InputTable const& table, CurveTarget const& target)
    {
        auto const values = table.read(curve_window_options());
        given_.add_table("window", values);
        CurveWindow window{
            .name = values.text("name"), .from = 0, .to = 0, .weight = values.number("weight")};
        check_name(table, "name", window.name);
        for (auto const& other : target.windows)
            if (other.name == window.name)
                throw table.error("name", "two windows have this name; give each its own");
        window.from = border(table, values, "from", target, target.curve.axis.front());
        window.to = border(table, values, "to", target, target.curve.axis.back());
        if (!(window.from < window.to))
            throw table.error(fmt::format("begins at {:.6g} and ends at {:.6g} {}", window.from, window.to,
                                          rig_.axis_units));
        find_points(target, window);
        if (window.first == window.end)
            throw table.error(fmt::format("no point of the curve lies in it, from {:.6g} to {:.6g} {}",
                                          window.from, window.to, rig_.axis_units));
        return window;
    }

    double border(InputTable const& table, OptionValues const& values, std::string const& key,
                  CurveTarget const& target, double otherwise) const
    {
        auto const by_share = key + "_share";
        if (table.has(key) && table.has(by_share))
            throw table.error(by_share, fmt::format("says the same as {}; give one of them", key));
        if (table.has(key))
            return of_axis(values, key);
        if (!table.has(by_share))
            return otherwise;
        auto const& curve = target.curve;
        double const share = values.number(by_share), way = curve.values.back() - curve.values.front();
        for (std::size_t k = 0; k < curve.size(); ++k)
            if ((curve.values[k] - curve.values.front()) / way >= share)
                return curve.axis[k];
        return curve.axis.back(); // the last value itself, but for rounding
    }

    //! A point where one window ends and the next begins is in the later one; the last point is in that which
    //! ends there.
    static void find_points(CurveTarget const& target, CurveWindow& window)
    {
        auto const& axis = target.curve.axis;
        double const tiny = 1e-9 * (axis.back() - axis.front());
        bool const with_end = window.to > axis.back() - tiny;
        auto const begin = std::lower_bound(axis.begin(), axis.end(), window.from - tiny);
        auto const end =
            std::lower_bound(axis.begin(), axis.end(), with_end ? window.to + tiny : window.to - tiny);
        window.first = static_cast<std::size_t>(begin - axis.begin());
        window.end = std::max(window.first, static_cast<std::size_t>(end - axis.begin()));
    }

    static constexpr std::size_t most_windows = 8;
    InputTable const& table_;
    RigCurve const& rig_;
    OptionValues given_;
    double axis_ratio_ = 1, value_ratio_ = 1; //!< of the units in the file to those of the simulated curve
};

} // namespace

std::vector<RigCurve> curves_of(rig::RigInfo const& rig, BaseInput const& base)
{
    std::vector<RigCurve> curves;
    if (!rig.describe)
        return curves;
    auto const programme =
        rig.describe(make_run_input(base, {}, static_cast<int>(base.experiments.size()) - 1, 1));
    for (auto const& reading : programme.readings)
        curves.push_back({reading.name, "s", reading.units, false});
    for (auto const& profile : programme.profiles)
        curves.push_back({profile.name, profile.axis.units, profile.value.units, true});
    return curves;
}

std::vector<std::string> read_curve_target(InputTable const& table, RigCurve const& curve,
                                           FileSource const& source, rig::Files& files,
                                           Experiment& experiment)
{
    CurveReader reader(table, curve);
    CurveTarget target = reader.read(source, files);
    auto const responses = responses_of(target, curve.axis_units, curve.units);
    double weights = 0;
    for (auto const& window : target.windows)
        weights += window.weight;
    double const scale = table.has("scale") ? reader.of_values("scale") : target.sd;
    for (std::size_t k = 0; k < responses.size(); ++k) {
        for (auto const& other : experiment.responses)
            if (other.name == responses[k].name)
                throw table.error(fmt::format(
                    "its window would be called {}, as another response is; name the windows", other.name));
        if (k < target.windows.size()) {
            auto const& window = target.windows[k];
            // All windows together count as one target, their mean square deviation in scales.
            experiment.targets.push_back({.response = responses[k].name,
                                          .response_index = static_cast<int>(experiment.responses.size()),
                                          .value = window.measured,
                                          .scale = scale * std::sqrt(weights / window.weight),
                                          .sd = target.sd / std::sqrt(window.effective),
                                          .tolerance = reader.of_values("tolerance"),
                                          .comes_of = TargetSource::curve});
        }
        experiment.responses.push_back(responses[k]);
    }
    auto const said = fmt::format("experiment.{}: target.{}: {} points, of which {:.0f} scatter by "
                                  "themselves; sd {:.3g} {} a point{}; {} window{}",
                                  experiment.name, target.name, target.curve.size(), target.effective,
                                  target.sd, curve.units, table.has("sd") ? "" : ", seen in their scatter",
                                  target.windows.size(), target.windows.size() == 1 ? "" : "s");
    experiment.curves.push_back(std::move(target));
    return {said};
}

} // namespace demens::ensemble::input
