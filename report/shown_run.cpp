#include "report/shown_run.hpp"

#include "report/analysis.hpp"

namespace demens::report {

ensemble::RunRecord const* shown_run(ensemble::Campaign const& campaign, int experiment,
                                     ensemble::NamedArray const* best_point)
{
    ensemble::RunRecord const* last = nullptr;
    for (auto const& wave : campaign.waves) {
        for (auto const& run : wave.runs) {
            if (run.experiment != experiment || run.status != rig::RunStatus::finished)
                continue;
            if (best_point && run.factors == best_point->data)
                return &run;
            last = &run;
        }
    }
    return last;
}

std::vector<int> shown_runs(ensemble::Campaign const& campaign)
{
    Analysis const analysis(campaign);
    auto const* best_point = analysis.find(ensemble::stored::optimum::best_point);
    std::vector<int> runs;
    for (std::size_t e = 0; e < campaign.input.experiments.size(); ++e)
        if (auto const* run = shown_run(campaign, static_cast<int>(e), best_point))
            runs.push_back(run->run);
    return runs;
}

} // namespace demens::report
