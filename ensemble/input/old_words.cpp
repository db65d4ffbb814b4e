#include "ensemble/input/old_words.hpp"

#include "ensemble/input/kinds.hpp"

#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

bool names_a_search(std::string const& kind)
{
    return find_word<SearchKind>(kind) != nullptr;
}

} // namespace

void refuse_old_words(InputTable const& solver)
{
    if (solver.has("batch"))
        throw solver.error("batch", "stands in [search] now; write it there");
    OptionSpec const any_word{.key = "kind", .default_value = std::string(), .doc = "solver"};
    if (!solver.has("kind"))
        return;
    auto const kind = std::get<std::string>(solver.read_option(any_word));
    if (names_a_search(kind))
        throw solver.error(
            "kind", fmt::format("names how points are chosen, which stands in [search] now; write kind = "
                                "\"{}\" there and leave it out here",
                                kind));
}

void understand_old_words(toml::table& file)
{
    auto* const solver = file["solver"].as_table();
    if (!solver)
        return;
    auto const kind = (*solver)["kind"].value<std::string>();
    bool const moves_kind = kind && names_a_search(*kind);
    if (!moves_kind && !solver->contains("batch"))
        return;
    if (!file.contains("search"))
        file.insert("search", toml::table{});
    auto* const search = file["search"].as_table();
    auto move = [&](char const* key) {
        if (auto const* value = solver->get(key)) {
            if (search)
                search->insert(key, *value);
            solver->erase(key);
        }
    };
    if (moves_kind)
        move("kind");
    move("batch");
}

} // namespace demens::ensemble::input
