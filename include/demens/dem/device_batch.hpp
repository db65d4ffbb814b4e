#pragma once

#include "demens/dem/simulation_options.hpp"

#include <cstdint>
#include <memory>
#include <stdexcept>

namespace demens::dem {

namespace cuda {
class Batch;
}

//! The device cannot be used any more, e.g. since a kernel failed; nothing that is on it can go on.
class [[gnu::visibility("default")]] DeviceError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

//! Simulations that one device advances together: those whose options name the batch take a slot each, ask
//! for steps (`Simulation::advance_later`), and get them all at once. What a simulation does depends neither
//! on its slot nor on the others. One that goes wrong is left behind; an empty slot can be taken at any time.
class DeviceBatch
{
  public:
    //! \param kind of engine, not the CPU's
    //! \param device number among those that this process sees
    //! \throws DeviceError where there is no such device
    DeviceBatch(EngineKind kind, int device, std::uint32_t slots);
    ~DeviceBatch();
    DeviceBatch(DeviceBatch const&) = delete;
    DeviceBatch& operator=(DeviceBatch const&) = delete;

    EngineKind kind() const { return kind_; }
    std::uint32_t slots() const;
    std::uint32_t free_slots() const;

    //! Does the steps that were asked for. \throws std::bad_alloc, DeviceError; then all simulations of the
    //! batch are lost
    void advance();

    //! For engines.
    std::shared_ptr<cuda::Batch> const& batch() const { return batch_; }

  private:
    EngineKind kind_;
    std::shared_ptr<cuda::Batch> batch_;
};

//! Devices that this process sees.
int device_count();
//! Simulations of so many particles for which a device has memory, at least one. \throws DeviceError
std::uint32_t simulations_that_fit(EngineKind kind, int device, double particles);

} // namespace demens::dem
