#pragma once

#include "demens/base/options.hpp"

#include <limits>

//! Keys of rigs and of their tables, a line each.
namespace demens::rig {

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();
constexpr double positive = std::numeric_limits<double>::min();

inline OptionSpec word(std::string key, std::string doc)
{
    return {.key = std::move(key), .default_value = std::string(), .doc = std::move(doc)};
}
inline OptionSpec choice(std::string key, std::vector<std::string> choices, std::string doc)
{
    auto const first = choices.front();
    return {
        .key = std::move(key), .default_value = first, .doc = std::move(doc), .choices = std::move(choices)};
}
inline OptionSpec entry(std::string key, std::string of, std::string doc)
{
    return {.key = std::move(key),
            .default_value = std::string(),
            .doc = std::move(doc),
            .names_entry_of = std::move(of)};
}
inline OptionSpec words(std::string key, std::string doc, std::vector<std::string> choices)
{
    return {.key = std::move(key),
            .default_value = std::vector<std::string>{},
            .doc = std::move(doc),
            .choices = std::move(choices)};
}
inline OptionSpec entries(std::string key, std::string of, std::string doc)
{
    return {.key = std::move(key),
            .default_value = std::vector<std::string>{},
            .doc = std::move(doc),
            .names_entry_of = std::move(of)};
}
inline OptionSpec file(std::string key, std::string doc)
{
    return {.key = std::move(key),
            .default_value = std::string(),
            .doc = std::move(doc),
            .required = true,
            .names_file = true};
}
inline OptionSpec required(OptionSpec spec)
{
    spec.required = true;
    return spec;
}
inline OptionSpec number(std::string key, double value, std::string doc,
                         double lower = -std::numeric_limits<double>::infinity(),
                         double upper = std::numeric_limits<double>::infinity())
{
    return {
        .key = std::move(key), .default_value = value, .doc = std::move(doc), .lower = lower, .upper = upper};
}
inline OptionSpec integer(std::string key, std::int64_t value, std::string doc, double lower, double upper)
{
    return {
        .key = std::move(key), .default_value = value, .doc = std::move(doc), .lower = lower, .upper = upper};
}
inline OptionSpec flag(std::string key, bool value, std::string doc)
{
    return {.key = std::move(key), .default_value = value, .doc = std::move(doc)};
}
inline OptionSpec vector(std::string key, Vector3 value, std::string doc)
{
    return {.key = std::move(key), .default_value = value, .doc = std::move(doc)};
}
inline OptionSpec required_word(std::string key, std::string doc)
{
    return required(word(std::move(key), std::move(doc)));
}
inline OptionSpec required_vector(std::string key, std::string doc)
{
    return required(vector(std::move(key), {}, std::move(doc)));
}

} // namespace demens::rig
