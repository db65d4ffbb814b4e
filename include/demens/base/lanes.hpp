#pragma once

#include "demens/base/macros.hpp"

namespace demens {

//! Four doubles that move together; the compiler maps them to the registers that the machine has.
#if defined(__clang__) // which drops the alignment of an alias, not that of a typedef
typedef double Four __attribute__((vector_size(32), aligned(8))); // NOLINT(modernize-use-using)
#else
using Four = double __attribute__((vector_size(32), aligned(8)));
#endif
//! The same in registers only, for templates: they drop the alignment of an argument.
using FourValues = double __attribute__((vector_size(32)));
using FourMask = long long __attribute__((vector_size(32)));

DEMENS_INLINE Four load_four(double const* from)
{
    return *reinterpret_cast<Four const*>(from);
}
DEMENS_INLINE void store_four(double* to, Four const& value)
{
    *reinterpret_cast<Four*>(to) = value;
}

//! Four numbers out of eight: those of `a` are 0 to 3, those of `b` 4 to 7.
template <int... numbers>
DEMENS_INLINE Four picked(Four const& a, Four const& b)
{
#if defined(__clang__) // also the reader of clang-tidy
    return __builtin_shufflevector(a, b, numbers...);
#else
    return __builtin_shuffle(a, b, FourMask{numbers...});
#endif
}

//! Rows become columns: four records of four numbers become four numbers each of four records, and back.
DEMENS_INLINE void transpose(Four& a, Four& b, Four& c, Four& d)
{
    Four const ab_low = picked<0, 4, 2, 6>(a, b);
    Four const ab_high = picked<1, 5, 3, 7>(a, b);
    Four const cd_low = picked<0, 4, 2, 6>(c, d);
    Four const cd_high = picked<1, 5, 3, 7>(c, d);
    a = picked<0, 1, 4, 5>(ab_low, cd_low);
    b = picked<0, 1, 4, 5>(ab_high, cd_high);
    c = picked<2, 3, 6, 7>(ab_low, cd_low);
    d = picked<2, 3, 6, 7>(ab_high, cd_high);
}

} // namespace demens
