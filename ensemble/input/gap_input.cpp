#include "ensemble/input/gap_input.hpp"

#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/section.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

void hold_out(InputTable const& table, std::string const& name, std::vector<Experiment>& experiments)
{
    std::vector<std::string> names;
    for (auto const& experiment : experiments)
        names.push_back(experiment.name);
    auto const found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw table.error("held_out",
                          fmt::format("there is no experiment \"{}\"; {}", name, suggestion(name, names)));
    auto& experiment = experiments[static_cast<std::size_t>(found - names.begin())];
    if (experiment.role == ExperimentRole::hold_out)
        throw table.error("held_out", fmt::format("names \"{}\" twice", name));
    if (experiment.targets.empty())
        throw table.error("held_out", fmt::format("the experiment \"{}\" has no target, so that nothing can "
                                                  "be tested on it; give target.RESPONSE = ...",
                                                  name));
    experiment.role = ExperimentRole::hold_out;
    experiment.held_out.swap(experiment.targets);
}

} // namespace

GapOptions read_gap(InputTable const& table, std::vector<Experiment>& experiments)
{
    GapOptions gap;
    assign(gap, table.read(specs_of<GapOptions>(), keys_of(gap_lists())));
    gap.held_out = table.words("held_out");
    gap.effects = table.words("effects");
    for (auto const& name : gap.held_out)
        hold_out(table, name, experiments);
    if (std::all_of(experiments.begin(), experiments.end(),
                    [](auto const& e) { return e.role == ExperimentRole::hold_out; }))
        throw table.error("held_out", "holds every experiment out, so that none is left to calibrate on");
    for (auto const& name : gap.effects)
        if (std::count(gap.effects.begin(), gap.effects.end(), name) > 1)
            throw table.error("effects", fmt::format("names \"{}\" twice", name));
    return gap;
}

} // namespace demens::ensemble::input
