#include "demens/dem/decomposition/bisection.hpp"

#include <algorithm>
#include <limits>

namespace demens::dem {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int bins = 512, rounds = 2; // places of a cut: extent / bins^rounds

double along(Place const& place, int axis)
{
    return axis == 0 ? place.x : axis == 1 ? place.y : place.z;
}

} // namespace

Bisection::Bisection(int ranks, Periods const& periods) : ranks_(ranks), periods_{periods.x, periods.y, {}}
{
    Node all{.first_rank = 0,
             .ranks = ranks,
             .lower = {-infinite, -infinite, -infinite},
             .upper = {infinite, infinite, infinite}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (periods_[axis].on())
            all.lower[axis] = periods_[axis].lower, all.upper[axis] = periods_[axis].upper;
    nodes_ = {all};
    box_of_rank_.assign(static_cast<std::size_t>(ranks), 0);
}

//! The nodes of one depth are cut together, so that the number of messages grows with the depth only.
void Bisection::cut(Team& team, std::span<Place const> places, std::span<double const> weights)
{
    nodes_.resize(1);
    nodes_[0].half = -1;
    std::vector<int> node_of(places.size(), 0);
    for (std::vector<int> level = {0}; true;) {
        std::erase_if(level, [&](int node) { return nodes_[static_cast<std::size_t>(node)].ranks == 1; });
        if (level.empty())
            break;
        auto searches = begin_searches(team, level, places, node_of);
        std::vector<double> sums(searches.size() * 1, 0.0);
        std::vector<int> search_of(nodes_.size(), -1);
        for (std::size_t k = 0; k < searches.size(); ++k)
            search_of[static_cast<std::size_t>(searches[k].node)] = static_cast<int>(k);
        for (std::size_t i = 0; i < places.size(); ++i)
            if (int const k = search_of[static_cast<std::size_t>(node_of[i])]; k >= 0)
                sums[static_cast<std::size_t>(k)] += weights[i];
        team.sum(sums);
        for (std::size_t k = 0; k < searches.size(); ++k) {
            int const ranks = nodes_[static_cast<std::size_t>(searches[k].node)].ranks;
            searches[k].target = sums[k] * (ranks / 2) / ranks;
        }
        for (int round = 0; round < rounds; ++round)
            narrow(team, searches, places, weights, node_of);

        level.clear();
        for (Search const& search : searches) {
            auto const number = static_cast<std::size_t>(search.node);
            nodes_[number].at = search.to;
            nodes_[number].half = static_cast<int>(nodes_.size());
            Node below = nodes_[number], above = nodes_[number];
            below.half = above.half = -1;
            below.ranks = nodes_[number].ranks / 2;
            above.ranks -= below.ranks;
            above.first_rank += below.ranks;
            auto const axis = static_cast<std::size_t>(nodes_[number].axis);
            below.upper[axis] = above.lower[axis] = search.to;
            level.push_back(nodes_[number].half), level.push_back(nodes_[number].half + 1);
            nodes_.push_back(below), nodes_.push_back(above);
        }
        for (std::size_t i = 0; i < places.size(); ++i)
            if (Node const& node = nodes_[static_cast<std::size_t>(node_of[i])]; node.half >= 0)
                node_of[i] = node.half + (along(places[i], node.axis) >= node.at);
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k)
        if (nodes_[k].half < 0)
            box_of_rank_[static_cast<std::size_t>(nodes_[k].first_rank)] = static_cast<int>(k);
}

//! Sets the axes of nodes, and where to look for their cuts: everywhere where they have particles.
std::vector<Bisection::Search> Bisection::begin_searches(Team& team, std::vector<int> const& nodes,
                                                         std::span<Place const> places,
                                                         std::span<int const> node_of)
{
    std::vector<int> search_of(nodes_.size(), -1);
    for (std::size_t k = 0; k < nodes.size(); ++k)
        search_of[static_cast<std::size_t>(nodes[k])] = static_cast<int>(k);
    // Of each node: largest coordinates, and the smallest ones with their sign changed.
    std::vector<std::array<double, 6>> extents(nodes.size());
    for (auto& extent : extents)
        extent.fill(-1e300);
    for (std::size_t i = 0; i < places.size(); ++i) {
        int const k = search_of[static_cast<std::size_t>(node_of[i])];
        if (k < 0)
            continue;
        auto& extent = extents[static_cast<std::size_t>(k)];
        for (int axis = 0; axis < 3; ++axis) {
            double const x = along(places[i], axis);
            auto& upper = extent[static_cast<std::size_t>(axis)];
            auto& lower = extent[static_cast<std::size_t>(axis) + 3];
            upper = std::max(upper, x), lower = std::max(lower, -x);
        }
    }
    team.largest(std::span(extents.empty() ? nullptr : extents[0].data(), 6 * extents.size()));
    std::vector<Search> searches;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        auto& extent = extents[k];
        if (extent[0] < -1e299) // nobody there
            extent.fill(0);
        std::size_t longest = 0;
        for (std::size_t axis = 1; axis < 3; ++axis)
            if (extent[axis] + extent[axis + 3] > extent[longest] + extent[longest + 3])
                longest = axis;
        nodes_[static_cast<std::size_t>(nodes[k])].axis = static_cast<int>(longest);
        searches.push_back({nodes[k], -extent[longest + 3], extent[longest], 0, 0});
    }
    return searches;
}

//! Finds the bins in which the cuts lie.
void Bisection::narrow(Team& team, std::vector<Search>& searches, std::span<Place const> places,
                       std::span<double const> weights, std::span<int const> node_of) const
{
    std::vector<int> search_of(nodes_.size(), -1);
    for (std::size_t k = 0; k < searches.size(); ++k)
        search_of[static_cast<std::size_t>(searches[k].node)] = static_cast<int>(k);
    auto const border = [](Search const& s, int bin) { return s.from + (s.to - s.from) * bin / bins; };
    std::vector<double> histogram(searches.size() * bins, 0.0);
    for (std::size_t i = 0; i < places.size(); ++i) {
        int const k = search_of[static_cast<std::size_t>(node_of[i])];
        if (k < 0)
            continue;
        Search const& s = searches[static_cast<std::size_t>(k)];
        double const x = along(places[i], nodes_[static_cast<std::size_t>(s.node)].axis);
        if (x < s.from || x > s.to || s.to <= s.from)
            continue;
        int bin = std::min(static_cast<int>((x - s.from) / (s.to - s.from) * bins), bins - 1);
        if (x < border(s, bin)) // rounding
            --bin;
        else if (bin + 1 < bins && x >= border(s, bin + 1))
            ++bin;
        histogram[static_cast<std::size_t>(k * bins + bin)] += weights[i];
    }
    team.sum(histogram);
    for (std::size_t k = 0; k < searches.size(); ++k) {
        Search& s = searches[k];
        double const* const weight_of = histogram.data() + k * bins;
        int bin = 0;
        while (bin + 1 < bins && s.weight_below + weight_of[bin] < s.target)
            s.weight_below += weight_of[bin++];
        double const from = border(s, bin), to = bin + 1 < bins ? border(s, bin + 1) : s.to;
        s.from = from, s.to = to;
    }
}

int Bisection::owner(Place const& place) const
{
    std::size_t number = 0;
    while (nodes_[number].half >= 0) {
        Node const& node = nodes_[number];
        number = static_cast<std::size_t>(node.half + (along(place, node.axis) >= node.at));
    }
    return nodes_[number].first_rank;
}

bool Bisection::is_deep_inside(int rank, Place const& place, double distance) const
{
    Node const& box =
        nodes_[static_cast<std::size_t>(box_of_rank_[static_cast<std::size_t>(rank)])];
    return place.x - box.lower[0] >= distance && box.upper[0] - place.x >= distance &&
           place.y - box.lower[1] >= distance && box.upper[1] - place.y >= distance &&
           place.z - box.lower[2] >= distance && box.upper[2] - place.z >= distance;
}

double Bisection::squared_distance(Node const& node, Point const& p) const
{
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto const distance_of = [&](double x) {
            return std::max({node.lower[axis] - x, x - node.upper[axis], 0.0});
        };
        double distance = distance_of(p[axis]);
        if (double const length = periods_[axis].length(); length > 0)
            distance = std::min({distance, distance_of(p[axis] - length), distance_of(p[axis] + length)});
        sum += distance * distance;
    }
    return sum;
}

} // namespace demens::dem
