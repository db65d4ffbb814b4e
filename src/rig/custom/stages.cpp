#include "src/rig/custom/stages.hpp"

#include "demens/base/error.hpp"
#include "src/rig/option_specs.hpp"

#include <cmath>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

using Kind = Condition::Kind;

constexpr std::array<Word<Kind>, 5> kinds = {{{Kind::time, "time"},
                                              {Kind::kinetic_energy, "kinetic_energy"},
                                              {Kind::speed, "speed"},
                                              {Kind::count, "count"},
                                              {Kind::mass, "mass"}}};
constexpr std::array<Word<Overrun>, 2> overruns = {{{Overrun::fail, "fail"}, {Overrun::go_on, "go_on"}}};

//! Keys of a stage that hold the limits of its condition.
struct LimitKeys
{
    std::string below, above; //!< empty: the condition has no such limit
};

LimitKeys limit_keys(Kind kind)
{
    switch (kind) {
    case Kind::time:
        return {};
    case Kind::kinetic_energy:
        return {"below_j", ""};
    case Kind::speed:
        return {"below_m_s", ""};
    case Kind::count:
        return {"below", "above"};
    case Kind::mass:
        return {"below_kg", "above_kg"};
    }
    return {};
}

Condition read_condition(OptionValues const& o, OptionValues const& experiment, Regions const& regions)
{
    Condition condition{read_word(kinds, o.text("until")), {}, not_given, not_given};
    auto const [below, above] = limit_keys(condition.kind);
    if (!below.empty())
        condition.below = o.number(below);
    if (!above.empty()) {
        condition.above = o.number(above);
        condition.selection = read_selection(o, experiment, regions);
        if (std::isnan(condition.below) == std::isnan(condition.above))
            throw InputError(
                fmt::format("until = \"{}\" needs either {} or {}", o.text("until"), below, above));
    }
    return condition;
}

} // namespace

TableSpec stage_table()
{
    auto const region = entry("region", "region", "where it is counted; empty: everywhere");
    auto const of = entry("of", "particles", "group that is counted; empty: all");
    auto const walls = [](std::string key, std::string doc) {
        return OptionSpec{.key = std::move(key),
                          .default_value = std::vector<std::string>{},
                          .doc = std::move(doc),
                          .names_entry_of = "wall"};
    };
    return {.key = "stage",
            .doc = "what happens one after another",
            .options = {required_word("name", "its name"),
                        required(number("duration_s", 0,
                                        "how long it takes, or may take until its condition holds [s]",
                                        positive)),
                        number("at_least_s", 0, "its condition is not asked before [s]", 0),
                        choice("at_longest", texts_of(overruns),
                               "what becomes of the run when the condition does not hold within duration_s"),
                        walls("walls_on", "walls that are there from its beginning on"),
                        walls("walls_off", "walls that are not there from its beginning on")},
            .kind_key = "until",
            .default_kind = "time",
            .kinds = {{"time", "it takes duration_s", {}},
                      {"kinetic_energy",
                       "until the particles rest",
                       {required(number("below_j", 0, "mean kinetic energy of a particle [J]", positive))}},
                      {"speed",
                       "until nothing is faster",
                       {required(number("below_m_s", 0, "largest speed [m/s]", positive))}},
                      {"count",
                       "until a number of particles is reached",
                       {region, of, number("below", not_given, "fewer than this", 0),
                        number("above", not_given, "more than this", 0)}},
                      {"mass",
                       "until a mass is reached",
                       {region, of, number("below_kg", not_given, "less than this [kg]", 0),
                        number("above_kg", not_given, "more than this [kg]", 0)}}}};
}

std::vector<StagePlan> read_stages(OptionValues const& experiment, Regions const& regions)
{
    std::vector<StagePlan> stages;
    for (auto const& o : experiment.tables("stage")) {
        try {
            stages.push_back({o.text("name"), o.number("duration_s"), o.number("at_least_s"),
                              read_word(overruns, o.text("at_longest")),
                              read_condition(o, experiment, regions), o.words("walls_on"),
                              o.words("walls_off")});
        } catch (InputError const& error) {
            throw InputError(fmt::format("stage.{}: {}", o.text("name"), error.what()));
        }
    }
    if (stages.empty())
        throw InputError("there is no stage; give at least one table [[experiment.stage]]");
    return stages;
}

Stage make_stage(StagePlan const& plan)
{
    Stage stage{.name = plan.name, .overrun = plan.overrun, .looks_per_sample = 1, .landmark = plan.name};
    if (plan.condition.kind == Kind::time) {
        stage.shortest = plan.duration;
        return stage;
    }
    stage.until = [condition = plan.condition](Look& look) { return condition.holds(look); };
    stage.waits_for = fmt::format("its condition on {} does not hold", word_for(kinds, plan.condition.kind));
    stage.shortest = plan.shortest;
    stage.longest = plan.duration;
    return stage;
}

bool Condition::holds(Look& look) const
{
    auto& simulation = look.simulation();
    double value = not_given;
    switch (kind) {
    case Kind::time:
        return false;
    case Kind::kinetic_energy:
        value = simulation.kinetic_energy() /
                std::max<double>(1, static_cast<double>(simulation.counts().particles));
        break;
    case Kind::speed:
        value = simulation.largest_speed();
        break;
    case Kind::count:
        value = custom::count(look, selection);
        break;
    case Kind::mass:
        value = custom::mass(look, selection);
        break;
    }
    return value < below || value > above;
}

} // namespace demens::rig::custom
