#include "src/dem/cuda/device.hpp"
#include "src/dem/cuda/kernels_of_step.hpp"
#include "src/dem/cuda/move_kernel.hpp"
#include "src/dem/cuda/search_kernels.hpp"

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <map>
#include <new>
#include <utility>

#define DEMENS_VISIBLE __attribute__((visibility("default")))

//! Blocks of the step kernel that a multiprocessor is to hold at once: bounds its registers.
#if !defined(DEMENS_MIN_BLOCKS)
#define DEMENS_MIN_BLOCKS 4
#endif

namespace demens::dem::cuda {
namespace {

void require(cudaError_t status)
{
    if (status != cudaSuccess)
        throw DeviceError(std::string("CUDA: ") + cudaGetErrorString(status));
}

//! A block has particles, or cells, of one slot.
template <class Kernel>
__global__ void __launch_bounds__(block_size) over_slots(Kernel const kernel, std::uint32_t blocks_of_slot)
{
    std::uint32_t const slot = blockIdx.x / blocks_of_slot;
    kernel(Where{slot, (blockIdx.x - slot * blocks_of_slot) * block_size + threadIdx.x});
}
template <class Kernel>
__global__ void __launch_bounds__(block_size) over_replicas(Kernel const kernel, std::uint32_t slots)
{
    std::uint32_t const slot = blockIdx.x * block_size + threadIdx.x;
    if (slot < slots)
        kernel(Where{slot, 0});
}
template <class Kernel>
__global__ void __launch_bounds__(block_size, DEMENS_MIN_BLOCKS)
    step_kernel(Kernel const kernel, std::uint32_t blocks_of_slot)
{
    __shared__ TeamQueue queue;
    std::uint32_t const slot = blockIdx.x / blocks_of_slot, block = blockIdx.x - slot * blocks_of_slot;
    kernel(BlockTeam{slot, block * team_size, threadIdx.x}, queue);
}
//! Lets the search that follows take place where it is wanted.
__global__ void __launch_bounds__(block_size)
    tick_kernel(Tick const tick, std::uint32_t slots, cudaGraphConditionalHandle search)
{
    std::uint32_t const slot = blockIdx.x * block_size + threadIdx.x;
    if (slot < slots && tick(Where{slot, 0}))
        cudaGraphSetConditional(search, 1);
}

//! The same for a host that looks.
__global__ void __launch_bounds__(block_size)
    tick_kernel(Tick const tick, std::uint32_t slots, std::uint32_t* search)
{
    std::uint32_t const slot = blockIdx.x * block_size + threadIdx.x;
    if (slot < slots && tick(Where{slot, 0}))
        *search = 1;
}

//! These step kernels, and those before them where they are needed.
void launch_step(View const& view, LawKernels kernels, cudaStream_t stream)
{
    std::uint32_t const blocks = view.room.particles / block_size;
    if (view.room.has_ledger)
        over_slots<<<view.room.slots * blocks, block_size, 0, stream>>>(TallyPairs{view}, blocks);
    with_kernels(view, kernels, [&](auto const& step, auto const& outer) {
        if (view.room.has_outer_loads)
            over_slots<<<view.room.slots * blocks, block_size, 0, stream>>>(outer, blocks);
        step_kernel<<<view.room.slots * blocks, block_size, 0, stream>>>(step, blocks);
        require(cudaGetLastError());
    });
}

struct Launches
{
    Room room;
    cudaStream_t stream;

    template <class Kernel>
    void over(std::uint32_t count, Kernel const& kernel) const
    {
        std::uint32_t const blocks = (count + block_size - 1) / block_size;
        over_slots<<<room.slots * blocks, block_size, 0, stream>>>(kernel, blocks);
        require(cudaGetLastError());
    }
    template <class Kernel>
    void over_replicas(Kernel const& kernel) const
    {
        cuda::over_replicas<<<(room.slots + block_size - 1) / block_size, block_size, 0, stream>>>(
            kernel, room.slots);
        require(cudaGetLastError());
    }
};

//! Several steps as one graph: the search in it is left out where no replica wants it, without the host.
class StepGraph
{
  public:
    StepGraph(View const& view, LawKernels kernels, std::uint32_t steps, cudaStream_t stream)
    {
        require(cudaGraphCreate(&graph_, 0));
        require(
            cudaStreamBeginCaptureToGraph(stream, graph_, nullptr, nullptr, 0, cudaStreamCaptureModeRelaxed));
        for (std::uint32_t k = 0; k < steps; ++k)
            capture_step(view, kernels, stream);
        cudaGraph_t same = nullptr;
        require(cudaStreamEndCapture(stream, &same));
        require(cudaGraphInstantiate(&executable_, graph_, 0));
    }
    ~StepGraph()
    {
        cudaGraphExecDestroy(executable_);
        cudaGraphDestroy(graph_);
    }
    StepGraph(StepGraph const&) = delete;

    void launch(cudaStream_t stream) const { require(cudaGraphLaunch(executable_, stream)); }

  private:
    void capture_step(View const& view, LawKernels kernels, cudaStream_t stream)
    {
        launch_step(view, kernels, stream);
        cudaGraphConditionalHandle wanted;
        require(cudaGraphConditionalHandleCreate(&wanted, graph_, 0, cudaGraphCondAssignDefault));
        std::uint32_t const slots = view.room.slots;
        tick_kernel<<<(slots + block_size - 1) / block_size, block_size, 0, stream>>>(Tick{view}, slots,
                                                                                      wanted);
        require(cudaGetLastError());

        cudaStreamCaptureStatus status;
        cudaGraphNode_t const* before = nullptr;
        cudaGraphEdgeData const* edges = nullptr;
        std::size_t count = 0;
        require(cudaStreamGetCaptureInfo(stream, &status, nullptr, nullptr, &before, &edges, &count));
        cudaGraphNodeParams params = {};
        params.type = cudaGraphNodeTypeConditional;
        params.conditional.handle = wanted;
        params.conditional.type = cudaGraphCondTypeIf;
        params.conditional.size = 1;
        cudaGraphNode_t node;
        require(cudaGraphAddNode(&node, graph_, before, edges, count, &params));
        require(
            cudaStreamUpdateCaptureDependencies(stream, &node, nullptr, 1, cudaStreamSetCaptureDependencies));

        cudaStream_t inner;
        require(cudaStreamCreateWithFlags(&inner, cudaStreamNonBlocking));
        cudaGraph_t body = params.conditional.phGraph_out[0];
        require(
            cudaStreamBeginCaptureToGraph(inner, body, nullptr, nullptr, 0, cudaStreamCaptureModeRelaxed));
        search(view, Launches{view.room, inner});
        require(cudaStreamEndCapture(inner, &body));
        require(cudaStreamDestroy(inner));
    }

    cudaGraph_t graph_ = nullptr;
    cudaGraphExec_t executable_ = nullptr;
};

//! Memory of the host that devices write to without a copy on the way, kept by each thread.
class Staging
{
  public:
    static void* of_thread(std::size_t bytes)
    {
        thread_local Staging staging;
        if (bytes > staging.bytes_) {
            cudaFreeHost(std::exchange(staging.memory_, nullptr));
            staging.bytes_ = 0;
            require(cudaHostAlloc(&staging.memory_, 2 * bytes, cudaHostAllocPortable));
            staging.bytes_ = 2 * bytes;
        }
        return staging.memory_;
    }
    ~Staging() { cudaFreeHost(memory_); }

  private:
    void* memory_ = nullptr;
    std::size_t bytes_ = 0;
};

class CudaDevice final : public Device
{
  public:
    explicit CudaDevice(int number) : number_(number)
    {
        require(cudaSetDevice(number_));
        require(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking));
        require(cudaMalloc(&wanted_, sizeof *wanted_));
        int driver = 0;
        require(cudaDriverGetVersion(&driver));
        has_conditional_graphs_ = driver >= 12040 && std::getenv("DEMENS_CUDA_NO_GRAPHS") == nullptr;
    }
    ~CudaDevice() override
    {
        graphs_.clear();
        cudaFree(wanted_);
        cudaStreamDestroy(stream_);
    }

    std::string name() const override
    {
        cudaDeviceProp properties;
        require(cudaGetDeviceProperties(&properties, number_));
        return properties.name;
    }
    std::size_t free_memory() const override
    {
        std::size_t free = 0, all = 0;
        require(cudaSetDevice(number_));
        require(cudaMemGetInfo(&free, &all));
        return free;
    }

    void* allocate(std::size_t bytes) override
    {
        require(cudaSetDevice(number_));
        void* memory = nullptr;
        if (cudaMalloc(&memory, bytes > 0 ? bytes : 1) != cudaSuccess) {
            cudaGetLastError();
            throw std::bad_alloc();
        }
        require(cudaMemsetAsync(memory, 0, bytes, stream_));
        return memory;
    }
    void release(void* memory) override
    {
        cudaStreamSynchronize(stream_);
        graphs_.clear(); // they may use it
        cudaFree(memory);
    }
    void write(void* to, void const* from, std::size_t bytes) override
    {
        require(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, stream_));
        require(cudaStreamSynchronize(stream_)); // what is written from may go away
    }
    void read(void* to, void const* from, std::size_t bytes) override
    {
        require(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, stream_));
        require(cudaStreamSynchronize(stream_));
    }

    void read(std::span<Piece const> pieces) override
    {
        std::size_t bytes = 0;
        for (Piece const& piece : pieces)
            bytes += piece.bytes;
        if (bytes == 0)
            return;
        require(cudaSetDevice(number_)); // a thread has a device of its own to begin with
        auto* staged = static_cast<std::byte*>(Staging::of_thread(bytes));
        for (Piece const& piece : pieces) {
            require(cudaMemcpyAsync(staged, piece.from, piece.bytes, cudaMemcpyDeviceToHost,
                                    cudaStreamPerThread));
            staged += piece.bytes;
        }
        require(cudaStreamSynchronize(cudaStreamPerThread));
        staged -= bytes;
        for (Piece const& piece : pieces) {
            std::memcpy(piece.to, staged, piece.bytes);
            staged += piece.bytes;
        }
    }

    void advance(View const& view, LawKernels kernels, std::uint32_t launches, bool search_first) override
    {
        require(cudaSetDevice(number_)); // a thread has a device of its own to begin with
        if (search_first)
            search(view, Launches{view.room, stream_});
        if (!has_conditional_graphs_)
            return advance_one_by_one(view, kernels, launches);
        for (std::uint32_t const steps : {16u, 1u})
            for (; launches >= steps; launches -= steps)
                graph(view, kernels, steps).launch(stream_);
    }
    void move(View const& from, View const& to) override
    {
        Launches{from.room, stream_}.over(from.room.particles, MoveParticle{from, to});
        require(cudaStreamSynchronize(stream_));
    }

  private:
    //! For drivers without conditions in graphs, and for profilers: the host looks after every step.
    void advance_one_by_one(View const& view, LawKernels kernels, std::uint32_t launches)
    {
        for (; launches > 0; --launches) {
            launch_step(view, kernels, stream_);
            std::uint32_t const slots = view.room.slots;
            std::uint32_t wanted = 0;
            require(cudaMemsetAsync(wanted_, 0, sizeof wanted, stream_));
            tick_kernel<<<(slots + block_size - 1) / block_size, block_size, 0, stream_>>>(Tick{view}, slots,
                                                                                           wanted_);
            require(cudaGetLastError());
            read(&wanted, wanted_, sizeof wanted);
            if (wanted != 0)
                search(view, Launches{view.room, stream_});
        }
    }

    StepGraph const& graph(View const& view, LawKernels kernels, std::uint32_t steps)
    {
        auto& made = graphs_[{kernels, steps}];
        if (!made)
            made = std::make_unique<StepGraph>(view, kernels, steps, stream_);
        return *made;
    }

    int number_;
    cudaStream_t stream_ = nullptr;
    std::uint32_t* wanted_ = nullptr; //!< whether a replica wants lists
    bool has_conditional_graphs_ = false;
    std::map<std::pair<LawKernels, std::uint32_t>, std::unique_ptr<StepGraph>> graphs_; //!< of the last view
};

} // namespace

DEMENS_VISIBLE int cuda_devices()
{
    int devices = 0;
    return cudaGetDeviceCount(&devices) == cudaSuccess ? devices : 0;
}

DEMENS_VISIBLE std::unique_ptr<Device> make_cuda_device(int number)
{
    int const devices = cuda_devices();
    if (devices == 0)
        throw DeviceError("there is no CUDA device that this process can use");
    if (number < 0 || number >= devices)
        throw DeviceError("there is no CUDA device " + std::to_string(number) +
                          " that this process can use; it sees " + std::to_string(devices));
    return std::make_unique<CudaDevice>(number);
}

} // namespace demens::dem::cuda
