#include "src/dem/cuda/device.hpp"
#include "src/dem/cuda/kernels_of_step.hpp"
#include "src/dem/cuda/move_kernel.hpp"
#include "src/dem/cuda/search_kernels.hpp"

#include <cstdlib>
#include <cstring>
#include <new>

namespace demens::dem::cuda {
namespace {

//! Kernels as loops.
struct Loops
{
    Room room;

    template <class Kernel>
    void over(std::uint32_t count, Kernel const& kernel) const
    {
        for (std::uint32_t slot = 0; slot < room.slots; ++slot)
            for (std::uint32_t local = 0; local < count; ++local)
                kernel(Where{slot, local});
    }
    template <class Kernel>
    void over_teams(Kernel const& kernel) const
    {
        TeamQueue queue;
        for (std::uint32_t slot = 0; slot < room.slots; ++slot)
            for (std::uint32_t first = 0; first < room.particles; first += team_size)
                kernel(HostTeam{slot, first}, queue);
    }
    template <class Kernel>
    void over_replicas(Kernel const& kernel) const
    {
        over(1, kernel);
    }
};

class HostDevice final : public Device
{
  public:
    std::string name() const override { return "host"; }
    std::size_t free_memory() const override { return std::size_t{1} << 30; } // tests need no more

    void* allocate(std::size_t bytes) override
    {
        void* const memory = std::calloc(bytes > 0 ? bytes : 1, 1);
        if (memory == nullptr)
            throw std::bad_alloc();
        return memory;
    }
    void release(void* memory) override { std::free(memory); }
    void write(void* to, void const* from, std::size_t bytes) override { copy(to, from, bytes); }
    void read(void* to, void const* from, std::size_t bytes) override { copy(to, from, bytes); }
    void read(std::span<Piece const> pieces) override
    {
        for (Piece const& piece : pieces)
            copy(piece.to, piece.from, piece.bytes);
    }

    void advance(View const& view, LawKernels kernels, std::uint32_t launches, bool search_first) override
    {
        Loops const loops{view.room};
        if (search_first)
            search(view, loops);
        for (std::uint32_t k = 0; k < launches; ++k) {
            if (view.room.has_ledger)
                loops.over(view.room.particles, TallyPairs{view});
            with_kernels(view, kernels, [&](auto const& step, auto const& outer) {
                if (view.room.has_outer_loads)
                    loops.over(view.room.particles, outer);
                loops.over_teams(step);
            });
            bool wanted = false;
            loops.over_replicas([&](Where const& where) { wanted |= Tick{view}(where); });
            if (wanted)
                search(view, loops);
        }
    }
    void move(View const& from, View const& to) override
    {
        Loops{from.room}.over(from.room.particles, MoveParticle{from, to});
    }

  private:
    static void copy(void* to, void const* from, std::size_t bytes)
    {
        if (bytes > 0)
            std::memcpy(to, from, bytes);
    }
};

} // namespace

std::unique_ptr<Device> make_host_device()
{
    return std::make_unique<HostDevice>();
}

} // namespace demens::dem::cuda
