#pragma once

#include <cstddef>
#include <vector>

namespace demens {

using Bytes = std::vector<std::byte>;

} // namespace demens
