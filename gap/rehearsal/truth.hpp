#pragma once

#include "ensemble/effect.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace demens::gap {

//! What acts in a rehearsed case.
enum class CaseKind
{
    none,
    single,
    pair,
    outside //!< an effect that the diagnosis is not told of
};

//! A case whose cause is known, to be sealed.
struct CaseTruth
{
    std::string name; //!< `case01`
    CaseKind kind = CaseKind::none;
    std::vector<std::string> effects;
    std::vector<double> amplitudes; //!< of these [own units]
    std::vector<double> strengths;  //!< amplitudes over typical ones
    std::vector<double> factors;    //!< of the campaign [own units]
};

nlohmann::json json_of(CaseTruth const& truth);
//! \throws InputError for what is no truth
CaseTruth truth_of(nlohmann::json const& json);

//! SHA-256 of a salt and the canonical JSON of a truth (keys sorted, no blanks), as hexadecimal digits.
std::string seal_of(std::string const& salt, CaseTruth const& truth);

} // namespace demens::gap

namespace demens {

template <>
inline std::vector<Word<gap::CaseKind>> const& words_of()
{
    using enum gap::CaseKind;
    static std::vector<Word<gap::CaseKind>> const words = {
        {none, "none"}, {single, "single"}, {pair, "pair"}, {outside, "outside"}};
    return words;
}

} // namespace demens
