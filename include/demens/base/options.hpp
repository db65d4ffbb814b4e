#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace demens {

//! Value of one scalar option: a number, an integer, a switch or a word.
using OptionValue = std::variant<double, std::int64_t, bool, std::string>;

//! What one key of an input table means; parsers, documentation and checks are all made from it.
struct OptionSpec
{
    std::string key; //!< as written in a file; carries the unit, e.g. `mass_kg`
    OptionValue default_value =
        0.0;               //!< its alternative is the type; allowed even outside the range, e.g. -1: derived
    std::string doc;       //!< one line
    bool required = false; //!< no default: the author must give it
    double lower = -std::numeric_limits<double>::infinity(); //!< smallest allowed number, inclusive
    double upper = std::numeric_limits<double>::infinity();  //!< largest allowed number, inclusive
    std::vector<std::string> choices = {};                   //!< allowed words; empty: any
    std::string names_entry_of = {}; //!< "material" or "size_distribution": the word must name such an entry
};

//! Checked values of a table of options, complete with defaults.
class OptionValues
{
  public:
    void set(std::string const& key, OptionValue value) { values_[key] = std::move(value); }
    bool has(std::string const& key) const { return values_.count(key) != 0; }
    double number(std::string const& key) const { return std::get<double>(values_.at(key)); }
    std::int64_t integer(std::string const& key) const { return std::get<std::int64_t>(values_.at(key)); }
    bool flag(std::string const& key) const { return std::get<bool>(values_.at(key)); }
    std::string const& text(std::string const& key) const { return std::get<std::string>(values_.at(key)); }
    std::map<std::string, OptionValue> const& all() const { return values_; }

  private:
    std::map<std::string, OptionValue> values_;
};

//! The defaults of all options that have one.
OptionValues defaults_of(std::vector<OptionSpec> const& specs);

} // namespace demens
