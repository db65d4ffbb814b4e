#pragma once

#include "src/dem/cuda/device.hpp"

#include <vector>

namespace demens::dem::cuda {

//! So many numbers of the device.
template <class Number>
std::vector<Number> fetch(Device& device, Number const* from, std::size_t count)
{
    std::vector<Number> numbers(count);
    if (count > 0)
        device.read(numbers.data(), from, count * sizeof(Number));
    return numbers;
}

} // namespace demens::dem::cuda
