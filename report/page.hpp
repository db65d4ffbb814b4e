#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace demens::report {

//! The self-contained HTML page that shows a document.
std::string page_of(nlohmann::json const& document, std::string const& title);

} // namespace demens::report
