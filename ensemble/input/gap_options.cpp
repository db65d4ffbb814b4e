// Keys of what a model may lack: `[[effect]]`, and the lists of `[gap]`.
#include "ensemble/input/campaign_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/option_defaults.hpp"

namespace demens::ensemble::input {

std::vector<OptionSpec> const& effect_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "name", .default_value = word, .doc = "name in tables and plots", .required = true},
        {.key = "typical",
         .default_value = 1.0,
         .doc = "amplitude that such an effect has, as a standard deviation about 0",
         .lower = positive},
        {.key = "sign",
         .default_value = std::string(word_for(EffectSign::either)),
         .doc = "what signs its amplitude may have",
         .choices = texts_of<EffectSign>()},
        {.key = "doc", .default_value = word, .doc = "what it is, in one line"},
    };
    return specs;
}

std::vector<OptionSpec> const& effect_setting_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "path",
         .default_value = word,
         .doc = "what it changes, as the path of a factor; a word too, e.g. contact.A_B.cohesion",
         .required = true},
        {.key = "per_unit", .default_value = not_given, .doc = "what a unit of amplitude adds to it"},
        {.key = "relative",
         .default_value = not_given,
         .doc = "instead: the share of itself by which a unit of amplitude raises it [-]"},
        {.key = "value_of",
         .default_value = word,
         .doc = "instead: the path whose value is put there wherever the amplitude is not 0"},
    };
    return specs;
}

std::vector<ListSpec> const& effect_lists()
{
    static std::vector<ListSpec> const specs = {
        {"set", "tables",
         "what it changes: { path = \"...\" } with per_unit, relative or, put there wherever the amplitude "
         "is "
         "not 0, value"},
    };
    return specs;
}

std::vector<ListSpec> const& gap_lists()
{
    static std::vector<ListSpec> const specs = {
        {"held_out", "words",
         "experiments that take no part in the calibration, on which a diagnosis is tested"},
        {"candidates", "words",
         "experiments that might be made next: which would tell effects apart? Their targets need no value"},
        {"effects", "words",
         "what the model may lack, of the catalogue (`demens effects`) or an [[effect]]; none: all that the "
         "rigs allow"},
        {"typical", "table",
         "{ EFFECT = amplitude, ... }: how large effects of the catalogue are here, as standard "
         "deviations, in place of what `demens effects` says"},
    };
    return specs;
}

} // namespace demens::ensemble::input
