// What may be asked of a run: keys of its responses, their names and units.
#include "src/rig/custom/responses.hpp"

#include "demens/base/error.hpp"
#include "src/rig/custom/upright.hpp"
#include "src/rig/option_specs.hpp"

#include <cmath>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

constexpr std::array<Word<Take>, 9> takes = {{{Take::final, "final"},
                                              {Take::mean, "mean"},
                                              {Take::sd, "sd"},
                                              {Take::min, "min"},
                                              {Take::max, "max"},
                                              {Take::change, "change"},
                                              {Take::rate, "rate"},
                                              {Take::time_above, "time_above"},
                                              {Take::time_below, "time_below"}}};
constexpr std::array<Word<Component>, 4> components = {
    {{Component::x, "x"}, {Component::y, "y"}, {Component::z, "z"}, {Component::magnitude, "magnitude"}}};

//! What can be read off, and the keys that it needs.
struct QuantityInfo
{
    Quantity quantity;
    std::string name, units, doc;
    std::vector<OptionSpec> options;
};

std::vector<std::string> ledger_terms()
{
    std::vector<std::string> terms;
    for (auto const& entry : dem::energy_entries)
        terms.emplace_back(entry.name);
    return terms;
}

std::vector<QuantityInfo> make_quantities()
{
    auto const region = entry("region", "region", "where; empty: everywhere");
    auto const of = entry("of", "particles", "group; empty: all particles");
    auto const body = required(entry("of", "particles", "group of one body"));
    auto const no_region = entry("region", "region", "only while it is there; empty: everywhere");
    auto const component = choice("axis", {"z", "x", "y"}, "component");
    auto const load = choice("axis", {"magnitude", "x", "y", "z"}, "component, or magnitude");
    auto const wall = required(entry("wall", "wall", "which wall"));
    auto const about = vector("about_mm", {not_given, not_given, not_given},
                              "point about which it is counted, e.g. of a shaft, fixed in space; none: the "
                              "centre of the wall's first part, which moves with it [mm]");
    auto const along =
        choice("axis", {"x", "y", "z"}, "axis along which the profile is seen, as far as it is horizontal");
    auto const column = required(
        number("cell_mm", 0, "width of the columns of which the highest points count [mm]", positive));
    std::vector<QuantityInfo> all;
    auto const add = [&](Quantity quantity, std::string name, std::string units, std::string doc,
                         std::vector<OptionSpec> options) {
        all.push_back({quantity, std::move(name), std::move(units), std::move(doc), std::move(options)});
    };
    add(Quantity::count, "count", "1", "number of particles", {region, of});
    add(Quantity::mass, "mass", "kg", "mass of particles", {region, of});
    add(Quantity::centre_of_mass, "centre_of_mass", "m", "centre of mass of particles",
        {region, of, component});
    add(Quantity::position, "position", "m", "place of a body's centre", {body, no_region, component});
    add(Quantity::velocity, "velocity", "m/s", "velocity of a body's centre", {body, no_region, component});
    add(Quantity::speed, "speed", "m/s", "speed of a body's centre", {body, no_region});
    add(Quantity::penetration, "penetration", "m",
        "how deep a body's lowest point is below the level at which it entered", {body, no_region});
    add(Quantity::kinetic_energy, "kinetic_energy", "J",
        "kinetic energy of particles, translation and rotation", {region, of});
    add(Quantity::potential_energy, "potential_energy", "J", "potential energy of particles above the origin",
        {region, of});
    add(Quantity::energy, "energy", "J", "a term of the energy ledger",
        {required(choice("term", ledger_terms(), "which; since the start for what was lost or brought in"))});
    add(Quantity::wall_force, "wall_force", "N", "force of the particles on a wall", {wall, load});
    add(Quantity::wall_torque, "wall_torque", "N m", "torque of the particles on a wall",
        {wall, load, about});
    add(Quantity::surface_height, "surface_height", "m", "mean height of the upper surface of particles",
        {region, of, column});
    add(Quantity::profile_angle, "profile_angle", "deg", "slope of the upper surface of particles",
        {region, of, along, column});
    add(Quantity::segregation, "segregation", "1", "intensity of segregation of a group (Danckwerts 1952)",
        {region, required(entry("of", "particles", "group whose share of the mass is looked at")),
         required(number("cell_mm", 0, "side of the cubes in which the share is taken [mm]", positive))});
    return all;
}

QuantityInfo const& quantity_of(OptionValues const& o)
{
    static std::vector<QuantityInfo> const all = make_quantities();
    for (auto const& info : all)
        if (info.name == o.text("quantity"))
            return info;
    throw InputError("\"" + o.text("quantity") + "\" is no quantity");
}

bool is_threshold(Take take)
{
    return take == Take::time_above || take == Take::time_below;
}

std::string units_of(OptionValues const& o)
{
    auto const& units = quantity_of(o).units;
    auto const take = read_word(takes, o.text("take"));
    if (is_threshold(take))
        return "s";
    return take == Take::rate ? (units == "1" ? "1/s" : units + "/s") : units;
}

std::string doc_of(OptionValues const& o)
{
    auto text = quantity_of(o).doc;
    for (char const* key : {"of", "region", "wall"})
        if (o.has(key) && !o.text(key).empty())
            text += fmt::format(", {} {}", key, o.text(key));
    for (char const* key : {"axis", "term"})
        if (o.has(key))
            text += fmt::format(", {}", o.text(key));
    auto const& stage = o.text("stage");
    return text + fmt::format("; {}{}", o.text("take"), stage.empty() ? "" : " of stage " + stage);
}

double dem::EnergyLedger::*term_of(OptionValues const& o)
{
    for (auto const& entry : dem::energy_entries)
        if (o.has("term") && o.text("term") == entry.name)
            return entry.value;
    return nullptr;
}

bool is_of_one_body(Quantity quantity)
{
    return quantity == Quantity::position || quantity == Quantity::velocity || quantity == Quantity::speed ||
           quantity == Quantity::penetration;
}

//! What cannot be read off the particles that the response looks at.
void check_body(ResponsePlan const& response, OptionValues const& o, std::vector<ParticleGroup> const& groups)
{
    auto const& name = quantity_of(o).name;
    auto const& group = groups[*response.selection.group];
    if (!group.is_one_body())
        throw InputError(fmt::format("\"{}\" is the {} of one body, but the group {} has several; "
                                     "centre_of_mass follows a group",
                                     name, name, o.text("of")));
    if (response.quantity == Quantity::penetration && !std::holds_alternative<AboveOthers>(group.source))
        throw InputError(fmt::format(
            "penetration needs a body that enters above the others: give {} a clearance_mm", o.text("of")));
}

void check_axis(ResponsePlan const& response, Vector3 const& gravity)
{
    if (!Upright::has_horizontal_part(gravity, unit_vector(response.component)))
        throw InputError(fmt::format("axis = \"{}\" is along gravity, but a profile is seen along a "
                                     "horizontal axis; give another one",
                                     word_for(components, response.component)));
}

ResponsePlan read_response(OptionValues const& o, OptionValues const& experiment, Regions const& regions,
                           std::vector<ParticleGroup> const& groups)
{
    auto const& stages = experiment.tables("stage");
    auto const& info = quantity_of(o);
    ResponsePlan response{
        .name = o.text("name"),
        .quantity = info.quantity,
        .selection = o.has("of") ? read_selection(o, experiment, regions) : Selection{},
        .component = o.has("axis") ? read_word(components, o.text("axis")) : Component::magnitude,
        .term = term_of(o),
        .wall = o.has("wall") ? position_of(experiment.tables("wall"), o.text("wall"), 0) : 0,
        .about = {},
        .cell = o.has("cell_mm") ? 1e-3 * o.number("cell_mm") : 0,
        .stage = position_of(stages, o.text("stage"), stages.size() - 1),
        .take = read_word(takes, o.text("take")),
        .threshold = o.number("threshold")};
    if (o.has("about_mm") && !is_absent(o.vector("about_mm")))
        response.about = 1e-3 * o.vector("about_mm");
    if (response.name == "time")
        throw InputError("\"time\" is the name of the series' first column; give it another name");
    if (is_of_one_body(response.quantity))
        check_body(response, o, groups);
    if (response.quantity == Quantity::profile_angle)
        check_axis(response, experiment.vector("gravity_m_s2"));
    if (is_threshold(response.take) == std::isnan(response.threshold))
        throw InputError(
            is_threshold(response.take)
                ? fmt::format("take = \"{}\" needs a threshold", o.text("take"))
                : fmt::format("threshold is not used by take = \"{}\"; leave it out", o.text("take")));
    return response;
}

} // namespace

bool reads_loads(Quantity quantity)
{
    return quantity == Quantity::wall_force || quantity == Quantity::wall_torque ||
           quantity == Quantity::energy;
}

TableSpec response_table()
{
    std::vector<TableKind> kinds;
    for (auto const& info : make_quantities())
        kinds.push_back({info.name, fmt::format("{} [{}]", info.doc, info.units), info.options});
    return {
        .key = "response",
        .doc = "what is read off again and again, and the one number that is made of it",
        .options =
            {required_word("name", "its name, for targets; it should carry the unit"),
             entry("stage", "stage", "over which stage; empty: the last one"),
             choice("take", texts_of(takes),
                    "what is made of its course: its last value, mean, standard deviation, smallest or "
                    "largest value, last less first, slope of the line through it [1/s], or the time from "
                    "the beginning of the stage until it is above or below the threshold [s]"),
             number("threshold", not_given, "in the unit of the quantity")},
        .kind_key = "quantity",
        .kinds = std::move(kinds)};
}

std::vector<ResponseInfo> asked_responses(OptionValues const& experiment)
{
    std::vector<ResponseInfo> infos;
    for (auto const& o : experiment.tables("response"))
        infos.push_back({o.text("name"), units_of(o), doc_of(o)});
    return infos;
}

std::vector<ResponsePlan> read_responses(OptionValues const& experiment, Regions const& regions,
                                         std::vector<ParticleGroup> const& groups)
{
    std::vector<ResponsePlan> responses;
    for (auto const& o : experiment.tables("response")) {
        try {
            responses.push_back(read_response(o, experiment, regions, groups));
            responses.back().units = quantity_of(o).units;
            responses.back().doc = quantity_of(o).doc;
        } catch (InputError const& error) {
            throw InputError(fmt::format("response.{}: {}", o.text("name"), error.what()));
        }
    }
    if (responses.empty())
        throw InputError("nothing is measured; give at least one table [[experiment.response]]");
    return responses;
}

} // namespace demens::rig::custom
