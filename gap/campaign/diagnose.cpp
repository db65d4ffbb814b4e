#include "gap/campaign/diagnose.hpp"

#include "ensemble/mpi/agreement.hpp"
#include "gap/campaign/bank_plan.hpp"
#include "gap/campaign/next_wave.hpp"

#include <algorithm>
#include <functional>

namespace demens::gap {
namespace {

using ensemble::Campaign, ensemble::Session, ensemble::WaveEnd, ensemble::WavePlan;

//! Runs what is planned, asks rank 0 for the next wave, and so on until there is none.
WaveEnd go_on(Session& session, MPI_Comm communicator,
              std::function<std::optional<WavePlan>(Campaign const&)> const& next)
{
    while (true) {
        if (session.run_waves() == WaveEnd::drained)
            return WaveEnd::drained;
        std::optional<WavePlan> plan;
        std::vector<int> goes_on(1);
        ensemble::on_root(communicator, [&] {
            plan = next(session.campaign());
            goes_on[0] = plan.has_value();
        });
        ensemble::broadcast(communicator, goes_on);
        if (goes_on[0] == 0)
            return WaveEnd::complete;
        session.plan_wave(plan.value_or(WavePlan{}));
    }
}

int waves_of_signatures(Campaign const& campaign)
{
    return static_cast<int>(std::count_if(campaign.waves.begin(), campaign.waves.end(), [](auto const& wave) {
        return wave.purpose == ensemble::WavePurpose::signatures;
    }));
}

bool has_candidates(Campaign const& campaign)
{
    return !cells_of(campaign.input, ensemble::ExperimentRole::consider).empty();
}

} // namespace

WaveEnd diagnose(Session& session, MPI_Comm communicator)
{
    return go_on(session, communicator, next_wave);
}

WaveEnd plan_ahead(Session& session, MPI_Comm communicator)
{
    return go_on(session, communicator, [](Campaign const& campaign) -> std::optional<WavePlan> {
        int const looks = waves_of_signatures(campaign);
        if (looks == 0)
            return screening_wave(campaign, Centre::middle);
        if (looks == 1 && has_candidates(campaign))
            return candidate_wave(campaign, Diagnosis(campaign, Centre::middle));
        return std::nullopt;
    });
}

WaveEnd fill_bank(Session& session, int points_per_effect, MPI_Comm communicator)
{
    return go_on(session, communicator, [points_per_effect](Campaign const& campaign) {
        return next_bank_wave(campaign, points_per_effect);
    });
}

} // namespace demens::gap
