#include "report/shown_run.hpp"

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

} // namespace demens::report
