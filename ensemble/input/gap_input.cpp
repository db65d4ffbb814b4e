#include "ensemble/input/gap_input.hpp"

#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/option_defaults.hpp"
#include "ensemble/input/section.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

//! Gives the experiments that a key names another role than to be fitted.
void give_role(InputTable const& table, char const* key, ExperimentRole role,
               std::vector<Experiment>& experiments)
{
    std::vector<std::string> names;
    for (auto const& experiment : experiments)
        names.push_back(experiment.name);
    for (auto const& name : table.words(key)) {
        auto const found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
            throw table.error(
                key, fmt::format("there is no experiment \"{}\"; {}", name, suggestion(name, names)));
        auto& experiment = experiments[static_cast<std::size_t>(found - names.begin())];
        if (experiment.role != ExperimentRole::calibrate)
            throw table.error(key, fmt::format("\"{}\" has a role already; name it once", name));
        if (experiment.targets.empty())
            throw table.error(key, fmt::format("the experiment \"{}\" has no target, so that nothing can be "
                                               "compared on it; give target.RESPONSE = ...",
                                               name));
        experiment.role = role;
        experiment.held_out.swap(experiment.targets);
    }
}

std::map<std::string, double> amplitudes_of(InputTable const& table)
{
    std::map<std::string, double> amplitudes;
    for (auto const& effect : table.keys())
        amplitudes[effect] = std::get<double>(table.read_option(
            {.key = effect, .default_value = 1.0, .doc = "typical amplitude", .lower = positive}));
    return amplitudes;
}

//! Only of an experiment that is considered a value may be missing.
void require_values(InputTable const& file, std::vector<Experiment> const& experiments)
{
    for (auto const& experiment : experiments)
        for (auto const* targets : {&experiment.targets, &experiment.held_out})
            for (auto const& target : *targets)
                if (std::isnan(target.value) && experiment.role != ExperimentRole::consider)
                    throw file.error(
                        fmt::format("experiment.{}.target.{}: the key \"value\" is missing; give value = "
                                    "... (measured value, in the response's unit)",
                                    experiment.name, target.response));
}

} // namespace

std::optional<GapOptions> read_gap(InputTable const& file, std::vector<Experiment>& experiments)
{
    if (!file.has("gap")) {
        require_values(file, experiments);
        return std::nullopt;
    }
    auto const table = file.table("gap");
    GapOptions gap;
    assign(gap, table.read(specs_of<GapOptions>(), keys_of(gap_lists())));
    gap.held_out = table.words("held_out");
    gap.effects = table.words("effects");
    gap.candidates = table.words("candidates");
    gap.typical = amplitudes_of(table.table("typical"));
    give_role(table, "held_out", ExperimentRole::hold_out, experiments);
    give_role(table, "candidates", ExperimentRole::consider, experiments);
    if (std::none_of(experiments.begin(), experiments.end(),
                     [](auto const& e) { return e.role == ExperimentRole::calibrate; }))
        throw table.error(table.has("held_out") ? "held_out" : "candidates",
                          "names every experiment, so that none is left to calibrate on");
    if (!gap.diagnose)
        for (auto const* key : {"effects", "candidates", "typical"})
            if (table.has(key))
                throw table.error(key, "belongs to a diagnosis, and there is none with diagnose = false");
    if (!gap.diagnose && gap.held_out.empty())
        throw table.error("diagnose", "is false, and no experiment is held out, so that [gap] would do "
                                      "nothing; name one or more in held_out");
    for (auto const& name : gap.effects)
        if (std::count(gap.effects.begin(), gap.effects.end(), name) > 1)
            throw table.error("effects", fmt::format("names \"{}\" twice", name));
    require_values(file, experiments);
    return gap;
}

} // namespace demens::ensemble::input
