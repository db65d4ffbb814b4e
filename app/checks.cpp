#include "app/checks.hpp"

#include "demens/base/text/number.hpp"

namespace demens::cli {

CLI::Validator above_zero()
{
    auto const complaint = [](std::string& word) -> std::string {
        auto const number = text::number_of(word);
        return number && *number > 0 ? "" : "\"" + word + "\" must be a number above 0";
    };
    return {complaint, "above 0"};
}

} // namespace demens::cli
