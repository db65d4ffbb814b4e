#include "ensemble/file/run_tables.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>

namespace demens::ensemble {
namespace {

std::string series_path(int wave, std::string const& experiment)
{
    return fmt::format("/series/{:04}/{}/", wave, experiment);
}

std::string profiles_path(int wave, std::string const& experiment)
{
    return fmt::format("/profiles/{:04}/{}", wave, experiment);
}

std::string snapshots_path(int wave)
{
    return fmt::format("/snapshots/{:04}/", wave);
}

//! Curves of one kind of all runs, e.g. their time series, to be stored below a path.
struct Curves
{
    std::string path, doc;
    std::vector<rig::Series const*> of_runs; //!< null: the run has none
};

//! The curves, one below the other. Every run has a row in `samples` and `first_sample`.
void write_curves(RowWriter& writer, Curves const& curves)
{
    std::vector<std::string> labels;
    for (auto const* curve : curves.of_runs)
        for (std::size_t k = 0; curve && k < curve->names.size(); ++k)
            labels.push_back(curve->names[k] + "\t" + curve->units.at(k));
    labels = writer.all_texts(labels);
    hdf5::Meaning meaning{{}, {}, curves.doc};
    for (auto const& label : labels) {
        meaning.columns.push_back(label.substr(0, label.find('\t')));
        meaning.units.push_back(label.substr(label.find('\t') + 1));
    }

    std::vector<double> values;
    std::vector<std::int64_t> first, count;
    for (auto const* curve : curves.of_runs) {
        auto const samples = curve ? curve->rows() : 0;
        first.push_back(static_cast<std::int64_t>(values.size() / std::max<std::size_t>(1, labels.size())));
        count.push_back(static_cast<std::int64_t>(samples));
        for (std::size_t s = 0; s < samples; ++s)
            for (auto const& name : meaning.columns) {
                auto const k =
                    std::find(curve->names.begin(), curve->names.end(), name) - curve->names.begin();
                values.push_back(static_cast<std::size_t>(k) < curve->columns.size()
                                     ? curve->columns[static_cast<std::size_t>(k)].at(s)
                                     : std::numeric_limits<double>::quiet_NaN());
            }
    }
    if (!labels.empty()) {
        auto const shift = static_cast<std::int64_t>(writer.first_row(values.size() / labels.size()));
        for (auto& row : first)
            row += shift;
        writer.write(curves.path + "values", values, meaning, labels.size());
    }
    writer.write(curves.path + "first_sample", first,
                 hdf5::dimensionless("first row in values, one entry per run of the wave"));
    writer.write(curves.path + "samples", count,
                 hdf5::dimensionless("number of rows in values, one entry per run of the wave"));
}

//! Series and profiles of all runs of one experiment.
void write_curves(RowWriter& writer, int wave, std::vector<RunRecord> const& runs,
                  std::vector<RunDetails> const& details, int experiment, std::string const& experiment_name)
{
    Curves series{series_path(wave, experiment_name),
                  "time series of all runs, one below the other; see first_sample and samples",
                  {}};
    std::vector<std::string> labels; // names and meanings of profiles
    for (std::size_t i = 0; i < runs.size(); ++i) {
        bool const is_own = runs[i].experiment == experiment;
        series.of_runs.push_back(is_own ? &details[i].series : nullptr);
        for (std::size_t k = 0; is_own && k < details[i].profiles.size(); ++k)
            labels.push_back(details[i].profiles[k].name + "\t" + details[i].profiles[k].doc);
    }
    write_curves(writer, series);
    for (auto const& label : writer.all_texts(labels)) {
        auto const name = label.substr(0, label.find('\t'));
        Curves curves{profiles_path(wave, experiment_name) + "/" + name + "/",
                      label.substr(label.find('\t') + 1),
                      std::vector<rig::Series const*>(runs.size(), nullptr)};
        for (std::size_t i = 0; i < runs.size(); ++i)
            for (auto const& profile : details[i].profiles)
                if (runs[i].experiment == experiment && profile.name == name)
                    curves.of_runs[i] = &profile.curve;
        write_curves(writer, curves);
    }
}

//! A first row or a number of rows, as it is stored for a run or snapshot.
std::size_t row_number(hid_t file, std::string const& path, std::size_t row)
{
    auto const value = hdf5::read_rows<std::int64_t>(file, path, row, 1).data.at(0);
    if (value < 0)
        throw FileError(fmt::format("{}: entry {} is {}, which is no number of rows", path, row, value));
    return static_cast<std::size_t>(value);
}

//! Rows of a table with so many columns.
template <class T>
hdf5::Array<T> table_rows(hid_t file, std::string const& path, std::size_t first, std::size_t count,
                          std::size_t columns)
{
    auto rows = hdf5::read_rows<T>(file, path, first, count);
    hdf5::require_shape(path, rows.shape, {count, columns});
    return rows;
}

//! The curve of the run in a row; without columns where it has none.
rig::Series read_curve(hid_t file, std::string const& path, std::size_t row)
{
    rig::Series curve;
    if (!hdf5::exists(file, path + "values"))
        return curve;
    auto const first = row_number(file, path + "first_sample", row);
    auto const count = row_number(file, path + "samples", row);
    if (count == 0)
        return curve;
    curve.names = hdf5::texts_attribute(file, path + "values", "columns");
    curve.units = hdf5::texts_attribute(file, path + "values", "units");
    auto const width = curve.names.size();
    auto const values = table_rows<double>(file, path + "values", first, count, width);
    curve.units.resize(width, curve.units.empty() ? "1" : curve.units.front());
    for (std::size_t k = 0; k < width; ++k) {
        auto& column = curve.columns.emplace_back();
        for (std::size_t i = k; i < values.data.size(); i += width)
            column.push_back(values.data[i]);
    }
    return curve;
}

std::vector<double> column_of(hdf5::Array<float> const& table, std::size_t column)
{
    std::vector<double> values;
    for (std::size_t i = column; i < table.data.size(); i += table.shape.at(1))
        values.push_back(table.data[i]);
    return values;
}

std::vector<std::array<double, 6>> sixes(hdf5::Array<float> const& table)
{
    std::vector<std::array<double, 6>> rows(table.data.size() / 6);
    for (std::size_t i = 0; i < rows.size(); ++i)
        std::copy_n(table.data.begin() + static_cast<std::ptrdiff_t>(6 * i), 6, rows[i].begin());
    return rows;
}

} // namespace

void write_details(RowWriter& writer, int wave, std::vector<RunRecord> const& runs,
                   std::vector<RunDetails> const& details, CampaignInput const& input)
{
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        write_curves(writer, wave, runs, details, static_cast<int>(e), input.experiments[e].name);

    std::vector<float> particles, walls, lines;
    std::vector<int> run, hulls;
    std::vector<std::string> name;
    std::vector<double> time;
    std::vector<std::int64_t> first_particle, particle_count, first_wall, wall_count, first_line, line_count,
        first_hull, hull_count;
    for (std::size_t i = 0; i < runs.size(); ++i)
        for (auto const& snapshot : details[i].snapshots) {
            run.push_back(runs[i].run);
            name.push_back(snapshot.name);
            time.push_back(snapshot.time);
            first_particle.push_back(static_cast<std::int64_t>(particles.size() / 4));
            particle_count.push_back(static_cast<std::int64_t>(snapshot.x.size()));
            first_wall.push_back(static_cast<std::int64_t>(walls.size() / 6));
            wall_count.push_back(static_cast<std::int64_t>(snapshot.walls.size()));
            first_line.push_back(static_cast<std::int64_t>(lines.size() / 6));
            line_count.push_back(static_cast<std::int64_t>(snapshot.wall_lines.size()));
            first_hull.push_back(static_cast<std::int64_t>(hulls.size()));
            hull_count.push_back(static_cast<std::int64_t>(snapshot.hull.size()));
            for (std::uint32_t const part : snapshot.hull)
                hulls.push_back(part == rig::Snapshot::within_a_hull ? -1 : static_cast<int>(part));
            for (std::size_t p = 0; p < snapshot.x.size(); ++p)
                for (double const value :
                     {snapshot.x[p], snapshot.y.at(p), snapshot.z.at(p), snapshot.radius.at(p)})
                    particles.push_back(static_cast<float>(value));
            for (auto const& wall : snapshot.walls)
                walls.insert(walls.end(), wall.begin(), wall.end());
            for (auto const& line : snapshot.wall_lines)
                lines.insert(lines.end(), line.begin(), line.end());
        }
    auto const first_of_rank = static_cast<std::int64_t>(writer.first_row(particles.size() / 4));
    auto const wall_of_rank = static_cast<std::int64_t>(writer.first_row(walls.size() / 6));
    auto const line_of_rank = static_cast<std::int64_t>(writer.first_row(lines.size() / 6));
    auto const hull_of_rank = static_cast<std::int64_t>(writer.first_row(hulls.size()));
    for (std::size_t s = 0; s < run.size(); ++s) {
        first_hull[s] += hull_of_rank;
        first_particle[s] += first_of_rank;
        first_wall[s] += wall_of_rank;
        first_line[s] += line_of_rank;
    }
    auto const base = snapshots_path(wave);
    writer.write(base + "particles", particles,
                 {{"m"}, {"x", "y", "z", "radius"}, "particles of all snapshots"}, 4);
    writer.write(base + "walls", walls, {{"m"}, {"x0", "y0", "z0", "x1", "y1", "z1"}, "wall outlines"}, 6);
    writer.write(base + "lines", lines,
                 {{"m"}, {"x0", "y0", "z0", "x1", "y1", "z1"}, "rims and creases of walls"}, 6);
    writer.write(base + "hull", hulls,
                 hdf5::dimensionless(
                     "particles of snapshots with polyhedra: 0 none of one; n, above 0, a corner of the "
                     "n-th; -1 one that fills one"));
    writer.write(base + "run", run, hdf5::dimensionless("run, one entry per snapshot"));
    writer.write_texts(base + "name", name, "landmark, one entry per snapshot");
    writer.write(base + "time", time, {{"s"}, {}, "simulated time, one entry per snapshot"});
    writer.write(base + "first_particle", first_particle, hdf5::dimensionless("first row in particles"));
    writer.write(base + "particle_count", particle_count, hdf5::dimensionless("number of rows in particles"));
    writer.write(base + "first_wall", first_wall, hdf5::dimensionless("first row in walls"));
    writer.write(base + "wall_count", wall_count, hdf5::dimensionless("number of rows in walls"));
    writer.write(base + "first_line", first_line, hdf5::dimensionless("first row in lines"));
    writer.write(base + "line_count", line_count, hdf5::dimensionless("number of rows in lines"));
    writer.write(base + "first_hull", first_hull, hdf5::dimensionless("first row in hull"));
    writer.write(base + "hull_count", hull_count,
                 hdf5::dimensionless("number of rows in hull: 0, or one for each particle"));
}

RunDetails read_details(hid_t file, int wave, std::size_t row, std::string const& experiment)
{
    RunDetails details;
    details.series = read_curve(file, series_path(wave, experiment), row);
    auto const profiles = profiles_path(wave, experiment);
    for (auto const& name : hdf5::children(file, profiles)) {
        auto const path = profiles + "/" + name + "/";
        if (auto curve = read_curve(file, path, row); curve.rows() > 0)
            details.profiles.push_back(
                {name, hdf5::text_attribute(file, path + "values", "doc"), std::move(curve)});
    }

    auto const base = snapshots_path(wave);
    auto const run = hdf5::read_rows<int>(file, wave_path(wave) + "/runs/run", row, 1).data.at(0);
    auto const owner = hdf5::read<int>(file, base + "run");
    auto const name = hdf5::read_texts(file, base + "name");
    auto const time = hdf5::read<double>(file, base + "time", {owner.size()});
    hdf5::require_shape(base + "name", {name.size()}, {owner.size()});
    auto const rows_of = [&](std::string const& table, std::string const& of, std::size_t s,
                             std::size_t columns) {
        return table_rows<float>(file, base + table, row_number(file, base + "first_" + of, s),
                                 row_number(file, base + of + "_count", s), columns);
    };
    for (std::size_t s = 0; s < owner.size(); ++s) {
        if (owner[s] != run)
            continue;
        auto const particles = rows_of("particles", "particle", s, 4);
        auto const walls = rows_of("walls", "wall", s, 6);
        rig::Snapshot snapshot;
        snapshot.name = name.at(s);
        snapshot.time = time.at(s);
        snapshot.x = column_of(particles, 0);
        snapshot.y = column_of(particles, 1);
        snapshot.z = column_of(particles, 2);
        snapshot.radius = column_of(particles, 3);
        snapshot.walls = sixes(walls);
        if (hdf5::exists(file, base + "lines")) // files of earlier programs have none
            snapshot.wall_lines = sixes(rows_of("lines", "line", s, 6));
        if (hdf5::exists(file, base + "hull")) {
            auto const count = row_number(file, base + "hull_count", s);
            auto const rows =
                hdf5::read_rows<int>(file, base + "hull", row_number(file, base + "first_hull", s), count);
            hdf5::require_shape(base + "hull", rows.shape, {count});
            for (int const part : rows.data)
                snapshot.hull.push_back(part < 0 ? rig::Snapshot::within_a_hull
                                                 : static_cast<std::uint32_t>(part));
            if (!snapshot.hull.empty())
                hdf5::require_shape(base + "hull", {snapshot.hull.size()}, {snapshot.x.size()});
        }
        details.snapshots.push_back(std::move(snapshot));
    }
    return details;
}

} // namespace demens::ensemble
