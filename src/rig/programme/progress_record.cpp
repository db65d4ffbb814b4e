// The state of a run as a record.
#include "demens/rig/programme/programme_run.hpp"

#include "demens/base/error.hpp"

#include <cmath>

#include <fmt/format.h>

namespace demens::rig {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

//! Writes what it visits.
class Writer
{
  public:
    explicit Writer(dem::StateRecord& record) : record_(record) {}

    template <class T>
    void operator()(std::string const& name, std::vector<T> const& numbers)
    {
        record_.put("run/" + name, std::span(numbers));
    }
    template <std::size_t n>
    void operator()(std::string const& name, std::vector<std::array<double, n>> const& rows)
    {
        std::span<double const> const numbers(rows.empty() ? nullptr : rows.front().data(), n * rows.size());
        record_.put("run/" + name, numbers, n);
    }
    void operator()(std::string const& name, std::string const& text)
    {
        record_.put("run/" + name, std::as_bytes(std::span(text)));
    }
    template <class Number>
    void operator()(std::string const& name, Number number) requires std::is_arithmetic_v<Number>
    {
        using Kept = std::conditional_t<std::is_integral_v<Number>, std::int64_t, double>;
        (*this)(name, std::vector{static_cast<Kept>(number)});
    }
    //! How many of something follow.
    template <class Many>
    void count(std::string const& name, Many const& many)
    {
        (*this)(name, many.size());
    }

  private:
    dem::StateRecord& record_;
};

//! Reads what it visits.
class Reader
{
  public:
    explicit Reader(dem::StateRecord const& record) : record_(record) {}

    template <class T>
    void operator()(std::string const& name, std::vector<T>& numbers)
    {
        numbers = record_.get<T>("run/" + name);
    }
    template <std::size_t n>
    void operator()(std::string const& name, std::vector<std::array<double, n>>& rows)
    {
        auto const numbers = record_.get<double>("run/" + name, n);
        rows.resize(numbers.size() / n);
        for (std::size_t k = 0; k < rows.size() * n; ++k)
            rows[k / n][k % n] = numbers[k];
    }
    void operator()(std::string const& name, std::string& text)
    {
        text.clear();
        for (std::byte const byte : record_.get<std::byte>("run/" + name))
            text += static_cast<char>(byte);
    }
    template <class Number>
    void operator()(std::string const& name, Number& number) requires std::is_arithmetic_v<Number>
    {
        using Kept = std::conditional_t<std::is_integral_v<Number>, std::int64_t, double>;
        number = static_cast<Number>(one<Kept>(name));
    }
    template <class Many>
    void count(std::string const& name, Many& many)
    {
        auto const size = one<std::int64_t>(name);
        if (size < 0 || size > 1'000'000)
            throw InputError(fmt::format("the record of a run has {} {}", size, name));
        many.resize(static_cast<std::size_t>(size));
    }

  private:
    template <class T>
    T one(std::string const& name) const
    {
        auto const numbers = record_.get<T>("run/" + name);
        if (numbers.size() != 1)
            throw InputError(fmt::format("the record of a run has {} numbers for {}", numbers.size(), name));
        return numbers.front();
    }

    dem::StateRecord const& record_;
};

//! The curve of a profile, or the series.
template <class Visitor, class AnySeries>
void visit(Visitor& visitor, std::string const& name, AnySeries& series)
{
    visitor.count(name + "/columns", series.columns);
    visitor.count(name + "/names", series.names);
    visitor.count(name + "/units", series.units);
    for (std::size_t k = 0; k < series.columns.size(); ++k)
        visitor(fmt::format("{}/{}", name, k), series.columns[k]);
    for (std::size_t k = 0; k < series.names.size(); ++k) {
        visitor(fmt::format("{}/{}/name", name, k), series.names[k]);
        visitor(fmt::format("{}/{}/units", name, k), series.units[k]);
    }
}

template <class Visitor, class AnySnapshot>
void visit_snapshot(Visitor& visitor, std::string const& name, AnySnapshot& snapshot)
{
    visitor(name + "/name", snapshot.name);
    visitor(name + "/time", snapshot.time);
    int column = 0;
    for (auto* values : {&snapshot.x, &snapshot.y, &snapshot.z, &snapshot.radius, &snapshot.vx, &snapshot.vy,
                         &snapshot.vz, &snapshot.wx, &snapshot.wy, &snapshot.wz})
        visitor(fmt::format("{}/{}", name, column++), *values);
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
    visit(visitor, "series", progress.series);
    visitor.count("rows", progress.rows);
    for (std::size_t k = 0; k < progress.rows.size(); ++k) {
        visitor(fmt::format("rows/{}/first", k), progress.rows[k].first);
        visitor(fmt::format("rows/{}/end", k), progress.rows[k].end);
    }
    visitor.count("groups", progress.groups);
    for (std::size_t k = 0; k < progress.groups.size(); ++k) {
        visitor(fmt::format("groups/{}/first", k), progress.groups[k].ids.first);
        visitor(fmt::format("groups/{}/end", k), progress.groups[k].ids.end);
        visitor(fmt::format("groups/{}/level", k), progress.groups[k].level);
    }
    visitor.count("profiles", progress.profiles);
    for (std::size_t k = 0; k < progress.profiles.size(); ++k) {
        visitor(fmt::format("profiles/{}/name", k), progress.profiles[k].name);
        visitor(fmt::format("profiles/{}/doc", k), progress.profiles[k].doc);
        visit(visitor, fmt::format("profiles/{}", k), progress.profiles[k].curve);
    }
    visitor.count("averages", progress.averages);
    for (std::size_t k = 0; k < progress.averages.size(); ++k) {
        visitor(fmt::format("averages/{}/axis", k), progress.averages[k].axis);
        visitor(fmt::format("averages/{}/sum", k), progress.averages[k].sum);
        visitor(fmt::format("averages/{}/count", k), progress.averages[k].count);
    }
    visitor.count("snapshots", progress.snapshots);
    for (std::size_t k = 0; k < progress.snapshots.size(); ++k)
        visit_snapshot(visitor, fmt::format("snapshots/{}", k), progress.snapshots[k]);
}

} // namespace

dem::StateRecord RunState::record() const
{
    dem::StateRecord all = simulation;
    Writer writer(all);
    visit_all(writer, progress);
    writer("origin", progress.origin.value_or(none));
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
    Reader reader(state.simulation);
    auto& progress = state.progress;
    visit_all(reader, progress);
    double origin = none;
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
