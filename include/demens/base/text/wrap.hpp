#pragma once

#include <cstddef>
#include <string>

namespace demens::text {

//! A line in as many as it takes for none to be wider than that, broken at blanks; those after the first are
//! indented. Words that are wider stay whole. \param width 0: the line stays as it is
std::string wrapped(std::string const& line, std::size_t width, std::size_t indent);

} // namespace demens::text
