// The one place that knows which engines there are.
#include "demens/dem/engine.hpp"
#include "src/dem/cpu/cpu_engine.hpp"

namespace demens::dem {

std::unique_ptr<Engine> make_engine(contact::Model const& model, SimulationOptions const& options)
{
    switch (options.engine) {
    case EngineKind::cpu:
        return std::make_unique<CpuEngine>(model, options);
    }
    throw InputError("no engine of this kind in this build");
}

std::unique_ptr<Engine> make_engine(contact::Model const& model, SimulationOptions const& options,
                                    StateRecord const& record)
{
    switch (options.engine) {
    case EngineKind::cpu:
        return std::make_unique<CpuEngine>(model, options, record);
    }
    throw InputError("no engine of this kind in this build");
}

} // namespace demens::dem
