#include "ensemble/file/run_tables.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace demens::ensemble {
namespace {

double constexpr not_reached = std::numeric_limits<double>::quiet_NaN();

template <class Get>
auto column(std::vector<RunRecord> const& runs, Get get)
{
    std::vector<std::decay_t<decltype(get(runs.front()))>> values;
    values.reserve(runs.size());
    for (auto const& run : runs)
        values.push_back(get(run));
    return values;
}

hdf5::Meaning number(std::string doc)
{
    return {{"1"}, {}, std::move(doc)};
}
hdf5::Meaning seconds(std::string doc)
{
    return {{"s"}, {}, std::move(doc)};
}

//! One row per design point of these runs, which are ordered by point.
std::vector<double> design_rows(std::vector<RunRecord> const& runs)
{
    std::vector<double> rows;
    int last_point = -1;
    for (auto const& run : runs) {
        if (run.point != last_point)
            rows.insert(rows.end(), run.factors.begin(), run.factors.end());
        last_point = run.point;
    }
    return rows;
}

std::string responses_path(int wave, Experiment const& experiment)
{
    return wave_path(wave) + "/responses/" + experiment.name;
}

void write_responses(RowWriter const& writer, Wave const& wave, CampaignInput const& input,
                     std::size_t experiment)
{
    auto const& infos = input.experiments[experiment].responses;
    hdf5::Meaning meaning{{}, {}, "responses, one row per run of the wave; NaN in rows of other experiments"};
    for (auto const& info : infos) {
        meaning.columns.push_back(info.name);
        meaning.units.push_back(info.units);
    }
    std::vector<double> rows;
    for (auto const& run : wave.runs)
        for (std::size_t k = 0; k < infos.size(); ++k)
            rows.push_back(run.experiment == static_cast<int>(experiment) && k < run.responses.size()
                               ? run.responses[k]
                               : not_reached);
    if (!infos.empty())
        writer.write(responses_path(wave.number, input.experiments[experiment]), rows, meaning, infos.size());
}

//! One row per run; NaN for runs without the ledger.
void write_energy(RowWriter const& writer, std::string const& path, std::vector<RunRecord> const& runs)
{
    hdf5::Meaning meaning{{"J"}, {}, "energy ledger at the end of each run; NaN where none was kept"};
    for (auto const& entry : dem::energy_entries)
        meaning.columns.push_back(entry.name);
    std::vector<double> rows;
    for (auto const& run : runs)
        for (auto const& entry : dem::energy_entries)
            rows.push_back(run.energy ? (*run.energy).*entry.value : not_reached);
    writer.write(path, rows, meaning, dem::energy_entries.size());
}

void read_energy(hid_t file, std::string const& path, std::vector<RunRecord>& runs)
{
    if (!hdf5::exists(file, path))
        return; // a file from before there was a ledger
    auto const rows = hdf5::read<double>(file, path);
    auto value = rows.begin();
    for (auto& run : runs) {
        dem::EnergyLedger energy;
        for (auto const& entry : dem::energy_entries)
            energy.*entry.value = *value++;
        if (!std::isnan(energy.turned_over))
            run.energy = energy;
    }
}

WavePurpose purpose_of(std::string const& group, std::string const& text)
{
    auto const* purpose = find_word<WavePurpose>(text);
    if (!purpose)
        throw FileError(fmt::format("{}: the purpose \"{}\" is not known; known are {}", group, text,
                                    fmt::join(texts_of<WavePurpose>(), ", ")));
    return *purpose;
}

void read_results(hid_t file, Wave& wave, CampaignInput const& input)
{
    auto const base = wave_path(wave.number);
    auto const table = base + "/runs/";
    wave.groups = static_cast<int>(hdf5::integer_attribute(file, base, "groups"));
    wave.wall_time = hdf5::number_attribute(file, base, "wall_time_s");
    auto const status = hdf5::read<int>(file, table + "status");
    auto const reason = hdf5::read_texts(file, table + "reason");
    auto const wall_time = hdf5::read<double>(file, table + "wall_time");
    auto const start_time = hdf5::read<double>(file, table + "start_time");
    auto const group = hdf5::read<int>(file, table + "group");
    auto const simulated_time = hdf5::read<double>(file, table + "simulated_time");
    auto const steps = hdf5::read<std::int64_t>(file, table + "steps");
    auto const particles = hdf5::read<std::int64_t>(file, table + "particles");
    read_energy(file, table + "energy", wave.runs);
    std::vector<std::vector<double>> responses;
    for (auto const& experiment : input.experiments)
        responses.push_back(experiment.responses.empty()
                                ? std::vector<double>()
                                : hdf5::read<double>(file, responses_path(wave.number, experiment)));
    for (std::size_t i = 0; i < wave.runs.size(); ++i) {
        auto& run = wave.runs[i];
        run.status = static_cast<rig::RunStatus>(status.at(i));
        run.reason = reason.at(i);
        run.wall_time = wall_time.at(i);
        run.start_time = start_time.at(i);
        run.group = group.at(i);
        run.simulated_time = simulated_time.at(i);
        run.steps = steps.at(i);
        run.particles = particles.at(i);
        auto const e = static_cast<std::size_t>(run.experiment);
        auto const width = input.experiments.at(e).responses.size();
        auto const row = responses[e].begin() + static_cast<std::ptrdiff_t>(i * width);
        run.responses.assign(row, row + static_cast<std::ptrdiff_t>(width));
    }
}

//! Paths below a group of all datasets, sorted.
void list_datasets(hid_t file, std::string const& group, std::string const& prefix,
                   std::vector<std::string>& paths)
{
    for (auto const& name : hdf5::children(file, group)) {
        auto const full = group + "/" + name;
        hdf5::Object const object(H5Oopen(file, full.c_str(), H5P_DEFAULT), "open " + full);
        if (H5Iget_type(object) == H5I_GROUP)
            list_datasets(file, full, prefix + name + "/", paths);
        else
            paths.push_back(prefix + name);
    }
}

std::vector<NamedArray> read_analysis(hid_t file, int wave)
{
    auto const base = wave_path(wave);
    std::vector<std::string> paths;
    for (auto const& name : hdf5::children(file, base))
        if (name != "design" && name != "runs" && name != "responses")
            list_datasets(file, base + "/" + name, name + "/", paths);
    std::vector<NamedArray> arrays;
    for (auto const& path : paths) {
        auto const full = base + "/" + path;
        auto array = hdf5::read_array<double>(file, full);
        arrays.push_back(
            {path, std::move(array.shape), std::move(array.data), hdf5::text_attribute(file, full, "units"),
             hdf5::has_attribute(file, full, "doc") ? hdf5::text_attribute(file, full, "doc") : ""});
    }
    return arrays;
}

} // namespace

std::string wave_path(int wave)
{
    return fmt::format("/waves/{:04}", wave);
}

bool is_complete(Wave const& wave)
{
    return std::none_of(wave.runs.begin(), wave.runs.end(),
                        [](RunRecord const& run) { return run.status == rig::RunStatus::not_run; });
}

void write_plan(RowWriter const& writer, Wave const& wave, CampaignInput const& input)
{
    auto const base = wave_path(wave.number);
    hdf5::make_group(writer.file(), base);
    hdf5::set_attribute(writer.file(), base, "number", static_cast<std::int64_t>(wave.number));
    hdf5::set_attribute(writer.file(), base, "purpose", word_for(wave.purpose));
    hdf5::Meaning design{
        {"as in the factor's name"}, {}, "design points, one row each, factors in their own units"};
    for (auto const& factor : input.factors)
        design.columns.push_back(factor.name);
    writer.write(base + "/design", design_rows(wave.runs), design,
                 std::max<std::size_t>(1, input.factors.size()));
    auto const first_point = wave.runs.empty() ? 0 : wave.runs.front().point;
    hdf5::set_attribute(writer.file(), base + "/design", "first_point",
                        static_cast<std::int64_t>(first_point));

    auto const table = base + "/runs/";
    auto const& runs = wave.runs;
    writer.write(table + "run", column(runs, [](auto& r) { return r.run; }),
                 number("number in the campaign"));
    writer.write(table + "point", column(runs, [](auto& r) { return r.point; }),
                 number("design point; row point - first_point of ../design"));
    writer.write(table + "experiment", column(runs, [](auto& r) { return r.experiment; }),
                 number("row of /experiments"));
    writer.write(table + "replicate", column(runs, [](auto& r) { return r.replicate; }), number("replicate"));
    writer.write(table + "seed", column(runs, [](auto& r) { return r.seed; }), number("seed of the run"));
    writer.write(table + "predicted_cost", column(runs, [](auto& r) { return r.predicted_cost; }),
                 number("particles x time steps, as predicted"));
}

void write_results(RowWriter const& writer, Wave const& wave, CampaignInput const& input)
{
    auto const base = wave_path(wave.number);
    hdf5::set_attribute(writer.file(), base, "groups", static_cast<std::int64_t>(wave.groups));
    hdf5::set_attribute(writer.file(), base, "wall_time_s", wave.wall_time);

    auto const table = base + "/runs/";
    auto const& runs = wave.runs;
    std::string names;
    for (int status = 0; status <= static_cast<int>(rig::RunStatus::unbalanced); ++status)
        names += fmt::format("{}{} {}", status ? ", " : "", status,
                             rig::name_of(static_cast<rig::RunStatus>(status)));
    writer.write(table + "status", column(runs, [](auto& r) { return static_cast<int>(r.status); }),
                 number(names));
    writer.write_texts(table + "reason", column(runs, [](auto& r) { return r.reason; }),
                       "why it did not finish");
    writer.write(table + "wall_time", column(runs, [](auto& r) { return r.wall_time; }),
                 seconds("time the simulation took"));
    writer.write(table + "start_time", column(runs, [](auto& r) { return r.start_time; }),
                 seconds("working time of the wave when it began, pauses left out"));
    writer.write(table + "group", column(runs, [](auto& r) { return r.group; }),
                 number("group of ranks that ran it"));
    writer.write(table + "simulated_time", column(runs, [](auto& r) { return r.simulated_time; }),
                 seconds("simulated time"));
    writer.write(table + "steps", column(runs, [](auto& r) { return r.steps; }), number("time steps"));
    writer.write(table + "particles", column(runs, [](auto& r) { return r.particles; }), number("particles"));
    write_energy(writer, table + "energy", runs);
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        write_responses(writer, wave, input, e);
}

void write_analysis(hid_t file, int wave, std::vector<NamedArray> const& arrays)
{
    for (auto const& array : arrays) {
        auto const path = wave_path(wave) + "/" + array.path;
        if (hdf5::exists(file, path))
            hdf5::check(H5Ldelete(file, path.c_str(), H5P_DEFAULT), "replace " + path);
        hdf5::write(file, path, array.shape, array.data, {{array.units}, {}, array.doc});
    }
}

Wave read_wave(hid_t file, int number, CampaignInput const& input)
{
    auto const base = wave_path(number);
    auto const table = base + "/runs/";
    Wave wave;
    wave.number = number;
    wave.purpose = purpose_of(base, hdf5::text_attribute(file, base, "purpose"));
    auto const design = hdf5::read<double>(file, base + "/design");
    auto const first_point = hdf5::integer_attribute(file, base + "/design", "first_point");
    auto const run = hdf5::read<int>(file, table + "run");
    auto const point = hdf5::read<int>(file, table + "point");
    auto const experiment = hdf5::read<int>(file, table + "experiment");
    auto const replicate = hdf5::read<int>(file, table + "replicate");
    auto const seed = hdf5::read<std::uint64_t>(file, table + "seed");
    auto const predicted_cost = hdf5::read<double>(file, table + "predicted_cost");
    auto const width = input.factors.size();
    for (std::size_t i = 0; i < run.size(); ++i) {
        RunRecord record;
        record.run = run[i];
        record.wave = number;
        record.point = point.at(i);
        record.experiment = experiment.at(i);
        record.replicate = replicate.at(i);
        record.seed = seed.at(i);
        record.predicted_cost = predicted_cost.at(i);
        auto const row = static_cast<std::size_t>(record.point - first_point) * width;
        for (std::size_t k = 0; k < width; ++k)
            record.factors.push_back(design.at(row + k));
        wave.runs.push_back(std::move(record));
    }
    if (hdf5::exists(file, table + "status"))
        read_results(file, wave, input);
    wave.analysis = read_analysis(file, number);
    return wave;
}

} // namespace demens::ensemble
