#include "ensemble/campaign.hpp"

#include <algorithm>

namespace demens {

template <>
std::vector<Word<ensemble::WavePurpose>> const& words_of()
{
    using enum ensemble::WavePurpose;
    static std::vector<Word<ensemble::WavePurpose>> const words = {
        {screening, "screening"},       {design, "design"},         {search, "search"},
        {confirmation, "confirmation"}, {signatures, "signatures"}, {closure, "closure"}};
    return words;
}

} // namespace demens

namespace demens::ensemble {

NamedArray const* Wave::find(stored::ArrayName const& name) const
{
    auto const found = std::find_if(analysis.begin(), analysis.end(),
                                    [&](auto const& array) { return array.path == name.path; });
    return found == analysis.end() ? nullptr : &*found;
}

bool is_complete(Wave const& wave)
{
    return std::none_of(wave.runs.begin(), wave.runs.end(),
                        [](RunRecord const& run) { return run.status == rig::RunStatus::not_run; });
}

double time_in_runs(Wave const& wave)
{
    double sum = 0;
    for (auto const& run : wave.runs)
        sum += run.wall_time;
    return sum;
}

double time_of_groups(Wave const& wave)
{
    return wave.groups * (wave.time_before + wave.wall_time);
}

Wave const* Campaign::open_wave() const
{
    auto const found =
        std::find_if(waves.begin(), waves.end(), [](auto const& wave) { return !is_complete(wave); });
    return found == waves.end() ? nullptr : &*found;
}

int Campaign::runs_planned() const
{
    int count = 0;
    for (auto const& wave : waves)
        count += static_cast<int>(wave.runs.size());
    return count;
}

int Campaign::points_planned() const
{
    int next_point = 0;
    for (auto const& wave : waves)
        for (auto const& run : wave.runs)
            next_point = std::max(next_point, run.point + 1);
    return next_point;
}

int Campaign::runs_left() const
{
    int runs = 0;
    for (auto const& wave : waves)
        if (wave.number >= first_counted_wave() && wave.taken_from.empty())
            runs += static_cast<int>(wave.runs.size());
    return std::max(0, input.stop.runs - runs);
}

std::vector<RunRecord> Campaign::all_runs() const
{
    std::vector<RunRecord> runs;
    for (auto const& wave : waves)
        runs.insert(runs.end(), wave.runs.begin(), wave.runs.end());
    return runs;
}

} // namespace demens::ensemble
