#pragma once

#include "ensemble/input/campaign_input.hpp"

#include <algorithm>
#include <climits>
#include <functional>
#include <string>
#include <vector>

namespace demens::ensemble::input {

//! A key of a section and the member of the section's struct that holds its value.
template <class Section>
struct Field
{
    OptionSpec spec;
    std::function<OptionValue(Section const&)> get;
    std::function<void(Section&, OptionValue const&)> set;
};

//! All keys of a section; the one list that reader, help and documentation use (section_fields.cpp).
template <class Section>
std::vector<Field<Section>> const& fields_of();
template <>
std::vector<Field<DesignOptions>> const& fields_of();
template <>
std::vector<Field<ScreeningOptions>> const& fields_of();
template <>
std::vector<Field<ObjectiveOptions>> const& fields_of();
template <>
std::vector<Field<SurrogateOptions>> const& fields_of();
template <>
std::vector<Field<SearchOptions>> const& fields_of();
template <>
std::vector<Field<SolverOptions>> const& fields_of();
template <>
std::vector<Field<StopOptions>> const& fields_of();
template <>
std::vector<Field<RunOptions>> const& fields_of();
template <>
std::vector<Field<GapOptions>> const& fields_of();

//! A key of a section; its default is the one that the struct has, its choices are the words of its enum.
template <class Section, class Value>
Field<Section> field(Value Section::*member, OptionSpec spec)
{
    Field<Section> made{std::move(spec), {}, {}};
    if constexpr (std::is_enum_v<Value>) {
        made.spec.choices = texts_of<Value>();
        made.get = [member](Section const& section) { return std::string(word_for(section.*member)); };
        made.set = [member](Section& section, OptionValue const& value) {
            section.*member = *find_word<Value>(std::get<std::string>(value)); // a choice, as was checked
        };
    } else if constexpr (std::is_same_v<Value, int>) {
        made.spec.upper = std::min(made.spec.upper, double{INT_MAX});
        made.get = [member](Section const& section) { return std::int64_t{section.*member}; };
        made.set = [member](Section& section, OptionValue const& value) {
            section.*member = static_cast<int>(std::get<std::int64_t>(value));
        };
    } else {
        made.get = [member](Section const& section) { return section.*member; };
        made.set = [member](Section& section, OptionValue const& value) {
            section.*member = std::get<Value>(value);
        };
    }
    made.spec.default_value = made.get(Section{});
    return made;
}

//! The specs of a section's keys.
template <class Section>
std::vector<OptionSpec> specs_of()
{
    std::vector<OptionSpec> specs;
    for (auto const& field : fields_of<Section>())
        specs.push_back(field.spec);
    return specs;
}

//! Sets the members of a section's struct from checked values.
template <class Section>
void assign(Section& section, OptionValues const& values)
{
    for (auto const& field : fields_of<Section>())
        field.set(section, values.all().at(field.spec.key));
}

//! The values of a section's struct, for writing them out.
template <class Section>
OptionValues values_of(Section const& section)
{
    OptionValues values;
    for (auto const& field : fields_of<Section>())
        values.set(field.spec.key, field.get(section));
    return values;
}

} // namespace demens::ensemble::input
