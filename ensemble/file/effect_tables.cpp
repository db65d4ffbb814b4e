#include "ensemble/file/effect_tables.hpp"

#include "ensemble/file/run_tables.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::ensemble {

std::vector<double> rows_of(std::vector<double> RunRecord::*member, std::vector<RunRecord> const& runs)
{
    std::vector<double> rows;
    int last_point = -1;
    for (auto const& run : runs) {
        if (run.point != last_point)
            rows.insert(rows.end(), (run.*member).begin(), (run.*member).end());
        last_point = run.point;
    }
    return rows;
}

void write_effects(RowWriter& writer, Wave const& wave)
{
    auto const base = wave_path(wave.number);
    if (wave.replicates > 0)
        writer.set_attribute(base, "replicates", static_cast<std::int64_t>(wave.replicates));
    if (wave.runs.empty() || !wave.runs.front().effects)
        return;
    auto const& effects = *wave.runs.front().effects;
    std::vector<std::string> texts;
    for (auto const& effect : effects)
        texts.push_back(toml_text({effect}));
    writer.write_texts(base + "/effects", texts,
                       "effects that act in its runs, each as [[effect]] of a campaign");
    hdf5::Meaning meaning{{"1"}, {}, "amplitudes of the effects, one row for each design point"};
    for (auto const& effect : effects)
        meaning.columns.push_back(effect.name);
    writer.write(base + "/amplitudes", rows_of(&RunRecord::amplitudes, wave.runs), meaning, effects.size());
}

void read_effects(hid_t file, Wave& wave, CampaignInput const& input, std::int64_t first_point,
                  std::size_t points)
{
    auto const base = wave_path(wave.number);
    if (hdf5::has_attribute(file, base, "replicates"))
        wave.replicates = static_cast<int>(hdf5::integer_attribute(file, base, "replicates"));
    if (!hdf5::exists(file, base + "/effects"))
        return;
    std::string text;
    for (auto const& effect : hdf5::read_texts(file, base + "/effects"))
        text += effect;
    std::shared_ptr<std::vector<Effect> const> effects;
    try {
        effects = std::make_shared<std::vector<Effect> const>(input.effects_of(text, base));
    } catch (InputError const& error) {
        throw FileError(fmt::format("{}: effects: {}", base, error.what()));
    }
    auto const width = effects->size();
    auto const rows = hdf5::read<double>(file, base + "/amplitudes", {points, width});
    for (auto& run : wave.runs) {
        auto const row = rows.begin() + static_cast<std::ptrdiff_t>((run.point - first_point) *
                                                                    static_cast<std::int64_t>(width));
        run.effects = effects;
        run.amplitudes.assign(row, row + static_cast<std::ptrdiff_t>(width));
        if (!std::all_of(run.amplitudes.begin(), run.amplitudes.end(),
                         [](double value) { return std::isfinite(value); }))
            throw FileError(fmt::format("{}/amplitudes: point {} is not a number", base, run.point));
    }
}

} // namespace demens::ensemble
