#include "demens/rig/engine_choice.hpp"

#include "demens/dem/engine.hpp"
#include "demens/rig/programme/programme.hpp"

namespace demens::rig {

std::string needs_cpu(Apparatus const& apparatus, bool with_team)
{
    if (with_team)
        return "several ranks share a run (run.ranks_per_group)";
    if (apparatus.options.energy_ledger)
        return "its energy is accounted for (energy_ledger)";
    return "";
}

dem::EngineKind chosen_engine(EngineChoice choice, Apparatus const& apparatus, bool with_team)
{
    auto const obstacle = needs_cpu(apparatus, with_team);
    switch (choice) {
    case EngineChoice::cpu:
        return dem::EngineKind::cpu;
    case EngineChoice::automatic:
        return obstacle.empty() && dem::is_present(dem::EngineKind::cuda) ? dem::EngineKind::cuda
                                                                          : dem::EngineKind::cpu;
    case EngineChoice::cuda:
    case EngineChoice::cuda_on_host:
        break;
    }
    if (!obstacle.empty())
        throw InputError("run.engine = \"" + std::string(word_for(choice)) + "\" cannot do this run: " +
                         obstacle + "; give \"cpu\", or \"auto\", which takes the CPU for such runs");
    return choice == EngineChoice::cuda ? dem::EngineKind::cuda : dem::EngineKind::cuda_on_host;
}

} // namespace demens::rig
