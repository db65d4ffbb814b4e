#include "gap/catalogue/setup.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace demens::gap {
namespace {

bool contains(std::vector<std::string> const& words, std::string const& word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

void add_once(std::vector<std::string>& words, std::string const& word)
{
    if (!contains(words, word))
        words.push_back(word);
}

//! Keys of rigs that name the material of what closes a drum or a box at its ends.
bool is_cover(std::string const& key)
{
    return key == "end_material" || key == "window_material";
}

//! Whether a key names what the grains are made of: `material`, of a rig or of its particles.
bool is_of_grains(std::string const& key)
{
    return key == "material" || (key.ends_with(".material") && !key.starts_with("wall."));
}

} // namespace

Setup::Setup(ensemble::CampaignInput const& input) : input_(&input)
{
    auto const named = input.named_materials();
    for (auto const& [experiment, key, material] : named)
        if (is_of_grains(key))
            add_once(grains_, material);
    for (auto const& [experiment, key, material] : named)
        if (!is_of_grains(key) && !is_cover(key) && !contains(grains_, material))
            add_once(walls_, material);
    for (auto const& [experiment, key, material] : named)
        if (is_cover(key) && !contains(walls_, material) && !contains(grains_, material))
            add_once(covers_, material);
}

std::vector<std::string> Setup::contacts_among_grains() const
{
    std::vector<std::string> contacts;
    for (auto const& [a, b] : input_->pairs())
        if (contains(grains_, a) && contains(grains_, b))
            contacts.push_back(fmt::format("contact.{}_{}", a, b));
    return contacts;
}

std::vector<std::string> Setup::contacts_with(std::vector<std::string> const& others) const
{
    std::vector<std::string> contacts;
    for (auto const& [a, b] : input_->pairs())
        if ((contains(grains_, a) && contains(others, b)) || (contains(others, a) && contains(grains_, b)))
            contacts.push_back(fmt::format("contact.{}_{}", a, b));
    return contacts;
}

std::optional<double> Setup::number(std::string const& path) const
{
    auto const value = input_->base_value(path);
    auto const* number = value ? std::get_if<double>(&*value) : nullptr;
    return number && *number != -1 ? std::optional(*number) : std::nullopt;
}

std::optional<std::string> Setup::word(std::string const& path) const
{
    auto const value = input_->base_value(path);
    auto const* word = value ? std::get_if<std::string>(&*value) : nullptr;
    return word ? std::optional(*word) : std::nullopt;
}

std::vector<std::string> Setup::in_experiments(std::string const& key) const
{
    std::vector<std::string> paths;
    for (auto const& experiment : input_->experiments)
        if (auto path = "experiment." + experiment.name + "." + key; has(path))
            paths.push_back(std::move(path));
    return paths;
}

std::vector<std::string> Setup::given_in_experiments(std::string const& key) const
{
    auto paths = in_experiments(key);
    std::erase_if(paths, [&](std::string const& path) { return number(path).value_or(0) == 0; });
    return paths;
}

bool Setup::has_shapes() const
{
    return !input_->run_input({}, 0, 0, 0).shapes_of_sizes.empty();
}

double Setup::mean_radius() const
{
    double sum = 0;
    auto const sizes = input_->run_input({}, 0, 0, 0).size_distributions;
    for (auto const& [name, distribution] : sizes)
        sum += 0.5 * distribution.mean_volume_diameter() / static_cast<double>(sizes.size());
    return sum;
}

double Setup::wave_time() const
{
    if (grains_.empty())
        return 0;
    auto const of_grains = [&](char const* key) {
        return number("material." + grains_.front() + "." + key).value_or(0);
    };
    double const shear = of_grains("youngs_modulus") / (2 * (1 + of_grains("poisson_ratio")));
    return shear > 0 ? std::numbers::pi * mean_radius() * std::sqrt(density() / shear) : 0;
}

double Setup::density() const
{
    return grains_.empty() ? 0 : number("material." + grains_.front() + ".density").value_or(0);
}

} // namespace demens::gap
