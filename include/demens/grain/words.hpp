#pragma once

#include "demens/base/words.hpp"
#include "demens/grain/grains.hpp"

namespace demens {

template <>
std::vector<Word<grain::SizeMeasure>> const& words_of();
template <>
std::vector<Word<grain::ShareOf>> const& words_of();

} // namespace demens
