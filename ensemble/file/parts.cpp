#include "ensemble/file/parts.hpp"

#include "ensemble/file/run_tables.hpp"

#include <algorithm>
#include <cerrno>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

bool is_poisonous(RunHistory const& history)
{
    return history.crashes >= Parts::crashes_until_poisonous ||
           history.deaths_alone >= Parts::deaths_alone_until_poisonous;
}

bool is_suspicious(RunHistory const& history)
{
    return history.crashes > 0 || history.deaths_alone > 0 || history.deaths >= Parts::deaths_until_alone;
}

bool is_result_of(RunRecord const& run, RunRecord const& plan)
{
    return run.run == plan.run && run.point == plan.point && run.experiment == plan.experiment &&
           run.replicate == plan.replicate && run.seed == plan.seed && run.factors == plan.factors &&
           run.amplitudes == plan.amplitudes;
}

} // namespace

fs::path Parts::shard(int run) const
{
    return folder_ / fmt::format("run-{:06}.h5", run);
}

void Parts::make_folder() const
{
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error)
        throw system_error("create the folder", folder_, error.value());
}

void Parts::remove() const
{
    std::error_code ignored; // what is left over is removed when the campaign is opened again
    fs::remove_all(folder_, ignored);
}

void Parts::remove_shard(int run) const
{
    std::error_code ignored; // one that stays has no END line, or is that of a wave which is in the file
    fs::remove(shard(run), ignored);
}

void Parts::remove_shards(Wave const& wave) const
{
    for (auto const& run : wave.runs)
        remove_shard(run.run);
}

void Parts::store(FinishedRun const& run, CampaignInput const& input, Journal& journal) const
{
    Wave wave;
    wave.number = run.record.wave;
    wave.runs = {run.record};
    auto file = hdf5::create_in_memory();
    RowWriter writer(file);
    write_plan(writer, wave, input);
    write_results(writer, wave, input);
    write_details(writer, wave.number, wave.runs, {run.details}, input);
    auto const image = file.take_image();
    write_durably(shard(run.record.run), image);
    journal.end(run.record.run, crc32_of(image), static_cast<int>(run.record.status), run.record.wall_time);
}

std::uintmax_t Parts::shard_size(RunRecord const& plan) const
{
    return fs::file_size(shard(plan.run));
}

FinishedRun Parts::load(RunRecord const& plan, CampaignInput const& input,
                        std::vector<std::uint32_t> const& crcs) const
{
    auto const path = shard(plan.run);
    auto const image = read_bytes(path);
    auto const crc = crc32_of(image);
    if (std::find(crcs.begin(), crcs.end(), crc) == crcs.end())
        throw FileError(
            fmt::format("{}: damaged, its check sum is not the one in the journal", path.string()));
    auto const file = hdf5::open_in_memory(image);
    auto const wave = read_wave(file, plan.wave, input);
    if (wave.runs.size() != 1 || !is_result_of(wave.runs.front(), plan))
        throw FileError(fmt::format("{}: belongs to another campaign", path.string()));
    auto const& record = wave.runs.front();
    FinishedRun run{record,
                    read_details(file, plan.wave, 0,
                                 input.experiments.at(static_cast<std::size_t>(plan.experiment)).name),
                    crc};
    run.record.predicted_cost = plan.predicted_cost;
    return run;
}

SeenShard Parts::look(RunRecord const& plan, CampaignInput const& input,
                      std::vector<std::uint32_t> const& crcs) const
{
    if (crcs.empty())
        return {};
    try {
        auto const run = load(plan, input, crcs);
        return {run.shard_crc, run.record.status, run.record.start_time, run.record.wall_time};
    } catch (FileError const&) {
        return {}; // as if it had never ended: it runs again
    }
}

WaveState Parts::state_of(Wave const& wave, std::map<int, RunHistory> const& histories,
                          std::vector<SeenShard> shards)
{
    WaveState state;
    for (std::size_t row = 0; row < wave.runs.size(); ++row) {
        if (shards[row].crc != 0)
            continue;
        auto const found = histories.find(wave.runs[row].run);
        auto const history = found == histories.end() ? RunHistory{} : found->second;
        (is_poisonous(history)    ? state.poisonous
         : is_suspicious(history) ? state.suspicious
                                  : state.pending)
            .push_back(static_cast<int>(row));
    }
    state.shards = std::move(shards);
    return state;
}

std::string quarantine_reason(RunHistory const& history)
{
    if (history.crashes >= Parts::crashes_until_poisonous)
        return fmt::format("ended the program {} times ({}); not begun again", history.crashes,
                           history.crash);
    return fmt::format(
        "the program died {} times while this run was the only one in progress ({} times beside other "
        "runs); not begun again",
        history.deaths_alone, history.deaths);
}

} // namespace demens::ensemble
