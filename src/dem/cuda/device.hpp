#pragma once

#include "demens/dem/device_batch.hpp"
#include "src/dem/cuda/known_laws.hpp"
#include "src/dem/cuda/view.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace demens::dem::cuda {

//! What memory and kernels are on: a CUDA device, or this process, where the same kernels are loops. All the
//! rest of a batch is the same for both.
class Device
{
  public:
    virtual ~Device() = default;

    virtual std::string name() const = 0;
    virtual std::size_t free_memory() const = 0; //!< [B]

    //! Zeros. \throws std::bad_alloc
    virtual void* allocate(std::size_t bytes) = 0;
    virtual void release(void* memory) = 0;
    virtual void write(void* to, void const* from, std::size_t bytes) = 0; //!< to the device
    virtual void read(void* to, void const* from, std::size_t bytes) = 0;  //!< to the host; waits
    struct Piece
    {
        void* to;
        void const* from;
        std::size_t bytes;
    };
    //! Several at once, while nothing is under way; different threads can at a time.
    virtual void read(std::span<Piece const> pieces) = 0;

    //! So many launches of each of these step kernels, with searches where replicas want them; before the
    //! first one where `search_first`. Does not wait.
    virtual void advance(View const& view, LawKernels kernels, std::uint32_t launches, bool search_first) = 0;
    //! Copies all particles with their lists and histories into larger arrays.
    virtual void move(View const& from, View const& to) = 0;
};

//! The kernels as loops of this process.
std::unique_ptr<Device> make_host_device();
//! A CUDA device that this process sees. \throws DeviceError where there is none of this number, or where
//! this build has no code for one.
std::unique_ptr<Device> make_cuda_device(int number = 0);
//! How many there are.
int cuda_devices();
inline bool has_cuda_device()
{
    return cuda_devices() > 0;
}

} // namespace demens::dem::cuda
