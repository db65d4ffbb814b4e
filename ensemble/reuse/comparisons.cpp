#include "ensemble/reuse/comparisons.hpp"

#include "ensemble/input/toml_text.hpp"

#include <algorithm>

namespace demens::ensemble {
namespace {

bool are_same(CurveWindow const& one, CurveWindow const& other)
{
    return one.name == other.name && one.from == other.from && one.to == other.to &&
           one.first == other.first && one.end == other.end;
}

bool are_same(CurveTarget const& one, CurveTarget const& other)
{
    return one.name == other.name && one.is_profile == other.is_profile &&
           one.curve.axis == other.curve.axis && one.curve.values == other.curve.values &&
           one.shift == other.shift && one.offset == other.offset &&
           one.largest_shift == other.largest_shift &&
           std::equal(one.windows.begin(), one.windows.end(), other.windows.begin(), other.windows.end(),
                      [](auto const& a, auto const& b) { return are_same(a, b); });
}

//! What its author wrote of it, but for what is about the fit alone.
std::vector<std::string> given(PictureTarget const& picture)
{
    std::vector<std::string> texts = picture.files;
    for (double const number : picture.circle)
        texts.push_back(input::option_text(number));
    for (auto const& [key, value] : picture.given.all())
        if (key != "sd" && key != "weight" && key != "tolerance")
            texts.push_back(key + " = " + (is_absent(value) ? "" : input::option_text(value)));
    return texts;
}

} // namespace

bool are_same_comparisons(Experiment const& one, Experiment const& other, rig::Files const& here,
                          rig::Files const& there)
{
    if (!std::equal(one.curves.begin(), one.curves.end(), other.curves.begin(), other.curves.end(),
                    [](auto const& a, auto const& b) { return are_same(a, b); }) ||
        one.picture.has_value() != other.picture.has_value())
        return false;
    if (!one.picture)
        return true;
    return given(*one.picture) == given(*other.picture) &&
           std::all_of(one.picture->files.begin(), one.picture->files.end(), [&](std::string const& name) {
               auto const a = here.find(name), b = there.find(name);
               return a != here.end() && b != there.end() && *a->second == *b->second;
           });
}

std::size_t responses_of_rig(Experiment const& experiment)
{
    auto count = experiment.responses.size();
    for (auto const& curve : experiment.curves)
        count -= responses_of(curve, "", "").size();
    if (experiment.picture)
        count -= responses_of(*experiment.picture).size();
    return count;
}

} // namespace demens::ensemble
