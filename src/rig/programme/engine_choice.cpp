#include "demens/rig/engine_choice.hpp"

#include "demens/dem/engine.hpp"

namespace demens::rig {

std::string needs_cpu(EngineNeeds const& needs)
{
    if (needs.rigid_bodies)
        return "its grains are not spheres ([shape.NAME])";
    if (needs.removal)
        return "particles are taken out of it (outlet)";
    return needs.team ? "several ranks share a run (run.ranks_per_group)" : "";
}

dem::EngineKind chosen_engine(EngineChoice choice, EngineNeeds const& needs)
{
    auto const obstacle = needs_cpu(needs);
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
