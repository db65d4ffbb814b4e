#pragma once

#include "demens/base/macros.hpp"

#include <bit>
#include <cstdint>
#include <cstring>

namespace demens::dem::cuda {

// What threads of a device share; on the host one thread works after another.

DEMENS_INLINE DEMENS_FUNCTION std::uint32_t add_atomically(std::uint32_t* where, std::uint32_t value)
{
#if defined(__CUDA_ARCH__)
    return atomicAdd(where, value);
#else
    std::uint32_t const old = *where;
    *where += value;
    return old;
#endif
}

//! Maxima do not depend on the order of those who come; most come too late and need not wait.
template <class Number>
DEMENS_INLINE DEMENS_FUNCTION void raise_atomically(Number* where, Number value)
{
#if defined(__CUDA_ARCH__)
    using Plain = std::conditional_t<sizeof(Number) == 8, unsigned long long, unsigned>;
    if (*static_cast<Number volatile*>(where) < value)
        atomicMax(reinterpret_cast<Plain*>(where), static_cast<Plain>(value));
#else
    *where = *where < value ? value : *where;
#endif
}
template <class Number>
DEMENS_INLINE DEMENS_FUNCTION void lower_atomically(Number* where, Number value)
{
#if defined(__CUDA_ARCH__)
    using Plain = std::conditional_t<sizeof(Number) == 8, unsigned long long, unsigned>;
    if (*static_cast<Number volatile*>(where) > value)
        atomicMin(reinterpret_cast<Plain*>(where), static_cast<Plain>(value));
#else
    *where = *where > value ? value : *where;
#endif
}

//! A finite number as an integer in the same order.
DEMENS_INLINE DEMENS_FUNCTION std::uint64_t ordered(double value)
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits >> 63 ? ~bits : bits | (std::uint64_t{1} << 63);
}
DEMENS_INLINE DEMENS_FUNCTION double number_of(std::uint64_t order)
{
    std::uint64_t const bits = order >> 63 ? order & ~(std::uint64_t{1} << 63) : ~order;
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

DEMENS_INLINE DEMENS_FUNCTION std::uint32_t number_of_bits(std::uint32_t bits)
{
#if defined(__CUDA_ARCH__)
    return static_cast<std::uint32_t>(__popc(bits));
#else
    return static_cast<std::uint32_t>(std::popcount(bits));
#endif
}

DEMENS_INLINE DEMENS_FUNCTION std::uint32_t lowest_bit(std::uint32_t bits)
{
#if defined(__CUDA_ARCH__)
    return static_cast<std::uint32_t>(__ffs(static_cast<int>(bits)) - 1);
#else
    return static_cast<std::uint32_t>(std::countr_zero(bits));
#endif
}

} // namespace demens::dem::cuda
