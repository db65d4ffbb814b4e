#include "tests/parity/contact_case.hpp"

#include <stdexcept>

namespace demens::parity {
namespace {

__global__ void evaluate_kernel(Scene const* scene, Case const the_case, Result* results)
{
    int const i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < contacts)
        evaluate_all_moments(*scene, the_case, i, results + i * moments);
}

void require(cudaError_t status)
{
    if (status != cudaSuccess)
        throw std::runtime_error(cudaGetErrorString(status));
}

} // namespace

bool device_is_there()
{
    int devices = 0;
    return cudaGetDeviceCount(&devices) == cudaSuccess && devices > 0;
}

void evaluate_on_device(Scene const& scene, std::vector<Case> const& cases, std::vector<Results>& results)
{
    constexpr std::size_t bytes = contacts * moments * sizeof(Result);
    Scene* device_scene = nullptr;
    Result* device_results = nullptr;
    require(cudaMalloc(&device_scene, sizeof(Scene)));
    require(cudaMalloc(&device_results, bytes));
    require(cudaMemcpy(device_scene, &scene, sizeof(Scene), cudaMemcpyHostToDevice));
    results.assign(cases.size(), Results(contacts * moments));
    for (std::size_t k = 0; k < cases.size(); ++k) {
        evaluate_kernel<<<2, 32>>>(device_scene, cases[k], device_results);
        require(cudaGetLastError());
        require(cudaMemcpy(results[k].data(), device_results, bytes, cudaMemcpyDeviceToHost));
    }
    require(cudaFree(device_scene));
    require(cudaFree(device_results));
}

void evaluate_by_device_compiler(Scene const& scene, Case const& the_case, Results& results)
{
    results.resize(contacts * moments);
    for (int i = 0; i < contacts; ++i)
        evaluate_all_moments(scene, the_case, i, results.data() + i * moments);
}

} // namespace demens::parity
