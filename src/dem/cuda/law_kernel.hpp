#pragma once

#include <cstdint>

namespace demens::dem::cuda {

//! The kernels that there are: one for any laws, one for those with an energy ledger, and for those laws that
//! are used most one each. A replica has that of its own laws, whoever else is in its batch: on a device
//! kernels differ in the last digits, since compilers contract products and sums of each as they like.
enum class LawKernel : std::uint32_t
{
    any,
    any_with_ledger,
    hertz_mindlin,
    hertz_mindlin_epsd2,
    hertz_mindlin_constant_torque,
    hertz_rescale,
    hertz_rescale_epsd2,
    count
};

//! A bit for each kernel that a batch needs.
using LawKernels = std::uint32_t;

constexpr LawKernels bit_of(LawKernel kernel)
{
    return LawKernels{1} << static_cast<std::uint32_t>(kernel);
}

} // namespace demens::dem::cuda
