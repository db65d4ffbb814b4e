#include "ensemble/input/nearest.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::ensemble::input {

std::size_t edit_distance(std::string const& a, std::string const& b)
{
    // Optimal string alignment: the table's rows before the last one are needed for swaps.
    std::vector<std::vector<std::size_t>> distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                distance[i][j] = i + j;
                continue;
            }
            std::size_t const replaced = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            distance[i][j] = std::min({replaced, distance[i - 1][j] + 1, distance[i][j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
        }
    }
    return distance.back().back();
}

std::string nearest(std::string const& word, std::vector<std::string> const& candidates)
{
    std::string best;
    std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (auto const& candidate : candidates) {
        std::size_t const distance = edit_distance(word, candidate);
        // A candidate that shares no letter with the word is no suggestion, however short both are.
        if (distance < least && distance < std::max(word.size(), candidate.size())) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

std::string suggestion(std::string const& word, std::vector<std::string> const& candidates)
{
    if (auto const best = nearest(word, candidates); !best.empty())
        return fmt::format("did you mean \"{}\"?", best);
    // A word that is a part of others stands for one of them.
    std::vector<std::string> longer;
    for (auto const& candidate : candidates)
        if (word.size() >= 3 && ("_" + candidate + "_").find("_" + word + "_") != std::string::npos)
            longer.push_back(candidate);
    if (!longer.empty())
        return fmt::format("did you mean {}?", fmt::join(longer, ", "));
    if (candidates.empty())
        return "there is none to choose from";
    return fmt::format("known: {}", fmt::join(candidates, ", "));
}

} // namespace demens::ensemble::input
