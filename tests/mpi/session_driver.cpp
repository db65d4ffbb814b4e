// A small program around Session for tests that kill, stop or starve it: `session_driver COMMAND FILE.h5
// [options]`.
//   create FILE [TOML line...]   a new campaign; the lines go into the table of the first experiment, from
//   one
//                                that begins a table on to the end of the file
//   run FILE WAVES POINTS        (under mpirun) goes on until WAVES waves are complete
//   overlap FILE WAVES POINTS    the same; each wave is planned while the one before is being run
//   plan FILE POINTS             (under mpirun) plans the next wave and runs nothing
//   shards FILE TASK TASKS       (under mpirun) one task of a job array
//   dump FILE                    results as text, every bit of them; without what depends on the clock
//   status FILE
// Exit codes as those of demens: 0, 2 bad input, 75 drained, 1 other.
#include "tests/mpi/formula_rig.hpp"

#include "demens/base/error.hpp"
#include "ensemble/campaign_reader.hpp"
#include "ensemble/status/status_text.hpp"
#include "ensemble/storage/durable.hpp"

#include <cstdlib>
#include <fmt/format.h>

using namespace demens;
using namespace demens::ensemble;
using namespace demens::test;

namespace {

//! The formula and the rigs of the program.
Rigs const& driver_rigs()
{
    static Rigs const rigs = [] {
        auto all = rig::all_rigs();
        all.insert(all.end(), formula_rigs().begin(), formula_rigs().end());
        return all;
    }();
    return rigs;
}

//! Depends on the responses of a wave, so that a lost or changed result shows in all that follows.
std::vector<std::vector<double>> points_after(Campaign const& campaign, int wave, int count)
{
    double carried = 0.5;
    if (wave >= 0)
        for (auto const& run : campaign.waves.at(static_cast<std::size_t>(wave)).runs)
            if (run.status == rig::RunStatus::finished)
                carried = std::fmod(carried + 7 * run.responses[0] + run.responses[1], 1.0);
    RandomStream random(
        derive_seed(static_cast<std::uint64_t>(carried * 0x1p53), static_cast<std::uint64_t>(wave + 1)));
    std::vector<std::vector<double>> points;
    for (int i = 0; i < count; ++i)
        points.push_back({random.uniform(), random.uniform()});
    return points;
}

std::vector<NamedArray> analysis_of(Campaign const& campaign, int wave)
{
    return {{"optimum/carried",
             {1},
             {points_after(campaign, wave, 1)[0][0]},
             "1",
             "what the next wave depends on"}};
}

//! Complete waves without an analysis.
std::vector<int> waves_to_analyse(Campaign const& campaign)
{
    std::vector<int> waves;
    for (auto const& wave : campaign.waves)
        if (is_complete(wave) && wave.analysis.empty())
            waves.push_back(wave.number);
    return waves;
}

//! \param lag waves before the last whose responses a new one depends on: 1 where waves overlap, else 0
int run(std::string const& file, int waves, int points, int lag)
{
    Session session(MPI_COMM_WORLD, file, {.rigs = driver_rigs(), .progress = stderr});
    auto const& campaign = session.campaign();
    auto const next = [&](Campaign const& now) {
        int const last = static_cast<int>(now.waves.size()) - 1;
        return WavePlan{.purpose = WavePurpose::search, .points = points_after(now, last - lag, points)};
    };
    Foresight const foresight = [&](Campaign const& now) {
        LookAhead ahead;
        for (int const wave : waves_to_analyse(now))
            ahead.analyses.emplace_back(wave, analysis_of(now, wave));
        if (static_cast<int>(now.waves.size()) < waves)
            ahead.next = next(now);
        return ahead;
    };
    while (true) {
        if (session.run_waves(lag > 0 ? foresight : Foresight()) == WaveEnd::drained)
            return 75;
        for (int const wave : waves_to_analyse(campaign))
            session.store_analysis(wave, analysis_of(campaign, wave));
        if (static_cast<int>(campaign.waves.size()) >= waves)
            break;
        session.plan_wave(next(campaign));
    }
    session.end("as many waves as asked for");
    return 0;
}

void dump(std::string const& file)
{
    CampaignReader const reader(file, driver_rigs());
    auto const& campaign = reader.campaign();
    for (auto const& run : campaign.all_runs()) {
        fmt::print("run {} wave {} point {} seed {} status {} reason '{}'", run.run, run.wave, run.point,
                   run.seed, static_cast<int>(run.status), run.reason);
        for (double const value : run.factors)
            fmt::print(" {:a}", value);
        for (double const value : run.responses)
            fmt::print(" {:a}", value);
        if (run.status != rig::RunStatus::not_run)
            for (auto const& snapshot : reader.details_of(run.run).snapshots)
                fmt::print(" {}:{}", snapshot.name, snapshot.x.size());
        fmt::print("\n");
    }
    for (auto const& wave : campaign.waves)
        for (auto const& array : wave.analysis)
            fmt::print("wave {} {} {} numbers, check sum {:08x}\n", wave.number, array.path,
                       array.data.size(), crc32_of(std::as_bytes(std::span(array.data))));
    fmt::print("ended '{}'\n", campaign.ended);
}

int with_mpi(std::vector<std::string> const& arguments)
{
    MPI_Init(nullptr, nullptr);
    int rank = 0, code = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    auto const complain = [&](std::exception const& error, int exit_code) {
        if (rank == 0)
            fmt::print(stderr, "{}\n", error.what());
        code = exit_code;
    };
    try {
        auto const& file = arguments.at(1);
        if (arguments[0] == "plan") {
            Session session(MPI_COMM_WORLD, file, {.rigs = driver_rigs(), .progress = nullptr});
            auto const& waves = session.campaign().waves;
            session.plan_wave(WavePurpose::search,
                              points_after(session.campaign(), static_cast<int>(waves.size()) - 1,
                                           std::stoi(arguments.at(2))));
        } else if (arguments[0] == "run" || arguments[0] == "overlap")
            code =
                run(file, std::stoi(arguments.at(2)), std::stoi(arguments.at(3)), arguments[0] == "overlap");
        else if (run_shards(MPI_COMM_WORLD, file, std::stoi(arguments.at(2)), std::stoi(arguments.at(3)),
                            {.rigs = driver_rigs(), .progress = stderr}) == WaveEnd::drained)
            code = 75;
    } catch (InputError const& error) {
        complain(error, 2);
    } catch (std::exception const& error) {
        complain(error, 1);
    }
    MPI_Finalize();
    return code;
}

int alone(std::vector<std::string> const& arguments)
{
    auto const& file = arguments.at(1);
    if (arguments[0] == "create") {
        std::string options, sections;
        for (std::size_t i = 2; i < arguments.size(); ++i)
            (sections.empty() && !arguments[i].starts_with('[') ? options : sections) += arguments[i] + "\n";
        create_campaign_file(
            file, CampaignInput::from_text(formula_campaign(options, sections), "driver", driver_rigs()));
    } else if (arguments[0] == "dump") {
        dump(file);
    } else {
        fmt::print("{}", status_text(read_status(file, driver_rigs())));
    }
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    std::vector<std::string> const arguments(argv + 1, argv + argc);
    if (arguments.size() < 2)
        return 2;
    if (arguments[0] == "run" || arguments[0] == "overlap" || arguments[0] == "plan" ||
        arguments[0] == "shards")
        return with_mpi(arguments);
    try {
        return alone(arguments);
    } catch (InputError const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    } catch (std::exception const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
