// The state of a run as a record.
#include "demens/rig/programme/programme_run.hpp"

#include "demens/base/not_a_number.hpp"
#include "demens/dem/record_fields.hpp"
#include "demens/observe/snapshot_columns.hpp"

#include <cmath>

#include <fmt/format.h>

namespace demens::rig {
namespace {

//! How many there are, then each: `visit_one(its name, it)`.
template <class Visitor, class Many, class VisitOne>
void visit_each(Visitor& visitor, std::string const& name, Many& many, VisitOne const& visit_one)
{
    visitor.count(name, many);
    for (std::size_t k = 0; k < many.size(); ++k)
        visit_one(fmt::format("{}/{}", name, k), many[k]);
}

//! The curve of a profile, or the series.
template <class Visitor, class AnySeries>
void visit_series(Visitor& visitor, std::string const& name, AnySeries& series)
{
    visit_each(visitor, name + "/columns", series.columns, visitor);
    visit_each(visitor, name + "/names", series.names, visitor);
    visit_each(visitor, name + "/units", series.units, visitor);
}

template <class Visitor, class AnySnapshot>
void visit_snapshot(Visitor& visitor, std::string const& name, AnySnapshot& snapshot)
{
    visitor(name + "/name", snapshot.name);
    visitor(name + "/time", snapshot.time);
    int column = 0;
    for (auto* values : columns_of(snapshot))
        visitor(fmt::format("{}/{}", name, column++), *values);
    visitor(name + "/hull", snapshot.hull);
    visitor(name + "/walls", snapshot.walls);
    visitor(name + "/wall_lines", snapshot.wall_lines);
    visitor(name + "/wall_triangles", snapshot.wall_triangles);
}

//! All that can be written as it is; the one list of it.
template <class Visitor, class AnyProgress>
void visit_all(Visitor& visitor, AnyProgress& progress)
{
    visitor("stage", progress.stage);
    visitor("entered", progress.entered);
    visitor("begins", progress.begins);
    visitor("looks", progress.looks);
    visitor("steps_to_look", progress.steps_to_look);
    visitor("responses", progress.responses);
    visit_series(visitor, "series", progress.series);
    visit_each(visitor, "rows", progress.rows, [&](std::string const& name, auto& rows) {
        visitor(name + "/first", rows.first);
        visitor(name + "/end", rows.end);
    });
    visit_each(visitor, "groups", progress.groups, [&](std::string const& name, auto& group) {
        visitor(name + "/first", group.ids.first);
        visitor(name + "/end", group.ids.end);
        visitor(name + "/level", group.level);
    });
    visit_each(visitor, "profiles", progress.profiles, [&](std::string const& name, auto& profile) {
        visitor(name + "/name", profile.name);
        visitor(name + "/doc", profile.doc);
        visit_series(visitor, name, profile.curve);
    });
    visit_each(visitor, "averages", progress.averages, [&](std::string const& name, auto& average) {
        visitor(name + "/axis", average.axis);
        visitor(name + "/sum", average.sum);
        visitor(name + "/count", average.count);
    });
    visit_each(visitor, "snapshots", progress.snapshots,
               [&](std::string const& name, auto& snapshot) { visit_snapshot(visitor, name, snapshot); });
}

} // namespace

dem::StateRecord RunState::record() const
{
    dem::StateRecord all = simulation;
    dem::RecordWriter writer(all, "run/");
    visit_all(writer, progress);
    writer("origin", progress.origin.value_or(not_a_number));
    writer("model_of", progress.model_of ? static_cast<std::int64_t>(*progress.model_of) : -1);
    writer("random/seed", progress.random.seed());
    writer("random/drawn", progress.random.drawn());
    writer("notes/count", progress.notes.size());
    std::size_t number = 0;
    for (auto const& [name, value] : progress.notes) {
        writer(fmt::format("notes/{}/name", number), name);
        writer(fmt::format("notes/{}", number++), value);
    }
    return all;
}

RunState RunState::from_record(dem::StateRecord record)
{
    RunState state{std::move(record), {}};
    dem::RecordReader reader(state.simulation, "run/");
    auto& progress = state.progress;
    visit_all(reader, progress);
    double origin = not_a_number;
    reader("origin", origin);
    if (!std::isnan(origin))
        progress.origin = origin;
    std::int64_t model_of = -1, notes = 0;
    reader("model_of", model_of);
    if (model_of >= 0)
        progress.model_of = static_cast<std::size_t>(model_of);
    std::uint64_t seed = 0, drawn = 0;
    reader("random/seed", seed);
    reader("random/drawn", drawn);
    progress.random = RandomStream(seed, drawn);
    reader("notes/count", notes);
    for (std::int64_t k = 0; k < notes; ++k) {
        std::string name;
        reader(fmt::format("notes/{}/name", k), name);
        reader(fmt::format("notes/{}", k), progress.notes[name]);
    }
    return state;
}

} // namespace demens::rig
