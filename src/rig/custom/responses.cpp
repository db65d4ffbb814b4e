#include "src/rig/custom/responses.hpp"

#include "demens/base/error.hpp"
#include "demens/observe/surface.hpp"
#include "src/rig/custom/specs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

struct Quantity
{
    std::string units, doc;
};

//! What can be read off, and the keys that it needs.
std::map<std::string, Quantity> const& quantities()
{
    static std::map<std::string, Quantity> const all = {
        {"count", {"1", "number of particles"}},
        {"mass", {"kg", "mass of particles"}},
        {"centre_of_mass", {"m", "centre of mass of particles"}},
        {"position", {"m", "place of a body's centre"}},
        {"velocity", {"m/s", "velocity of a body's centre"}},
        {"speed", {"m/s", "speed of a body's centre"}},
        {"penetration", {"m", "how deep a body's lowest point is below the level at which it entered"}},
        {"kinetic_energy", {"J", "kinetic energy of particles, translation and rotation"}},
        {"potential_energy", {"J", "potential energy of particles above the origin"}},
        {"energy", {"J", "a term of the energy ledger"}},
        {"wall_force", {"N", "force of the particles on a wall"}},
        {"wall_torque", {"N m", "torque of the particles on a wall about its centre"}},
        {"surface_height", {"m", "mean height of the upper surface of particles"}},
        {"profile_angle", {"deg", "slope of the upper surface of particles"}},
        {"segregation", {"1", "intensity of segregation of a group (Danckwerts 1952)"}},
    };
    return all;
}

std::string units_of(OptionValues const& o)
{
    auto const& units = quantities().at(o.text("quantity")).units;
    auto const& take = o.text("take");
    if (take == "time_above" || take == "time_below")
        return "s";
    return take == "rate" ? (units == "1" ? "1/s" : units + "/s") : units;
}

std::string doc_of(OptionValues const& o)
{
    auto text = quantities().at(o.text("quantity")).doc;
    for (char const* key : {"of", "region", "wall"})
        if (o.has(key) && !o.text(key).empty())
            text += fmt::format(", {} {}", key, o.text(key));
    for (char const* key : {"axis", "term"})
        if (o.has(key))
            text += fmt::format(", {}", o.text(key));
    auto const& stage = o.text("stage");
    return text + fmt::format("; {}{}", o.text("take"), stage.empty() ? "" : " of stage " + stage);
}

std::vector<std::string> ledger_terms()
{
    std::vector<std::string> terms;
    for (auto const& entry : dem::energy_entries)
        terms.emplace_back(entry.name);
    return terms;
}

bool is_threshold(std::string const& take)
{
    return take == "time_above" || take == "time_below";
}

Response read_response(OptionValues const& o, OptionValues const& experiment, Regions const& regions,
                       std::vector<ParticleGroup> const& groups)
{
    auto const& stages = experiment.tables("stage");
    auto const& walls = experiment.tables("wall");
    auto const position_of = [](std::vector<OptionValues> const& entries, std::string const& name) {
        std::size_t k = 0;
        while (k < entries.size() && entries[k].text("name") != name)
            ++k;
        return k;
    };
    Response response{.name = o.text("name"),
                      .quantity = o.text("quantity"),
                      .selection = o.has("of") ? read_selection(o, experiment, regions) : Selection{},
                      .axis = o.has("axis") ? o.text("axis") : "",
                      .term = o.has("term") ? o.text("term") : "",
                      .wall = o.has("wall") ? position_of(walls, o.text("wall")) : 0,
                      .cell = o.has("cell_mm") ? 1e-3 * o.number("cell_mm") : 0,
                      .stage =
                          o.text("stage").empty() ? stages.size() - 1 : position_of(stages, o.text("stage")),
                      .take = o.text("take"),
                      .threshold = o.number("threshold")};
    bool const of_body = response.quantity == "position" || response.quantity == "velocity" ||
                         response.quantity == "speed" || response.quantity == "penetration";
    if (of_body && !groups[*response.selection.group].is_one_body())
        throw InputError(
            fmt::format("\"{}\" is the {} of one body, but the group {} has several; centre_of_mass "
                        "follows a group",
                        response.quantity, response.quantity, o.text("of")));
    if (response.quantity == "penetration" &&
        !std::holds_alternative<AboveOthers>(groups[*response.selection.group].source))
        throw InputError(fmt::format(
            "penetration needs a body that enters above the others: give {} a clearance_mm", o.text("of")));
    if (is_threshold(response.take) == std::isnan(response.threshold))
        throw InputError(
            is_threshold(response.take)
                ? fmt::format("take = \"{}\" needs a threshold", response.take)
                : fmt::format("threshold is not used by take = \"{}\"; leave it out", response.take));
    return response;
}

} // namespace

TableSpec response_table()
{
    auto const region = entry("region", "region", "where; empty: everywhere");
    auto const of = entry("of", "particles", "group; empty: all particles");
    auto const body = required(entry("of", "particles", "group of one body"));
    auto const no_region = entry("region", "region", "only while it is there; empty: everywhere");
    auto const component = choice("axis", {"z", "x", "y"}, "component");
    auto const load = choice("axis", {"magnitude", "x", "y", "z"}, "component, or magnitude");
    auto const wall = required(entry("wall", "wall", "which wall"));
    auto const along = choice("axis", {"x", "y"}, "horizontal axis along which the profile is seen");
    auto const column = required(
        number("cell_mm", 0, "width of the columns of which the highest points count [mm]", positive));
    auto const doc = [](std::string const& quantity) {
        auto const& [units, text] = quantities().at(quantity);
        return fmt::format("{} [{}]", text, units);
    };
    std::vector<TableKind> kinds;
    auto const add = [&](std::string const& quantity, std::vector<OptionSpec> options) {
        kinds.push_back({quantity, doc(quantity), std::move(options)});
    };
    add("count", {region, of});
    add("mass", {region, of});
    add("centre_of_mass", {region, of, component});
    add("position", {body, no_region, component});
    add("velocity", {body, no_region, component});
    add("speed", {body, no_region});
    add("penetration", {body, no_region});
    add("kinetic_energy", {region, of});
    add("potential_energy", {region, of});
    add("energy",
        {required(choice("term", ledger_terms(), "which; since the start for what was lost or brought in"))});
    add("wall_force", {wall, load});
    add("wall_torque", {wall, load});
    add("surface_height", {region, of, column});
    add("profile_angle", {region, of, along, column});
    add("segregation",
        {region, required(entry("of", "particles", "group whose share of the mass is looked at")),
         required(number("cell_mm", 0, "side of the cubes in which the share is taken [mm]", positive))});
    return {
        .key = "response",
        .doc = "what is read off again and again, and the one number that is made of it",
        .options =
            {required_word("name", "its name, for targets; it should carry the unit"),
             entry("stage", "stage", "over which stage; empty: the last one"),
             choice("take",
                    {"final", "mean", "sd", "min", "max", "change", "rate", "time_above", "time_below"},
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

std::string quantity_units(OptionValues const& table)
{
    return quantities().at(table.text("quantity")).units;
}

std::vector<Response> read_responses(OptionValues const& experiment, Regions const& regions,
                                     std::vector<ParticleGroup> const& groups)
{
    std::vector<Response> responses;
    for (auto const& o : experiment.tables("response")) {
        try {
            responses.push_back(read_response(o, experiment, regions, groups));
        } catch (InputError const& error) {
            throw InputError(fmt::format("response.{}: {}", o.text("name"), error.what()));
        }
    }
    if (responses.empty())
        throw InputError("nothing is measured; give at least one table [[experiment.response]]");
    return responses;
}

double reduce(Response const& response, std::vector<double> const& times, std::vector<double> const& values)
{
    // Moments at which there was nothing to look at do not count.
    std::vector<double> t, v;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (std::isfinite(values[k])) {
            t.push_back(times[k]);
            v.push_back(values[k]);
        }
    if (v.empty())
        return not_given;
    double const n = static_cast<double>(v.size());
    auto const& take = response.take;
    if (take == "final")
        return v.back();
    if (take == "min" || take == "max")
        return take == "min" ? *std::min_element(v.begin(), v.end()) : *std::max_element(v.begin(), v.end());
    if (take == "change")
        return v.back() - v.front();
    if (take == "rate")
        return v.size() < 2 ? not_given : observe::fit_line(t, v).slope;
    if (is_threshold(take)) {
        for (std::size_t k = 0; k < v.size(); ++k)
            if (take == "time_above" ? v[k] > response.threshold : v[k] < response.threshold)
                return t[k] - times.front();
        return not_given;
    }
    double mean = 0, squares = 0;
    for (double const value : v)
        mean += value / n;
    for (double const value : v)
        squares += (value - mean) * (value - mean) / n;
    return take == "mean" ? mean : std::sqrt(squares);
}

} // namespace demens::rig::custom
