#include "demens/dem/device_batch.hpp"

#include "src/dem/cuda/batch.hpp"

#include <algorithm>

namespace demens::dem {
namespace {

//! Of a particle: a list of 32 neighbours with histories of eight numbers, twice, and the rest [B].
constexpr double bytes_a_particle = 6500;
constexpr double usable = 0.7; //!< of the memory that is free; arrays that grow are there twice meanwhile

std::unique_ptr<cuda::Device> make_device(EngineKind kind, int number)
{
    return kind == EngineKind::cuda ? cuda::make_cuda_device(number) : cuda::make_host_device();
}

} // namespace

DeviceBatch::DeviceBatch(EngineKind kind, int device, std::uint32_t slots)
    : kind_(kind), batch_(std::make_shared<cuda::Batch>(make_device(kind, device), slots))
{
}

DeviceBatch::~DeviceBatch() = default;

std::uint32_t DeviceBatch::slots() const
{
    return batch_->slots();
}

std::uint32_t DeviceBatch::free_slots() const
{
    return batch_->free_slots();
}

void DeviceBatch::advance()
{
    batch_->advance_asked();
}

int device_count()
{
    return cuda::cuda_devices();
}

std::uint32_t simulations_that_fit(EngineKind kind, int device, double particles)
{
    double const memory = usable * static_cast<double>(make_device(kind, device)->free_memory());
    return static_cast<std::uint32_t>(
        std::clamp(memory / (bytes_a_particle * std::max(particles, 128.0)), 1.0, 65536.0));
}

} // namespace demens::dem
