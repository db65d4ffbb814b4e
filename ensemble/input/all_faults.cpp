#include "ensemble/input/all_faults.hpp"

#include "demens/contact/model.hpp"
#include "ensemble/input/campaign_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/input_table.hpp"
#include "ensemble/input/section.hpp"
#include "ensemble/input/toml_file.hpp"

#include <algorithm>

namespace demens::ensemble::input {
namespace {

constexpr std::size_t most_told = 20;

//! Faults as they are met, each once.
class Faults
{
  public:
    explicit Faults(std::string const& first) : lines_{first} {}

    //! Keys of a table that do not exist, are missing or hold what they may not.
    void look_at(InputTable const& table, std::vector<OptionSpec> const& specs,
                 std::vector<std::string> const& others = {})
    {
        auto known = keys_of(specs);
        known.insert(known.end(), others.begin(), others.end());
        for (auto const& key : table.keys())
            if (std::find(known.begin(), known.end(), key) == known.end())
                guarded([&] { table.allow_only_key(key, known); });
        for (auto const& spec : specs)
            if (table.has(spec.key))
                guarded([&] { table.read_option(spec); });
    }
    template <class Call>
    void guarded(Call const& call)
    {
        try {
            call();
        } catch (InputError const& error) {
            if (lines_.size() <= most_told &&
                std::find(lines_.begin(), lines_.end(), error.what()) == lines_.end())
                lines_.emplace_back(error.what());
        }
    }
    std::string text() const
    {
        std::string text;
        for (auto const& line : lines_)
            text += (text.empty() ? "" : "\n") + line;
        return lines_.size() > most_told ? text + "\nand more" : text;
    }

  private:
    std::vector<std::string> lines_;
};

void look_at_experiment(Faults& faults, InputTable table, std::vector<rig::RigInfo> const& rigs)
{
    auto const text_of = [&](char const* key) {
        std::string text;
        faults.guarded([&] {
            if (table.has(key))
                text = std::get<std::string>(table.read_option(spec_of(experiment_options(), key)));
        });
        return text;
    };
    if (auto const name = text_of("name"); !name.empty())
        table.set_path("experiment." + name);
    auto const name = text_of("rig");
    auto const rig =
        std::find_if(rigs.begin(), rigs.end(), [&](auto const& candidate) { return candidate.name == name; });
    if (rig == rigs.end())
        return;
    auto specs = experiment_options();
    specs.insert(specs.end(), rig->options.begin(), rig->options.end());
    std::vector<std::string> others = {"target"};
    for (auto const& inside : rig->tables)
        others.push_back(inside.key);
    faults.look_at(table, specs, others);
}

void look_at_tables(Faults& faults, InputTable const& file, std::vector<rig::RigInfo> const& rigs)
{
    auto const materials = file.table("material"), contacts = file.table("contact");
    for (auto const& name : materials.keys())
        faults.guarded([&] { faults.look_at(materials.table(name), contact::material_options()); });
    for (auto const& name : contacts.keys())
        faults.guarded([&] { faults.look_at(contacts.table(name), contact::pair_options()); });
    for (auto const& table : file.table_list("experiment"))
        look_at_experiment(faults, table, rigs);
    for (auto const& table : file.table_list("factor"))
        faults.look_at(table, factor_options(), keys_of(factor_lists()));
    faults.look_at(file.table("screening"), specs_of<ScreeningOptions>(), keys_of(screening_lists()));
    faults.look_at(file.table("design"), specs_of<DesignOptions>(), keys_of(design_lists()));
    faults.look_at(file.table("surrogate"), specs_of<SurrogateOptions>());
    faults.look_at(file.table("search"), specs_of<SearchOptions>());
    faults.look_at(file.table("stop"), specs_of<StopOptions>());
    faults.look_at(file.table("run"), specs_of<RunOptions>());
}

} // namespace

std::string with_all_faults(std::string const& first, std::string const& toml, std::string const& origin,
                            std::vector<rig::RigInfo> const& rigs)
{
    Faults faults(first);
    faults.guarded([&] {
        auto const parsed = parse_toml(toml, origin);
        look_at_tables(faults, InputTable(parsed, "", origin), rigs);
    });
    return faults.text();
}

} // namespace demens::ensemble::input
