// In place of cuda_device.cu, where there is no nvcc.
#include "src/dem/cuda/device.hpp"

namespace demens::dem::cuda {

std::unique_ptr<Device> make_cuda_device(int)
{
    throw DeviceError("this build has no code for CUDA devices: it was made without nvcc");
}

int cuda_devices()
{
    return 0;
}

} // namespace demens::dem::cuda
