// In place of cuda_device.cu, where there is no nvcc.
#include "src/dem/cuda/device.hpp"

#include <stdexcept>

namespace demens::dem::cuda {

std::unique_ptr<Device> make_cuda_device()
{
    throw std::runtime_error("this build has no code for CUDA devices: it was made without nvcc");
}

bool has_cuda_device()
{
    return false;
}

} // namespace demens::dem::cuda
