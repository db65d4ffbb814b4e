#pragma once

#include <cstddef>

namespace demens::cli {

//! Columns of the terminal that the output goes to; 0: it goes elsewhere.
std::size_t terminal_width();

} // namespace demens::cli
