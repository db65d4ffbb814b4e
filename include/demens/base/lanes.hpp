#pragma once

#include "demens/base/macros.hpp"

namespace demens {

//! Four doubles that move together; the compiler maps them to the registers that the machine has.
using Four = double __attribute__((vector_size(32), aligned(8)));
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

//! Rows become columns: four records of four numbers become four numbers each of four records, and back.
DEMENS_INLINE void transpose(Four& a, Four& b, Four& c, Four& d)
{
    Four const ab_low = __builtin_shuffle(a, b, FourMask{0, 4, 2, 6});
    Four const ab_high = __builtin_shuffle(a, b, FourMask{1, 5, 3, 7});
    Four const cd_low = __builtin_shuffle(c, d, FourMask{0, 4, 2, 6});
    Four const cd_high = __builtin_shuffle(c, d, FourMask{1, 5, 3, 7});
    a = __builtin_shuffle(ab_low, cd_low, FourMask{0, 1, 4, 5});
    b = __builtin_shuffle(ab_high, cd_high, FourMask{0, 1, 4, 5});
    c = __builtin_shuffle(ab_low, cd_low, FourMask{2, 3, 6, 7});
    d = __builtin_shuffle(ab_high, cd_high, FourMask{2, 3, 6, 7});
}

} // namespace demens
