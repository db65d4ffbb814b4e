#pragma once

#include "demens/base/macros.hpp"
#include "src/dem/cuda/view.hpp"

#include <array>
#include <cstdint>

namespace demens::dem::cuda {

// Neighbouring particles that share their work: as many lanes, which work in phases. What one phase writes to
// shared memory the next one reads. On a device the lanes are threads, on the host one lane works after
// another.

//! Lanes of a team: as many as threads of a block.
constexpr std::uint32_t team_size = block_size;

//! A team on the host.
struct HostTeam
{
    std::uint32_t slot;  //!< of the replica
    std::uint32_t first; //!< number of the first lane's particle in the replica

    //! What each lane keeps from phase to phase.
    template <class T>
    using Own = std::array<T, team_size>;

    //! A phase: `work(lane)`.
    template <class Work>
    void each(Work&& work) const
    {
        for (std::uint32_t lane = 0; lane < team_size; ++lane)
            work(lane);
    }
    //! A phase: `work(k)` for k < count, dealt to the lanes.
    template <class Work>
    void deal(std::uint32_t count, Work&& work) const
    {
        for (std::uint32_t k = 0; k < count; ++k)
            work(k);
    }
    //! Makes numbers of lanes the sums of those of the lanes before them; returns the sum of all.
    std::uint32_t add_up(Own<std::uint32_t>& numbers) const
    {
        std::uint32_t sum = 0;
        for (std::uint32_t& number : numbers) {
            std::uint32_t const own = number;
            number = sum;
            sum += own;
        }
        return sum;
    }
};

#if defined(__CUDACC__)
//! A block of a device. Every phase ends with a barrier of the block, so that all of its threads must come to
//! each phase, and each phase reads what the ones before it have written.
struct BlockTeam
{
    std::uint32_t slot, first;
    std::uint32_t lane; //!< this thread's

    template <class T>
    struct Own
    {
        T value;

        __device__ T& operator[](std::uint32_t) { return value; }
    };

    template <class Work>
    __device__ void each(Work&& work) const
    {
        work(lane);
        __syncthreads();
    }
    template <class Work>
    __device__ void deal(std::uint32_t count, Work&& work) const
    {
        for (std::uint32_t k = lane; k < count; k += team_size)
            work(k);
        __syncthreads();
    }
    __device__ std::uint32_t add_up(Own<std::uint32_t>& numbers) const
    {
        __shared__ std::uint32_t sums[team_size / 32];
        constexpr unsigned all = 0xffffffff; // lanes of a warp
        std::uint32_t const of_warp = lane % 32, warp = lane / 32;
        std::uint32_t sum = numbers.value;
        for (std::uint32_t distance = 1; distance < 32; distance *= 2) {
            std::uint32_t const before = __shfl_up_sync(all, sum, distance);
            sum += of_warp >= distance ? before : 0;
        }
        if (of_warp == 31)
            sums[warp] = sum;
        __syncthreads();
        std::uint32_t before = 0, total = 0;
        for (std::uint32_t k = 0; k < team_size / 32; ++k) {
            before += k < warp ? sums[k] : 0;
            total += sums[k];
        }
        numbers.value = before + sum - numbers.value;
        __syncthreads();
        return total;
    }
};
#endif

} // namespace demens::dem::cuda
