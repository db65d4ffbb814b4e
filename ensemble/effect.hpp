#pragma once

#include "demens/base/options.hpp"
#include "demens/base/words.hpp"

#include <string>
#include <variant>
#include <vector>

namespace demens::ensemble {

//! What is done to a value of the input, by an amplitude.
struct Adds
{
    double per_unit; //!< of amplitude, in the unit of the value
};
struct Scales
{
    double per_unit; //!< the value becomes value (1 + amplitude per_unit) [-]
};
struct Puts
{
    OptionValue value; //!< wherever the amplitude is not 0
};
struct Copies
{
    std::string path; //!< whose value is put there wherever the amplitude is not 0
};

//! One value of the input that an effect changes.
struct EffectSetting
{
    std::string path; //!< as a factor's; words may be named too
    std::variant<Adds, Scales, Puts, Copies> how;
};

//! What signs an amplitude may have.
enum class EffectSign
{
    either,
    positive,
    negative
};

//! A named change of the model, 0 in the base model: what it may lack.
struct Effect
{
    std::string name;
    std::vector<EffectSetting> settings;
    double typical = 1; //!< amplitude that such an effect has, as a standard deviation
    EffectSign sign = EffectSign::either;
    std::string doc = {}; //!< one line
};

//! A change of one value, with its amplitude.
struct Override
{
    EffectSetting setting;
    double amplitude;
};

//! What effects of some amplitudes change; nothing where the amplitude is 0.
//! \param amplitudes one an effect; none: all 0
std::vector<Override> overrides_of(std::vector<Effect> const& effects, std::vector<double> const& amplitudes);

//! Effects as the `[[effect]]` of a campaign, which CampaignInput::effects_of() reads again.
std::string toml_text(std::vector<Effect> const& effects);

} // namespace demens::ensemble

namespace demens {

template <>
inline std::vector<Word<ensemble::EffectSign>> const& words_of()
{
    using enum ensemble::EffectSign;
    static std::vector<Word<ensemble::EffectSign>> const words = {
        {either, "either"}, {positive, "positive"}, {negative, "negative"}};
    return words;
}

} // namespace demens
