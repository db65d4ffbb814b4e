#pragma once

#include "demens/base/options.hpp"
#include "ensemble/input/kinds.hpp"

#include <string>
#include <vector>

namespace demens::ensemble::input {

//! A key whose value is a list.
struct ListSpec
{
    std::string key;
    std::string type; //!< "numbers", "words", "rows of numbers"
    std::string doc;  //!< one line
};

//! A section of a campaign's TOML file. Reader, help and documentation are made from these.
struct SectionInfo
{
    std::string heading; //!< as written, e.g. `[material.NAME]` or `[[factor]]`
    std::string doc;     //!< one line
    std::vector<OptionSpec> options;
    std::vector<ListSpec> lists = {};
};

//! Keys of `[campaign]`, of `[[experiment]]` beside its rig's own, of a target, a factor and a constraint.
std::vector<OptionSpec> const& campaign_options();
std::vector<OptionSpec> const& experiment_options();
std::vector<OptionSpec> const& target_options();
std::vector<OptionSpec> const& curve_options();
std::vector<OptionSpec> const& curve_window_options();
std::vector<OptionSpec> const& picture_options();
std::vector<OptionSpec> const& factor_options();
std::vector<OptionSpec> const& constraint_options();
std::vector<OptionSpec> const& effect_options();
std::vector<OptionSpec> const& effect_setting_options();
std::vector<OptionSpec> const& shape_options();
std::vector<ListSpec> const& shape_lists();
std::vector<OptionSpec> const& size_distribution_options();
std::vector<ListSpec> const& size_distribution_lists();
std::vector<ListSpec> const& picture_lists();
std::vector<ListSpec> const& factor_lists();
std::vector<ListSpec> const& screening_lists();
std::vector<ListSpec> const& objective_lists();
std::vector<ListSpec> const& design_lists();
std::vector<ListSpec> const& gap_lists();
std::vector<ListSpec> const& effect_lists();

//! Kinds of design that use a key of `[design]`; none: all kinds.
std::vector<DesignKind> design_kinds_using(std::string const& key);

//! All sections in the order in which an author writes them.
std::vector<SectionInfo> const& all_sections();

//! The option of that key, which must be there.
OptionSpec const& spec_of(std::vector<OptionSpec> const& specs, std::string const& key);
//! Keys of options and lists.
std::vector<std::string> keys_of(std::vector<OptionSpec> const& specs);
std::vector<std::string> keys_of(std::vector<ListSpec> const& specs);

} // namespace demens::ensemble::input
