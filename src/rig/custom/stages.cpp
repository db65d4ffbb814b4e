#include "src/rig/custom/stages.hpp"

#include "demens/base/error.hpp"
#include "src/rig/kinds.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

constexpr std::array<Word<Overrun>, 2> overruns = {{{Overrun::fail, "fail"}, {Overrun::go_on, "go_on"}}};

std::vector<ConditionKind> make_conditions()
{
    auto const region = entry("region", "region", "where it is counted; empty: everywhere");
    auto const of = entry("of", "particles", "group that is counted; empty: all");
    return {{{"time", "it takes duration_s", {}}},
            {{"kinetic_energy",
              "until the particles rest",
              {required(number("below_j", 0, "mean kinetic energy of a particle [J]", positive))}},
             "below_j",
             "",
             [](Look& look, Selection const&) {
                 auto const particles = static_cast<double>(look.simulation().counts().particles);
                 return look.simulation().kinetic_energy() / std::max(1.0, particles);
             }},
            {{"speed",
              "until nothing is faster",
              {required(number("below_m_s", 0, "largest speed [m/s]", positive))}},
             "below_m_s",
             "",
             [](Look& look, Selection const&) { return look.simulation().largest_speed(); }},
            {{"count",
              "until a number of particles is reached",
              {region, of, number("below", not_given, "fewer than this", 0),
               number("above", not_given, "more than this", 0)}},
             "below",
             "above",
             count},
            {{"mass",
              "until a mass is reached",
              {region, of, number("below_kg", not_given, "less than this [kg]", 0),
               number("above_kg", not_given, "more than this [kg]", 0)}},
             "below_kg",
             "above_kg",
             mass}};
}

std::vector<ConditionKind> const& conditions()
{
    static auto const all = make_conditions();
    return all;
}

Condition read_condition(OptionValues const& o, OptionValues const& experiment, Regions const& regions)
{
    auto const& kind = kind_named(conditions(), o.text("until"));
    Condition condition{&kind, {}, not_given, not_given};
    if (!kind.below.empty())
        condition.below = o.number(kind.below);
    if (!kind.above.empty()) {
        condition.above = o.number(kind.above);
        condition.selection = read_selection(o, experiment, regions);
        if (std::isnan(condition.below) == std::isnan(condition.above))
            throw InputError(
                fmt::format("until = \"{}\" needs either {} or {}", kind.keys.name, kind.below, kind.above));
    }
    return condition;
}

} // namespace

TableSpec stage_table()
{
    return {.key = "stage",
            .doc = "what happens one after another",
            .options = {required_word("name", "its name"),
                        required(number("duration_s", 0,
                                        "how long it takes, or may take until its condition holds [s]",
                                        positive)),
                        number("at_least_s", 0, "its condition is not asked before [s]", 0),
                        choice("at_longest", texts_of(overruns),
                               "what becomes of the run when the condition does not hold within duration_s"),
                        entries("walls_on", "wall", "walls that are there from its beginning on"),
                        entries("walls_off", "wall", "walls that are not there from its beginning on")},
            .kind_key = "until",
            .default_kind = "time",
            .kinds = keys_of(conditions())};
}

std::vector<StagePlan> read_stages(OptionValues const& experiment, Regions const& regions)
{
    std::vector<StagePlan> stages;
    for (auto const& o : experiment.tables("stage"))
        stages.push_back(in_place("stage." + o.text("name"), [&] {
            return StagePlan{o.text("name"),
                             o.number("duration_s"),
                             o.number("at_least_s"),
                             read_word(overruns, o.text("at_longest")),
                             read_condition(o, experiment, regions),
                             o.words("walls_on"),
                             o.words("walls_off")};
        }));
    if (stages.empty())
        throw InputError("there is no stage; give at least one table [[experiment.stage]]");
    return stages;
}

Stage make_stage(StagePlan const& plan)
{
    Stage stage{.name = plan.name, .overrun = plan.overrun, .looks_per_sample = 1, .landmark = plan.name};
    if (plan.condition.kind->read == nullptr) {
        stage.shortest = plan.duration;
        return stage;
    }
    stage.until = [condition = plan.condition](Look& look) { return condition.holds(look); };
    stage.waits_for = fmt::format("its condition on {} does not hold", plan.condition.kind->keys.name);
    stage.shortest = plan.shortest;
    stage.longest = plan.duration;
    return stage;
}

bool Condition::holds(Look& look) const
{
    double const value = kind->read(look, selection);
    return value < below || value > above;
}

} // namespace demens::rig::custom
