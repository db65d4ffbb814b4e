#include "demens/base/options.hpp"

namespace demens {

OptionValues defaults_of(std::vector<OptionSpec> const& specs)
{
    OptionValues values;
    for (auto const& spec : specs)
        if (!spec.required)
            values.set(spec.key, spec.default_value);
    return values;
}

} // namespace demens
