#include "src/rig/custom/outlets.hpp"

#include "src/rig/custom/setup.hpp"
#include "src/rig/kinds.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

// Notes of the run's progress, which a state record keeps.
std::string count_of(OutletPlan const& outlet)
{
    return fmt::format("outlet/{}/count", outlet.name);
}
std::string mass_of(OutletPlan const& outlet)
{
    return fmt::format("outlet/{}/mass", outlet.name);
}

double noted(Progress const& progress, std::string const& name)
{
    auto const found = progress.notes.find(name);
    return found == progress.notes.end() ? 0 : found->second;
}

bool is_open(OutletPlan const& outlet, std::size_t stage)
{
    return std::find(outlet.stages.begin(), outlet.stages.end(), stage) != outlet.stages.end();
}

} // namespace

TableSpec outlet_table()
{
    return {.key = "outlet",
            .doc = "a region in which grains leave the experiment",
            .options = {
                required_word("name", "its name"),
                required(entry("region", "region", "grains whose centres of mass are in it leave, whole")),
                entry("of", "particles", "group that leaves; empty: all"),
                entries("stages", "stage", "in which it is open; none: all of them")}};
}

std::vector<OutletPlan> read_outlets(OptionValues const& experiment, Regions const& regions)
{
    std::vector<OutletPlan> outlets;
    auto const& stages = experiment.tables("stage");
    for (auto const& o : experiment.tables("outlet")) {
        OutletPlan outlet{o.text("name"), read_selection(o, experiment, regions), {}};
        auto const& open_in = o.words("stages");
        for (std::size_t k = 0; k < stages.size(); ++k)
            if (open_in.empty() ||
                std::find(open_in.begin(), open_in.end(), stages[k].text("name")) != open_in.end())
                outlet.stages.push_back(k);
        outlets.push_back(std::move(outlet));
    }
    return outlets;
}

bool is_open(Setup const& setup, std::size_t stage)
{
    return std::any_of(setup.outlets.begin(), setup.outlets.end(),
                       [stage](auto const& outlet) { return is_open(outlet, stage); });
}

void let_out(Bench& bench, Setup const& setup, std::size_t stage)
{
    Look look(bench);
    auto const& all = look.grains();
    std::vector<std::size_t> order(all.size()); // of ids, so that sums depend on nothing else
    for (std::size_t k = 0; k < order.size(); ++k)
        order[k] = k;
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return all.id(a).value < all.id(b).value; });
    std::vector<dem::ParticleId> leaving;
    auto& notes = bench.progress.notes;
    for (std::size_t const k : order) {
        auto const outlet = std::find_if(setup.outlets.begin(), setup.outlets.end(), [&](auto const& one) {
            return is_open(one, stage) && one.selection.contains(look, all, k);
        });
        if (outlet == setup.outlets.end())
            continue;
        notes[count_of(*outlet)] += 1;
        notes[mass_of(*outlet)] += all.mass(k);
        leaving.push_back(all.id(k));
    }
    if (!leaving.empty())
        bench.simulation.remove(leaving);
}

Removed removed_through(Progress const& progress, Setup const& setup, std::string const& name)
{
    Removed sum;
    for (auto const& outlet : setup.outlets)
        if (name.empty() || outlet.name == name) {
            sum.count += noted(progress, count_of(outlet));
            sum.mass += noted(progress, mass_of(outlet));
        }
    return sum;
}

} // namespace demens::rig::custom
