#pragma once

#include "demens/base/vector3.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace demens {

//! Value of one option: a number, an integer, a switch, a word, a vector or a list of words.
using OptionValue = std::variant<double, std::int64_t, bool, std::string, Vector3, std::vector<std::string>>;

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
    //! The word must name such an entry: "material", "size_distribution", "shape", or the key of tables of
    //! the same rig.
    std::string names_entry_of = {};
    bool names_file = false; //!< the word names a file, whose content goes with the input
};

//! Whether the word names a table of the whole campaign, not one of the rig.
inline bool names_table(OptionSpec const& spec)
{
    auto const& of = spec.names_entry_of;
    return of == "material" || of == "size_distribution" || of == "shape";
}

//! One of several kinds of a table, with the keys that only this kind has.
struct TableKind
{
    std::string name; //!< value of the key that chooses the kind, e.g. `cylinder` for `shape = "cylinder"`
    std::string doc;  //!< one line
    std::vector<OptionSpec> options = {};
};

//! Tables inside a table, any number of them: `[[experiment.wall]]`.
struct TableSpec
{
    std::string key;                      //!< e.g. `wall`
    std::string doc;                      //!< one line
    std::vector<OptionSpec> options = {}; //!< keys of all kinds; with `name` entries are told apart by it
    std::string kind_key = {};            //!< key that chooses the kind; empty: there is one kind only
    std::string default_kind = {};        //!< empty: the author must choose
    std::vector<TableKind> kinds = {};
    std::vector<TableSpec> tables = {}; //!< tables inside these
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
    Vector3 const& vector(std::string const& key) const { return std::get<Vector3>(values_.at(key)); }
    std::vector<std::string> const& words(std::string const& key) const
    {
        return std::get<std::vector<std::string>>(values_.at(key));
    }
    std::map<std::string, OptionValue> const& all() const { return values_; }

    //! The tables `[[key]]` inside this one, in the order of the file; none when there are none.
    std::vector<OptionValues> const& tables(std::string const& key) const;
    OptionValues& table(std::string const& key, std::size_t number) { return tables_.at(key).at(number); }
    OptionValues const& table(std::string const& key, std::size_t number) const
    {
        return tables_.at(key).at(number);
    }
    void add_table(std::string const& key, OptionValues table) { tables_[key].push_back(std::move(table)); }

  private:
    std::map<std::string, OptionValue> values_;
    std::map<std::string, std::vector<OptionValues>> tables_;
};

//! The defaults of all options that have one.
OptionValues defaults_of(std::vector<OptionSpec> const& specs);
//! The key that chooses the kind of a table, which has kinds.
OptionSpec kind_option(TableSpec const& table);
//! The keys that a table of this kind has; of a table without kinds, whatever `kind`.
std::vector<OptionSpec> options_of(TableSpec const& table, std::string const& kind);
//! The keys that this entry has.
std::vector<OptionSpec> options_of(TableSpec const& table, OptionValues const& entry);
//! A number or a vector that its author may leave out: not given.
bool is_absent(OptionValue const& value);

} // namespace demens
