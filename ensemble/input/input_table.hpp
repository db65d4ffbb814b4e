#pragma once

#include "demens/base/error.hpp"
#include "demens/base/options.hpp"

#include <string>
#include <toml++/toml.h>
#include <vector>

namespace demens::ensemble::input {

//! A table of a TOML file that knows where it stands: reads options and words all errors about them.
class InputTable
{
  public:
    //! \param path dotted path of the table in messages; empty for the whole file
    //! \param origin the file in messages
    InputTable(toml::table const& table, std::string path, std::string origin);

    std::string const& path() const { return path_; }
    //! Another path for messages, once the table's own name is known.
    void set_path(std::string path) { path_ = std::move(path); }
    bool has(std::string const& key) const { return table_->contains(key); }
    //! Keys in the order of the file.
    std::vector<std::string> keys() const;

    //! \throws InputError at a key that is none of these, with the nearest one.
    void allow_only(std::vector<std::string> const& known) const;
    //! The same of one key.
    void allow_only_key(std::string const& key, std::vector<std::string> const& known) const;
    //! The options of the table, complete with defaults. Keys that are neither options nor `others` are
    //! errors.
    OptionValues read(std::vector<OptionSpec> const& specs,
                      std::vector<std::string> const& others = {}) const;

    //! One option that must be in the table; for keys that decide how the others are read.
    OptionValue read_option(OptionSpec const& spec) const;
    //! Lists; empty when the key is absent.
    std::vector<double> numbers(std::string const& key) const;
    std::vector<std::string> words(std::string const& key) const;
    std::vector<std::vector<double>> rows_of_numbers(std::string const& key) const;

    //! The table `[key]`; an empty one when it is absent.
    InputTable table(std::string const& key) const;
    //! The tables of `[[key]]`; none when it is absent.
    std::vector<InputTable> table_list(std::string const& key) const;

    //! `FILE:LINE: PATH.KEY = VALUE: what`
    InputError error(std::string const& key, std::string const& what) const;
    //! `FILE:LINE: PATH: what`
    InputError error(std::string const& what) const;

  private:
    std::vector<double> numbers(std::string const& key, toml::node const& node) const;
    std::string dotted(std::string const& key) const;

    toml::table const* table_;
    std::string path_, origin_;
};

} // namespace demens::ensemble::input
