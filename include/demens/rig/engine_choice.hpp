#pragma once

#include "demens/base/words.hpp"
#include "demens/dem/simulation_options.hpp"

#include <cstdint>

namespace demens::rig {

//! Which engine computes a run, as a campaign says it.
enum class EngineChoice : std::uint8_t
{
    cpu,
    cuda,
    cuda_on_host, //!< for tests
    automatic     //!< a CUDA device where there is one that can do the run, else the CPU
};

//! What a run needs that not every engine can do.
struct EngineNeeds
{
    bool team = false;         //!< several ranks share it
    bool rigid_bodies = false; //!< grains of several spheres, or polyhedra
    bool removal = false;      //!< particles are taken out
};

//! What a run needs that only the CPU's engine can do, in words; empty: nothing.
std::string needs_cpu(EngineNeeds const& needs);
//! \throws InputError where the engine that is asked for cannot do it.
dem::EngineKind chosen_engine(EngineChoice choice, EngineNeeds const& needs);

} // namespace demens::rig

namespace demens {

template <>
inline std::vector<Word<rig::EngineChoice>> const& words_of()
{
    using enum rig::EngineChoice;
    static std::vector<Word<rig::EngineChoice>> const words = {
        {cpu, "cpu"}, {cuda, "cuda"}, {cuda_on_host, "cuda_on_host"}, {automatic, "auto"}};
    return words;
}

} // namespace demens
