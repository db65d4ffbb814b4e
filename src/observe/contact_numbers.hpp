#pragma once

#include "demens/observe/snapshot.hpp"

#include <cstdint>

namespace demens::observe {

//! How many other spheres each sphere touches [n]; walls are not counted.
std::vector<std::int64_t> contact_numbers(Snapshot const& snapshot);

} // namespace demens::observe
