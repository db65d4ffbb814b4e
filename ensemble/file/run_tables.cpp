#include "ensemble/file/run_tables.hpp"

#include "ensemble/file/effect_tables.hpp"
#include "ensemble/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <tuple>

namespace demens::ensemble {
namespace {

double constexpr not_reached = std::numeric_limits<double>::quiet_NaN();

//! A dataset below `runs` with one entry per run, and the member that it holds.
template <class T>
struct RunColumn
{
    char const* name;
    T RunRecord::*member;
    char const* units;
    char const* doc;
};

auto constexpr plan_columns = std::tuple{
    RunColumn<int>{"run", &RunRecord::run, "1", "number in the campaign"},
    RunColumn<int>{"point", &RunRecord::point, "1", "design point; row point - first_point of ../design"},
    RunColumn<int>{"experiment", &RunRecord::experiment, "1", "row of /experiments"},
    RunColumn<int>{"replicate", &RunRecord::replicate, "1", "replicate"},
    RunColumn<std::uint64_t>{"seed", &RunRecord::seed, "1", "seed of the run"},
    RunColumn<double>{"predicted_cost", &RunRecord::predicted_cost, "1",
                      "particles x time steps, as predicted"}};

auto constexpr result_columns =
    std::tuple{RunColumn<double>{"wall_time", &RunRecord::wall_time, "s", "time the simulation took"},
               RunColumn<double>{"start_time", &RunRecord::start_time, "s",
                                 "working time of the wave when it began, pauses left out"},
               RunColumn<int>{"group", &RunRecord::group, "1", "group of ranks that ran it"},
               RunColumn<double>{"simulated_time", &RunRecord::simulated_time, "s", "simulated time"},
               RunColumn<std::int64_t>{"steps", &RunRecord::steps, "1", "time steps"},
               RunColumn<std::int64_t>{"particles", &RunRecord::particles, "1", "particles"}};

template <class T>
void write_column(RowWriter& writer, std::string const& table, RunColumn<T> const& column,
                  std::vector<RunRecord> const& runs)
{
    std::vector<T> values;
    values.reserve(runs.size());
    for (auto const& run : runs)
        values.push_back(run.*column.member);
    writer.write(table + column.name, values, {{column.units}, {}, column.doc});
}

template <class T>
void read_column(hid_t file, std::string const& table, RunColumn<T> const& column,
                 std::vector<RunRecord>& runs)
{
    auto const values = hdf5::read<T>(file, table + column.name, {runs.size()});
    for (std::size_t i = 0; i < runs.size(); ++i)
        runs[i].*column.member = values[i];
}

template <class Columns>
void write_columns(RowWriter& writer, std::string const& table, Columns const& columns,
                   std::vector<RunRecord> const& runs)
{
    std::apply([&](auto const&... column) { (write_column(writer, table, column, runs), ...); }, columns);
}

template <class Columns>
void read_columns(hid_t file, std::string const& table, Columns const& columns, std::vector<RunRecord>& runs)
{
    std::apply([&](auto const&... column) { (read_column(file, table, column, runs), ...); }, columns);
}

std::string responses_path(int wave, Experiment const& experiment)
{
    return wave_path(wave) + "/responses/" + experiment.name;
}

void write_responses(RowWriter& writer, Wave const& wave, CampaignInput const& input, std::size_t experiment)
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
void write_energy(RowWriter& writer, std::string const& path, std::vector<RunRecord> const& runs)
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
    auto const rows = hdf5::read<double>(file, path, {runs.size(), dem::energy_entries.size()});
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
    if (hdf5::has_attribute(file, base, "time_before_s")) // not in files of earlier versions
        wave.time_before = hdf5::number_attribute(file, base, "time_before_s");
    auto const status = hdf5::read<int>(file, table + "status", {wave.runs.size()});
    auto const reason = hdf5::read_texts(file, table + "reason");
    hdf5::require_shape(table + "reason", {reason.size()}, {wave.runs.size()});
    read_columns(file, table, result_columns, wave.runs);
    read_energy(file, table + "energy", wave.runs);
    std::vector<std::vector<double>> responses;
    for (auto const& experiment : input.experiments)
        responses.push_back(experiment.responses.empty()
                                ? std::vector<double>()
                                : hdf5::read<double>(file, responses_path(wave.number, experiment),
                                                     {wave.runs.size(), experiment.responses.size()}));
    for (std::size_t i = 0; i < wave.runs.size(); ++i) {
        auto& run = wave.runs[i];
        if (status[i] < 0 || status[i] >= rig::run_statuses)
            throw FileError(
                fmt::format("{}status: run {} has {}, which is no status", table, run.run, status[i]));
        run.status = static_cast<rig::RunStatus>(status[i]);
        run.reason = reason[i];
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

//! What must be as long as there are factors or targets is; readers rely on it.
void check_shape(NamedArray const& array, CampaignInput const& input)
{
    auto const* name = stored::find_name(array.path);
    if (!name || name->shape.front() == stored::Extent::none)
        return;
    std::size_t target_count = 0;
    for (auto const& experiment : input.experiments)
        target_count += experiment.targets.size();
    std::vector<std::size_t> right;
    for (std::size_t d = 0; d < name->shape.size() && name->shape[d] != stored::Extent::none; ++d) {
        switch (name->shape[d]) {
        case stored::Extent::one:
            right.push_back(1);
            break;
        case stored::Extent::two:
            right.push_back(2);
            break;
        case stored::Extent::factors:
            right.push_back(input.factors.size());
            break;
        case stored::Extent::targets:
            right.push_back(target_count);
            break;
        case stored::Extent::any:
        case stored::Extent::none:
            right.push_back(d < array.shape.size() ? array.shape[d] : 0);
        }
    }
    hdf5::require_shape(array.path, array.shape, right);
}

//! What is used to number something must number it. \throws FileError
void check_numbers(NamedArray const& array, Wave const& wave, CampaignInput const& input)
{
    int last_run = -1, last_point = -1;
    for (auto const& run : wave.runs) {
        last_run = std::max(last_run, run.run);
        last_point = std::max(last_point, run.point);
    }
    std::size_t most_responses = 0;
    for (auto const& experiment : input.experiments)
        most_responses = std::max(most_responses, experiment.responses.size());
    auto const count = [](std::size_t size) { return static_cast<double>(size) - 1; };
    struct Numbers
    {
        char const* path;
        double least, most;
    };
    for (auto const& [path, least, most] :
         {Numbers{stored::optimum::best_point_number.path, -1, static_cast<double>(last_point)},
          Numbers{stored::optimum::best_run.path, -1, static_cast<double>(last_run)},
          Numbers{stored::optimum::factor_verdict.path, 0, verdicts - 1},
          Numbers{stored::surrogate::kind.path, 0, 5},
          Numbers{stored::tradeoff::factors.path, 0, count(input.factors.size())},
          Numbers{stored::tradeoff::response.path, -1,
                  std::max(count(input.experiments.size()), count(most_responses))}})
        if (array.path == path)
            for (double const value : array.data)
                if (std::isfinite(value) && !(value == std::floor(value) && value >= least && value <= most))
                    throw FileError(
                        fmt::format("{}: {} is no whole number from {} to {}", path, value, least, most));
}

std::vector<NamedArray> read_analysis(hid_t file, Wave const& wave, CampaignInput const& input)
{
    auto const base = wave_path(wave.number);
    std::vector<std::string> paths;
    for (auto const& name : hdf5::children(file, base))
        if (name != "design" && name != "effects" && name != "amplitudes" && name != "runs" &&
            name != "responses")
            list_datasets(file, base + "/" + name, name + "/", paths);
    std::vector<NamedArray> arrays;
    for (auto const& path : paths) {
        auto const full = base + "/" + path;
        auto array = hdf5::read_array<double>(file, full);
        arrays.push_back(
            {path, std::move(array.shape), std::move(array.data), hdf5::text_attribute(file, full, "units"),
             hdf5::has_attribute(file, full, "doc") ? hdf5::text_attribute(file, full, "doc") : ""});
        check_shape(arrays.back(), input);
        check_numbers(arrays.back(), wave, input);
    }
    return arrays;
}

} // namespace

std::string wave_path(int wave)
{
    return fmt::format("/waves/{:04}", wave);
}

void write_plan(RowWriter& writer, Wave const& wave, CampaignInput const& input)
{
    auto const base = wave_path(wave.number);
    writer.make_group(base);
    writer.set_attribute(base, "number", static_cast<std::int64_t>(wave.number));
    writer.set_attribute(base, "purpose", word_for(wave.purpose));
    if (wave.planned_ahead)
        writer.set_attribute(base, "planned_ahead", std::int64_t{1});
    if (!wave.taken_from.empty())
        writer.set_attribute(base, "taken_from", wave.taken_from);
    hdf5::Meaning design{
        {"as in the factor's name"}, {}, "design points, one row each, factors in their own units"};
    for (auto const& factor : input.factors)
        design.columns.push_back(factor.name);
    writer.write(base + "/design", rows_of(&RunRecord::factors, wave.runs), design,
                 std::max<std::size_t>(1, input.factors.size()));
    auto const first_point = wave.runs.empty() ? 0 : wave.runs.front().point;
    writer.set_attribute(base + "/design", "first_point", static_cast<std::int64_t>(first_point));

    write_effects(writer, wave);

    auto const table = base + "/runs/";
    auto const& runs = wave.runs;
    write_columns(writer, table, plan_columns, runs);
}

void write_results(RowWriter& writer, Wave const& wave, CampaignInput const& input)
{
    auto const base = wave_path(wave.number);
    writer.set_attribute(base, "groups", static_cast<std::int64_t>(wave.groups));
    writer.set_attribute(base, "wall_time_s", wave.wall_time);
    writer.set_attribute(base, "time_before_s", wave.time_before);

    auto const table = base + "/runs/";
    auto const& runs = wave.runs;
    std::string names;
    for (int status = 0; status < rig::run_statuses; ++status)
        names += fmt::format("{}{} {}", status ? ", " : "", status,
                             rig::name_of(static_cast<rig::RunStatus>(status)));
    std::vector<int> status;
    std::vector<std::string> reason;
    for (auto const& run : runs) {
        status.push_back(static_cast<int>(run.status));
        reason.push_back(run.reason);
    }
    writer.write(table + "status", status, hdf5::dimensionless(names));
    writer.write_texts(table + "reason", reason, "why it did not finish");
    write_columns(writer, table, result_columns, runs);
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
    wave.planned_ahead = hdf5::has_attribute(file, base, "planned_ahead") &&
                         hdf5::integer_attribute(file, base, "planned_ahead") != 0;
    if (hdf5::has_attribute(file, base, "taken_from"))
        wave.taken_from = hdf5::text_attribute(file, base, "taken_from");
    wave.runs.resize(hdf5::read<int>(file, table + "run").size());
    read_columns(file, table, plan_columns, wave.runs);
    auto const width = input.factors.size();
    auto const design = hdf5::read_array<double>(file, base + "/design");
    auto const points = design.shape.empty() ? 0 : design.shape.front();
    hdf5::require_shape(base + "/design", design.shape, {points, std::max<std::size_t>(1, width)});
    auto const first_point = hdf5::integer_attribute(file, base + "/design", "first_point");
    for (auto& run : wave.runs) {
        run.wave = number;
        auto const row = static_cast<std::size_t>(run.point - first_point);
        auto const experiment = static_cast<std::size_t>(run.experiment);
        if (row >= points || experiment >= input.experiments.size())
            throw FileError(
                fmt::format("{}: run {} is of design point {} and experiment {}, which are not there", base,
                            run.run, run.point, run.experiment));
        if (wave.taken_from.empty() && run.seed != input.run_seed(run.point, run.experiment, run.replicate))
            throw FileError(
                fmt::format("{}: run {} does not have the seed that the campaign gives it", base, run.run));
        run.factors.assign(design.data.begin() + static_cast<std::ptrdiff_t>(row * width),
                           design.data.begin() + static_cast<std::ptrdiff_t>((row + 1) * width));
        if (!std::all_of(run.factors.begin(), run.factors.end(),
                         [](double value) { return std::isfinite(value); }))
            throw FileError(fmt::format("{}/design: point {} is not a number", base, run.point));
    }
    read_effects(file, wave, input, first_point, points);
    if (hdf5::exists(file, table + "status"))
        read_results(file, wave, input);
    wave.analysis = read_analysis(file, wave, input);
    return wave;
}

} // namespace demens::ensemble
