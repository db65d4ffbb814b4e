#include "ensemble/input/effects.hpp"

#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/option_range.hpp"
#include "ensemble/input/toml_text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

using input::number_text, input::quoted;

std::string value_text(OptionValue const& value)
{
    if (auto const* number = std::get_if<double>(&value))
        return number_text(*number);
    if (auto const* whole = std::get_if<std::int64_t>(&value))
        return fmt::format("{}", *whole);
    if (auto const* is = std::get_if<bool>(&value))
        return *is ? "true" : "false";
    if (auto const* word = std::get_if<std::string>(&value))
        return quoted(*word);
    throw InputError("an effect puts numbers, words, true or false in the place of others, not lists");
}

std::string setting_text(EffectSetting const& setting)
{
    std::string how;
    if (auto const* adds = std::get_if<Adds>(&setting.how))
        how = "per_unit = " + number_text(adds->per_unit);
    else if (auto const* scales = std::get_if<Scales>(&setting.how))
        how = "relative = " + number_text(scales->per_unit);
    else if (auto const* copies = std::get_if<Copies>(&setting.how))
        how = "value_of = " + quoted(copies->path);
    else
        how = "value = " + value_text(std::get<Puts>(setting.how).value);
    return fmt::format("{{ path = {}, {} }}", quoted(setting.path), how);
}

} // namespace

std::vector<Override> overrides_of(std::vector<Effect> const& effects, std::vector<double> const& amplitudes)
{
    std::vector<Override> overrides;
    for (std::size_t k = 0; k < amplitudes.size(); ++k)
        if (amplitudes[k] != 0)
            for (auto const& setting : effects.at(k).settings)
                overrides.push_back({setting, amplitudes[k]});
    return overrides;
}

std::string toml_text(std::vector<Effect> const& effects)
{
    std::string text;
    for (auto const& effect : effects) {
        text += fmt::format("\n[[effect]]\nname = {}\ntypical = {}\nsign = {}\n", quoted(effect.name),
                            number_text(effect.typical), quoted(word_for(effect.sign)));
        if (!effect.doc.empty())
            text += fmt::format("doc = {}\n", quoted(effect.doc));
        std::string settings;
        for (auto const& setting : effect.settings)
            settings += (settings.empty() ? "" : ", ") + setting_text(setting);
        text += fmt::format("set = [{}]\n", settings);
    }
    return text;
}

} // namespace demens::ensemble

namespace demens::ensemble::input {
namespace {

EffectSetting read_setting(InputTable const& table, BaseInput const& base,
                           std::vector<Experiment> const& experiments)
{
    auto const values = table.read(effect_setting_options(), {"value"});
    auto const resolved = resolve_path(values.text("path"), base, experiments);
    if (resolved.places.empty())
        throw table.error("path", "names nothing in this input; " +
                                      suggestion(values.text("path"), all_paths(base, experiments)));
    int given = 0;
    for (char const* key : {"per_unit", "relative", "value", "value_of"})
        given += table.has(key);
    if (given != 1)
        throw table.error("path",
                          "needs one of per_unit = NUMBER (is added for a unit of amplitude), relative = "
                          "NUMBER (the value grows by this share of itself), value = ... (is put there) and "
                          "value_of = \"PATH\" (whose value is put there)");
    EffectSetting setting{resolved.path, {}};
    if (table.has("value")) {
        auto spec = resolved.spec;
        spec.key = "value";
        setting.how = Puts{table.read_option(spec)};
        return setting;
    }
    if (table.has("value_of")) {
        auto const source = resolve_path(values.text("value_of"), base, experiments);
        if (source.places.empty())
            throw table.error("value_of",
                              "names nothing in this input; " +
                                  suggestion(values.text("value_of"), all_paths(base, experiments)));
        if (source.spec.default_value.index() != resolved.spec.default_value.index())
            throw table.error("value_of", "is of another type than path");
        setting.how = Copies{source.path};
        return setting;
    }
    if (!std::holds_alternative<double>(resolved.spec.default_value))
        throw table.error("path", fmt::format("is no number that an amplitude can scale ({}); give value = "
                                              "..., which is put there",
                                              resolved.spec.doc));
    if (table.has("per_unit"))
        setting.how = Adds{values.number("per_unit")};
    else
        setting.how = Scales{values.number("relative")};
    return setting;
}

OptionValue changed(OptionValue const& value, Override const& by, BaseInput const& base,
                    std::vector<Experiment> const& experiments)
{
    if (auto const* copies = std::get_if<Copies>(&by.setting.how))
        return base.value(resolve_path(copies->path, base, experiments).places.at(0));
    if (auto const* puts = std::get_if<Puts>(&by.setting.how))
        return puts->value;
    double const number = std::get<double>(value);
    if (auto const* adds = std::get_if<Adds>(&by.setting.how))
        return number + by.amplitude * adds->per_unit;
    return number * (1 + by.amplitude * std::get<Scales>(by.setting.how).per_unit);
}

} // namespace

std::vector<Effect> read_effects(InputTable const& file, BaseInput const& base,
                                 std::vector<Experiment> const& experiments)
{
    std::vector<Effect> effects;
    for (auto& table : file.table_list("effect")) {
        auto const values = table.read(effect_options(), {"set"});
        Effect effect{.name = values.text("name"), .settings = {}};
        check_name(table, "name", effect.name);
        for (auto const& other : effects)
            if (other.name == effect.name)
                throw table.error("name", "two effects have this name; give each its own");
        table.set_path("effect." + effect.name);
        effect.typical = values.number("typical");
        effect.sign = *find_word<EffectSign>(values.text("sign"));
        effect.doc = values.text("doc");
        for (auto const& setting : table.table_list("set"))
            effect.settings.push_back(read_setting(setting, base, experiments));
        if (effect.settings.empty())
            throw table.error("the key \"set\" is missing; give set = [{ path = \"...\", per_unit = ... }], "
                              "what a unit of amplitude changes");
        for (auto const& other : effects)
            if (toml_text({{.name = "", .settings = other.settings}}) ==
                toml_text({{.name = "", .settings = effect.settings}}))
                throw table.error("set", fmt::format("is the same as that of the effect {}, so that nothing "
                                                     "could tell them apart; keep one of them",
                                                     other.name));
        effects.push_back(std::move(effect));
    }
    return effects;
}

void apply(std::vector<Override> const& overrides, BaseInput& base,
           std::vector<Experiment> const& experiments)
{
    for (auto const& by : overrides) {
        auto const resolved = resolve_path(by.setting.path, base, experiments);
        if (resolved.places.empty())
            throw InputError(fmt::format("{} names nothing in this input; {}", by.setting.path,
                                         suggestion(by.setting.path, all_paths(base, experiments))));
        for (auto const& place : resolved.places) {
            auto const value = changed(base.value(place), by, base, experiments);
            if (auto const* number = std::get_if<double>(&value))
                if (auto const complaint = range_complaint(resolved.spec, *number); !complaint.empty())
                    throw InputError(fmt::format("{} = {}: {} ({})", resolved.path, *number, complaint,
                                                 resolved.spec.doc));
            base.set(place, value);
        }
    }
}

} // namespace demens::ensemble::input
