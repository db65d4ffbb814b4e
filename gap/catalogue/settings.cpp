#include "gap/catalogue/settings.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace demens::gap {
using ensemble::Adds, ensemble::Scales;

Settings scaled(std::vector<std::string> const& paths, double per_unit)
{
    Settings settings;
    for (auto const& path : paths)
        settings.push_back({path, Scales{per_unit}});
    return settings;
}

Settings added(std::vector<std::string> const& paths, double per_unit)
{
    Settings settings;
    for (auto const& path : paths)
        settings.push_back({path, Adds{per_unit}});
    return settings;
}

std::vector<std::string> of_each(std::vector<std::string> const& words, std::string const& before,
                                 std::string const& after)
{
    std::vector<std::string> all;
    for (auto const& word : words)
        all.push_back(fmt::format("{}{}{}", before, word, after));
    return all;
}

Settings friction_scaled(Setup const& setup, std::vector<std::string> const& contacts)
{
    Settings settings;
    for (auto const& contact : contacts)
        for (char const* key : {".static_friction", ".kinetic_friction"})
            if (setup.number(contact + key))
                settings.push_back({contact + key, Scales{1}});
    return settings;
}

Settings of_contacts(std::vector<std::string> const& contacts, std::string const& key, double per_unit)
{
    return added(of_each(contacts, "", "." + key), per_unit);
}

double grain_weight(Setup const& setup)
{
    constexpr double gravity = 9.81; // [m/s^2]
    return setup.density() * 4 / 3 * std::numbers::pi * std::pow(setup.mean_radius(), 3) * gravity;
}

} // namespace demens::gap
