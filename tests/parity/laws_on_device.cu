#include "tests/parity/law_evaluation.hpp"

#include <stdexcept>

namespace demens::parity {
namespace {

template <class Law>
__global__ void evaluate_kernel(Law law, Moment const* moments, int contacts, int count, double* results)
{
    int const i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < contacts)
        evaluate_law(law, moments + i * count, count, results + i * count * numbers_per_moment);
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

std::vector<double> evaluated_on_device(std::vector<Moment> const& moments, int contacts)
{
    int const count = static_cast<int>(moments.size()) / contacts;
    std::size_t const numbers = moments.size() * numbers_per_moment;
    Moment* device_moments = nullptr;
    double* device_results = nullptr;
    require(cudaMalloc(&device_moments, moments.size() * sizeof(Moment)));
    require(cudaMalloc(&device_results, numbers * sizeof(double)));
    require(
        cudaMemcpy(device_moments, moments.data(), moments.size() * sizeof(Moment), cudaMemcpyHostToDevice));
    std::vector<double> all, results(numbers);
    for_each_law([&](std::string const&, auto const& law) {
        evaluate_kernel<<<(contacts + 63) / 64, 64>>>(law, device_moments, contacts, count, device_results);
        require(cudaGetLastError());
        require(cudaMemcpy(results.data(), device_results, numbers * sizeof(double), cudaMemcpyDeviceToHost));
        all.insert(all.end(), results.begin(), results.end());
    });
    require(cudaFree(device_moments));
    require(cudaFree(device_results));
    return all;
}

std::vector<double> evaluated_by_device_compiler(std::vector<Moment> const& moments, int contacts)
{
    int const count = static_cast<int>(moments.size()) / contacts;
    std::vector<double> all, results(moments.size() * numbers_per_moment);
    for_each_law([&](std::string const&, auto const& law) {
        for (int i = 0; i < contacts; ++i)
            evaluate_law(law, moments.data() + i * count, count,
                         results.data() + i * count * numbers_per_moment);
        all.insert(all.end(), results.begin(), results.end());
    });
    return all;
}

} // namespace demens::parity
