// What may be asked of a run: keys of its responses, their names and units.
#include "src/rig/custom/responses.hpp"

#include "demens/base/error.hpp"
#include "src/rig/custom/quantities.hpp"
#include "src/rig/custom/takes.hpp"
#include "src/rig/kinds.hpp"
#include "src/rig/option_specs.hpp"

#include <cmath>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

Quantity const& quantity_of(OptionValues const& o)
{
    return kind_named(quantities(), o.text("quantity"));
}

//! Those of what is looked at; what is made of two other readings has those of the first.
std::string units_of(OptionValues const& o, OptionValues const& experiment)
{
    if (o.has("first"))
        for (auto const& other : experiment.tables("response"))
            if (other.text("name") == o.text("first"))
                return quantity_of(other).units;
    return quantity_of(o).units;
}

std::string doc_of(OptionValues const& o)
{
    auto text = quantity_of(o).keys.doc;
    for (char const* key : {"of", "region", "wall", "outlet", "first", "second"})
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

ResponsePlan read_response(OptionValues const& o, OptionValues const& experiment, Regions const& regions,
                           std::vector<ParticleGroup> const& groups)
{
    auto const& stages = experiment.tables("stage");
    ResponsePlan response{.name = o.text("name"),
                          .units = units_of(o, experiment),
                          .quantity = &quantity_of(o),
                          .selection = o.has("of") ? read_selection(o, experiment, regions) : Selection{},
                          .component = o.has("axis") ? read_component(o.text("axis")) : nullptr,
                          .term = term_of(o),
                          .wall =
                              o.has("wall") ? position_of(experiment.tables("wall"), o.text("wall"), 0) : 0,
                          .about = {},
                          .outlet = o.has("outlet") ? o.text("outlet") : "",
                          .first = o.has("first") ? o.text("first") : "",
                          .second = o.has("second") ? o.text("second") : "",
                          .cell = o.has("cell_mm") ? 1e-3 * o.number("cell_mm") : 0,
                          .stage = position_of(stages, o.text("stage"), stages.size() - 1),
                          .take = &take_named(o.text("take")),
                          .threshold = o.number("threshold")};
    if (o.has("about_mm") && !is_absent(o.vector("about_mm")))
        response.about = 1e-3 * o.vector("about_mm");
    if (response.name == "time")
        throw InputError("\"time\" is the name of the series' first column; give it another name");
    if (auto const check = response.quantity->check)
        check(response, experiment, groups);
    if (response.take->needs_threshold() == std::isnan(response.threshold))
        throw InputError(
            response.take->needs_threshold()
                ? fmt::format("take = \"{}\" needs a threshold", o.text("take"))
                : fmt::format("threshold is not used by take = \"{}\"; leave it out", o.text("take")));
    return response;
}

//! Moments at which there was nothing to look at do not count.
double reduced(ResponsePlan const& response, Progress const& progress)
{
    auto const times = progress.column_in(response.stage, "time");
    auto const values = progress.column_in(response.stage, response.name);
    Course course{{}, {}, not_given, response.threshold};
    for (std::size_t k = 0; k < values.size(); ++k)
        if (std::isfinite(values[k])) {
            course.times.push_back(times[k]);
            course.values.push_back(values[k]);
        }
    if (course.values.empty())
        return not_given;
    course.begin = times.front();
    return response.take->reduce(course);
}

} // namespace

TableSpec response_table()
{
    std::vector<TableKind> kinds;
    for (auto const& quantity : quantities()) {
        auto const& [name, doc, options] = quantity.keys;
        kinds.push_back({name, fmt::format("{} [{}]", doc, quantity.units), options});
    }
    std::vector<std::string> words;
    for (auto const& take : takes())
        words.push_back(take.name);
    return {
        .key = "response",
        .doc = "what is read off again and again, and the one number that is made of it",
        .options = {required_word("name", "its name, for targets; it should carry the unit"),
                    entry("stage", "stage", "over which stage; empty: the last one"),
                    choice(
                        "take", words,
                        "what is made of its course: its last value, mean, standard deviation, smallest or "
                        "largest value, last less first, slope of the line through it [1/s] or through the "
                        "part from a fifth to four fifths of its "
                        "change, or the time from "
                        "the beginning of the stage until it is above or below the threshold [s]"),
                    number("threshold", not_given, "in the unit of the quantity")},
        .kind_key = "quantity",
        .kinds = std::move(kinds)};
}

std::vector<ResponseInfo> asked_responses(OptionValues const& experiment)
{
    std::vector<ResponseInfo> infos;
    for (auto const& o : experiment.tables("response"))
        infos.push_back(
            {o.text("name"), take_named(o.text("take")).units_for(units_of(o, experiment)), doc_of(o)});
    return infos;
}

std::vector<ResponsePlan> read_responses(OptionValues const& experiment, Regions const& regions,
                                         std::vector<ParticleGroup> const& groups)
{
    std::vector<ResponsePlan> responses;
    for (auto const& o : experiment.tables("response"))
        responses.push_back(in_place("response." + o.text("name"),
                                     [&] { return read_response(o, experiment, regions, groups); }));
    if (responses.empty())
        throw InputError("nothing is measured; give at least one table [[experiment.response]]");
    return responses;
}

std::vector<Reading> readings(Setup const& setup)
{
    std::vector<Reading> all;
    for (auto const& response : setup.responses)
        all.push_back({response.name, response.units, response.quantity->keys.doc, [&](Look& look) {
                           return response.quantity->read({look, response, setup});
                       }});
    return all;
}

std::vector<ProfileReading> profiles(Setup const& setup)
{
    std::vector<ProfileReading> all;
    for (auto const& response : setup.responses)
        if (auto const surface = response.quantity->surface)
            all.push_back({.name = response.name,
                           .doc = response.quantity->keys.doc + ", at the end of its stage",
                           .axis = {"distance", "m"},
                           .value = {"height", "m"},
                           .stage = response.stage,
                           .over = ProfileReading::Over::end,
                           .take = [&, surface](Look& look) {
                               return surface({look, response, setup});
                           }});
    return all;
}

std::vector<Response> responses(Setup const& setup, std::vector<ResponseInfo> const& infos)
{
    std::vector<Response> all;
    for (auto const& response : setup.responses)
        all.push_back({infos[all.size()], response.stage,
                       response.take->needs_threshold() ? "its threshold was not reached"
                                                        : "there was nothing to look at",
                       [&](Progress const& progress) { return reduced(response, progress); }});
    return all;
}

} // namespace demens::rig::custom
