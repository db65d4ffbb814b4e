#pragma once

#include <functional>

namespace demens::cli {

//! Does something on all ranks of a world of its own, and tells once what goes wrong. \return exit code, the
//! same on all ranks
int on_all_ranks(std::function<int()> const& act);

} // namespace demens::cli
