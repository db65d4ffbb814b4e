#pragma once

#include "ensemble/input/campaign_input.hpp"

#include <algorithm>
#include <climits>
#include <string>
#include <variant>
#include <vector>

namespace demens::ensemble::input {

//! A key of a section and the member of the section's struct that holds its value.
template <class Section>
struct Field
{
    OptionSpec spec;
    std::variant<int Section::*, double Section::*, bool Section::*, std::string Section::*> member;
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
std::vector<Field<SolverOptions>> const& fields_of();
template <>
std::vector<Field<StopOptions>> const& fields_of();
template <>
std::vector<Field<RunOptions>> const& fields_of();

//! The value of one key of a section's struct.
template <class Section>
OptionValue value_of(Section const& section, Field<Section> const& field)
{
    return std::visit(
        [&](auto member) -> OptionValue {
            if constexpr (std::is_same_v<decltype(member), int Section::*>)
                return std::int64_t{section.*member};
            else
                return section.*member;
        },
        field.member);
}

//! A key of a section; its default is the one that the struct has.
template <class Section, class Value>
Field<Section> field(Value Section::*member, OptionSpec spec)
{
    Field<Section> made{std::move(spec), member};
    made.spec.default_value = value_of(Section{}, made);
    if constexpr (std::is_same_v<Value, int>)
        made.spec.upper = std::min(made.spec.upper, double{INT_MAX});
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
    for (auto const& [spec, member] : fields_of<Section>()) {
        std::visit(
            [&, &spec = spec](auto pointer) {
                auto const& value = values.all().at(spec.key);
                if constexpr (std::is_same_v<decltype(pointer), int Section::*>)
                    section.*pointer = static_cast<int>(std::get<std::int64_t>(value));
                else
                    section.*pointer = std::get<std::decay_t<decltype(section.*pointer)>>(value);
            },
            member);
    }
}

//! The values of a section's struct, for writing them out.
template <class Section>
OptionValues values_of(Section const& section)
{
    OptionValues values;
    for (auto const& field : fields_of<Section>())
        values.set(field.spec.key, value_of(section, field));
    return values;
}

} // namespace demens::ensemble::input
