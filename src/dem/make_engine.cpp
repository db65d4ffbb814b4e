// The one place that knows which engines there are.
#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "demens/dem/device_batch.hpp"
#include "demens/dem/engine.hpp"
#include "src/dem/cpu/cpu_engine.hpp"
#include "src/dem/cuda/batch_engine.hpp"

namespace demens::dem {
namespace {

//! In the batch that the options name, or one to itself; with what else the engine is made of.
template <class... More>
std::unique_ptr<Engine> make_batch_engine(contact::Model const& model, SimulationOptions const& options,
                                          More const&... more)
{
    if (!is_present(options.engine))
        throw InputError(
            "the engine \"cuda\" needs a CUDA device, and there is none that this process can use; "
            "use the engine \"cpu\", or \"auto\", which takes a device where there is one");
    if (options.batch == nullptr)
        return std::make_unique<cuda::BatchEngine>(DeviceBatch(options.engine, 0, 1).batch(), 0, model,
                                                   options, more...);
    DEMENS_EXPECT(options.engine == options.batch->kind(), "an engine joins a batch of its kind");
    auto const& batch = options.batch->batch();
    return std::make_unique<cuda::BatchEngine>(batch, batch->free_slot(), model, options, more...);
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
    bool const is_of_device = cuda::SlotState::is_in(record);
    if (is_of_device != (options.engine != EngineKind::cpu))
        throw InputError(is_of_device ? "the state record is of the engine \"cuda\", and this is \"cpu\": a "
                                        "simulation goes on where it began"
                                      : "the state record is of the engine \"cpu\", and this is \"cuda\": a "
                                        "simulation goes on where it began");
    if (is_of_device)
        return make_batch_engine(model, options, record);
    return std::make_unique<CpuEngine>(model, options, record);
}

} // namespace demens::dem
