// In place of what the device's compiler makes, where there is none.
#include "tests/parity/contact_case.hpp"

#include <stdexcept>

namespace demens::parity {

bool device_is_there()
{
    return false;
}

void evaluate_on_device(Scene const&, std::vector<Case> const&, std::vector<Results>&)
{
    throw std::logic_error("there is no device");
}

void evaluate_by_device_compiler(Scene const& scene, Case const& the_case, Results& results)
{
    results.resize(contacts * moments);
    for (int i = 0; i < contacts; ++i)
        evaluate_all_moments(scene, the_case, i, results.data() + i * moments);
}

} // namespace demens::parity
