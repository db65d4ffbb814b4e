// The one place that knows which engines there are.
#include "demens/base/error.hpp"
#include "demens/dem/engine.hpp"
#include "src/dem/cpu/cpu_engine.hpp"
#include "src/dem/cuda/batch_engine.hpp"

namespace demens::dem {
namespace {

//! A batch of one.
std::unique_ptr<Engine> make_batch_engine(contact::Model const& model, SimulationOptions const& options)
{
    if (!is_present(options.engine))
        throw InputError(
            "the engine \"cuda\" needs a CUDA device, and there is none that this process can use; "
            "use the engine \"cpu\", or \"auto\", which takes a device where there is one");
    if (options.surroundings.is_any())
        throw InputError("the engine \"cuda\" knows no drag and no vibration; use the engine \"cpu\"");
    auto device = options.engine == EngineKind::cuda ? cuda::make_cuda_device() : cuda::make_host_device();
    auto batch = std::make_shared<cuda::Batch>(std::move(device), 1);
    return std::make_unique<cuda::BatchEngine>(std::move(batch), 0, model, options);
}

} // namespace

bool is_present(EngineKind kind)
{
    return kind != EngineKind::cuda || cuda::has_cuda_device();
}

std::unique_ptr<Engine> make_engine(contact::Model const& model, SimulationOptions const& options)
{
    switch (options.engine) {
    case EngineKind::cpu:
        return std::make_unique<CpuEngine>(model, options);
    case EngineKind::cuda:
    case EngineKind::cuda_on_host:
        return make_batch_engine(model, options);
    }
    throw InputError("no engine of this kind in this build");
}

std::unique_ptr<Engine> make_engine(contact::Model const& model, SimulationOptions const& options,
                                    StateRecord const& record)
{
    if (options.engine != EngineKind::cpu)
        throw InputError("a simulation goes on from its record on the engine \"cpu\" only");
    return std::make_unique<CpuEngine>(model, options, record);
}

} // namespace demens::dem
