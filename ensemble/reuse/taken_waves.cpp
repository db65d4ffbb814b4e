#include "ensemble/reuse/taken_waves.hpp"

#include "demens/base/error.hpp"
#include "ensemble/reuse/rows_that_hold.hpp"
#include "ensemble/session.hpp"
#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <map>

namespace demens::ensemble {
namespace {

bool has_effect(RunRecord const& run)
{
    return std::any_of(run.amplitudes.begin(), run.amplitudes.end(),
                       [](double amplitude) { return amplitude != 0; });
}

//! All effects that act in the runs, each once.
std::vector<Effect> effects_in(std::vector<RunRecord> const& runs)
{
    std::vector<Effect> effects;
    for (auto const& run : runs)
        for (std::size_t k = 0; k < run.amplitudes.size(); ++k)
            if (auto const& effect = run.effects->at(k);
                run.amplitudes[k] != 0 &&
                std::none_of(effects.begin(), effects.end(),
                             [&](auto const& known) { return toml_text({known}) == toml_text({effect}); }))
                effects.push_back(effect);
    return effects;
}

std::vector<double> amplitudes_of(RunRecord const& run, std::vector<Effect> const& effects)
{
    std::vector<double> amplitudes(effects.size(), 0.0);
    for (std::size_t k = 0; k < run.amplitudes.size(); ++k)
        for (std::size_t j = 0; j < effects.size(); ++j)
            if (run.amplitudes[k] != 0 && toml_text({effects[j]}) == toml_text({run.effects->at(k)}))
                amplitudes[j] = run.amplitudes[k];
    return amplitudes;
}

//! Runs as a wave: those of the same factors and amplitudes are repetitions of one design point, as many as
//! the experiment has replicates, then of the next.
class WaveMaker
{
  public:
    WaveMaker(CampaignInput const& here, WavePurpose purpose, std::string const& source)
        : here_(here), purpose_(purpose), source_(source)
    {
    }

    void add(std::vector<RunRecord> const& runs)
    {
        effects_ = std::make_shared<std::vector<Effect> const>(effects_in(runs));
        std::map<std::vector<double>, std::map<int, int>>
            counts; // by factors and amplitudes, then experiment
        std::map<std::pair<std::vector<double>, int>, std::size_t> places;
        for (auto const& run : runs) {
            auto amplitudes = amplitudes_of(run, *effects_);
            auto key = run.factors;
            key.insert(key.end(), amplitudes.begin(), amplitudes.end());
            int const replicates = here_.experiments.at(static_cast<std::size_t>(run.experiment)).replicates;
            int const count = counts[key][run.experiment]++;
            auto const [place, is_new] = places.try_emplace({key, count / replicates}, points_.size());
            if (is_new)
                points_.emplace_back();
            auto& taken = points_[place->second].emplace_back(run);
            taken.replicate = count % replicates;
            taken.effects = effects_->empty() ? nullptr : effects_;
            taken.amplitudes = effects_->empty() ? std::vector<double>{} : std::move(amplitudes);
        }
    }

    //! Numbers of the runs in the order of the wave, as they came.
    std::vector<int> runs_there() const
    {
        std::vector<int> numbers;
        for (auto const& point : points_)
            for (auto const& run : point)
                numbers.push_back(run.run);
        return numbers;
    }

    Wave wave(int number, int first_run, int first_point) const
    {
        Wave wave;
        wave.number = number;
        wave.purpose = purpose_;
        wave.taken_from = source_;
        for (std::size_t p = 0; p < points_.size(); ++p)
            for (auto run : points_[p]) {
                run.run = first_run++;
                run.wave = number;
                run.point = first_point + static_cast<int>(p);
                run.start_time = 0;
                run.group = -1;
                wave.runs.push_back(std::move(run));
            }
        return wave;
    }

  private:
    CampaignInput const& here_;
    WavePurpose purpose_;
    std::string const& source_;
    std::shared_ptr<std::vector<Effect> const> effects_;
    std::vector<std::vector<RunRecord>> points_;
};

} // namespace

std::vector<Wave> taken_waves(CampaignInput const& here, std::vector<RunRecord> const& runs,
                              std::string const& source)
{
    std::vector<Wave> waves;
    int next_run = 0, next_point = 0;
    for (bool const with_effects : {false, true}) {
        std::vector<RunRecord> chosen;
        std::copy_if(runs.begin(), runs.end(), std::back_inserter(chosen),
                     [&](auto const& run) { return has_effect(run) == with_effects; });
        if (chosen.empty())
            continue;
        WaveMaker maker(here, with_effects ? WavePurpose::signatures : WavePurpose::design, source);
        maker.add(chosen);
        waves.push_back(maker.wave(static_cast<int>(waves.size()), next_run, next_point));
        next_run = waves.back().runs.back().run + 1;
        next_point = waves.back().runs.back().point + 1;
    }
    return waves;
}

std::vector<KeptWave> kept_waves(CampaignInput const& here, std::vector<RunRecord> const& runs,
                                 Campaign const& there, std::string const& source)
{
    std::vector<KeptWave> kept;
    int next_run = 0, next_point = 0;
    for (auto const& other : there.waves) {
        std::vector<RunRecord> chosen;
        std::copy_if(runs.begin(), runs.end(), std::back_inserter(chosen),
                     [&](auto const& run) { return run.wave == other.number; });
        if (chosen.empty())
            continue;
        WaveMaker maker(here, other.purpose, source);
        maker.add(chosen);
        kept.push_back({maker.wave(static_cast<int>(kept.size()), next_run, next_point), maker.runs_there()});
        next_run = kept.back().wave.runs.back().run + 1;
        next_point = kept.back().wave.runs.back().point + 1;
    }
    return kept;
}

std::string source_text(std::filesystem::path const& file, std::filesystem::path const& called)
{
    return fmt::format("{}, CRC-32 {:08x}", called.filename().string(), crc32_of(read_bytes(file)));
}

Taken taken_from_bank(CampaignInput const& here, std::filesystem::path const& bank, Rigs const& rigs)
{
    auto const there = read_campaign_file(bank, rigs);
    auto const rows = rows_that_hold(here, there);
    for (int e = 0; e < static_cast<int>(here.experiments.size()); ++e)
        if (auto const& experiment = here.experiments[static_cast<std::size_t>(e)];
            experiment.role == ExperimentRole::calibrate && rows.of(e) == 0)
            throw InputError(
                fmt::format("run.bank = \"{}\": none of its {} runs holds for the experiment {}{}{}",
                            bank.string(), there.runs_planned(), experiment.name,
                            rows.differences.empty() ? "; it has none that has ended" : ":\n  ",
                            fmt::join(rows.differences, "\n  ")));
    auto const source = source_text(bank, bank);
    Taken taken{taken_waves(here, rows.runs, source), {}};
    taken.lines.push_back(fmt::format("{} of the {} runs of {} are taken over", rows.runs.size(),
                                      there.runs_planned(), source));
    for (auto const& difference : rows.differences)
        taken.lines.push_back(fmt::format("{}: {}", bank.filename().string(), difference));
    return taken;
}

} // namespace demens::ensemble
