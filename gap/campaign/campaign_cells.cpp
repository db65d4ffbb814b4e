#include "gap/campaign/campaign_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace demens::gap {
namespace {

using ensemble::CampaignInput, ensemble::Experiment, ensemble::Target, ensemble::TargetSource;

//! The curve or picture that a window belongs to; of another target the response itself.
std::string family_of(Experiment const& experiment, Target const& target)
{
    if (target.comes_of == TargetSource::picture)
        return "picture";
    if (target.comes_of == TargetSource::curve)
        for (auto const& curve : experiment.curves)
            if (window_of(curve, target.response))
                return curve.name;
    return target.response;
}

//! Numbers that differ between experiments of one rig, each from 0 to 1.
class Conditions
{
  public:
    explicit Conditions(CampaignInput const& input) : input_(input)
    {
        for (auto const& experiment : input.experiments)
            for (auto const& option : experiment.rig->options)
                if (auto const value = number(experiment, option)) {
                    auto const key = experiment.rig->name + "." + option.key;
                    auto const [range, is_new] = ranges_.try_emplace(key, *value, *value);
                    if (!is_new) {
                        range->second.first = std::min(range->second.first, *value);
                        range->second.second = std::max(range->second.second, *value);
                    }
                }
    }

    //! As many for each experiment, whatever its rig; 0 for numbers that only other rigs have.
    std::vector<double> of(Experiment const& experiment) const
    {
        std::map<std::string, double> own;
        for (auto const& option : experiment.rig->options)
            if (auto const value = number(experiment, option))
                own[experiment.rig->name + "." + option.key] = *value;
        std::vector<double> coordinates;
        for (auto const& [key, range] : ranges_) {
            auto const [least, most] = range;
            auto const value = own.find(key);
            if (most > least)
                coordinates.push_back(value == own.end() ? 0 : (value->second - least) / (most - least));
        }
        return coordinates;
    }

  private:
    std::optional<double> number(Experiment const& experiment, OptionSpec const& option) const
    {
        auto const value = input_.base_value("experiment." + experiment.name + "." + option.key);
        auto const* number = value ? std::get_if<double>(&*value) : nullptr;
        return number && std::isfinite(*number) ? std::optional(*number) : std::nullopt;
    }

    CampaignInput const& input_;
    std::map<std::string, std::pair<double, double>> ranges_; //!< by rig and key
};

} // namespace

std::vector<Target> const& targets_of(Experiment const& experiment)
{
    return experiment.role == ensemble::ExperimentRole::calibrate ? experiment.targets : experiment.held_out;
}

Eigen::VectorXd measured_change(MeasuredChange change, std::vector<CampaignCell> const& cells,
                                Eigen::VectorXd const& values)
{
    Eigen::VectorXd changes(values.size());
    for (Eigen::Index i = 0; i < changes.size(); ++i) {
        auto shown = cells[static_cast<std::size_t>(i)].shown;
        shown.value = values[i];
        changes[i] = change(shown);
    }
    return changes;
}

std::vector<std::string> notes_on(std::vector<CampaignCell> const& cells)
{
    std::string names;
    for (auto const& cell : cells)
        if (!cell.sd_given)
            names += (names.empty() ? "" : ", ") + cell.cell.name;
    if (names.empty())
        return {};
    return {"no sd is given for " + names +
            "; the scale of the target stands for it, and what is said of them is as good as that"};
}

std::vector<CampaignCell> cells_of(CampaignInput const& input, ensemble::ExperimentRole role)
{
    Conditions const conditions(input);
    std::map<std::string, int> families;                   // by rig and name, over all roles
    std::map<std::string, std::pair<double, int>> squares; // of the targets of a curve or picture
    for (auto const& experiment : input.experiments)
        for (auto const& target : targets_of(experiment)) {
            auto const family = experiment.rig->name + "." + family_of(experiment, target);
            families.try_emplace(family, static_cast<int>(families.size()));
            auto& [sum, count] = squares[family + "@" + experiment.name];
            sum += target.value * target.value;
            ++count;
        }
    std::vector<CampaignCell> cells;
    for (std::size_t e = 0; e < input.experiments.size(); ++e) {
        auto const& experiment = input.experiments[e];
        if (experiment.role != role)
            continue;
        auto const condition = conditions.of(experiment);
        std::map<std::string, int> windows;
        auto const responses = measured_responses(experiment, targets_of(experiment));
        auto shown = responses.begin();
        for (auto const& target : targets_of(experiment)) {
            auto const family = experiment.rig->name + "." + family_of(experiment, target);
            auto const [sum, count] = squares[family + "@" + experiment.name];
            CampaignCell cell{{.name = experiment.name + "." + target.response,
                               .experiment = static_cast<int>(e),
                               .response_family = families[family],
                               .condition = condition,
                               .scale = std::sqrt(sum / count)},
                              &target,
                              *shown++,
                              std::isnan(target.sd) ? target.scale : target.sd,
                              !std::isnan(target.sd)};
            // windows of one curve stand beside each other, as conditions do
            cell.cell.condition.push_back(count > 1 ? windows[family]++ / (count - 1.0) : 0);
            if (!(cell.cell.scale > 0))
                cell.cell.scale = target.scale;
            cells.push_back(std::move(cell));
        }
    }
    return cells;
}

} // namespace demens::gap
