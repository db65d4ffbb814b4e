#include "src/dem/cpu/decomposition/bisection.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

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

//! What is cut: the particles of this rank, and the node that each is in.
struct Bisection::Cutting
{
    Team& team;
    std::span<Place const> places;
    std::span<double const> weights;
    std::span<int const> node_of;

    //! What the ranks find in each of some nodes: `visit(k, i)` is called for particle i in `nodes[k]`.
    template <class Visit>
    void for_each_in(std::vector<int> const& nodes, Visit&& visit) const
    {
        std::vector<int> number(static_cast<std::size_t>(*std::max_element(nodes.begin(), nodes.end()) + 1),
                                -1);
        for (std::size_t k = 0; k < nodes.size(); ++k)
            number[static_cast<std::size_t>(nodes[k])] = static_cast<int>(k);
        for (std::size_t i = 0; i < places.size(); ++i) {
            auto const node = static_cast<std::size_t>(node_of[i]);
            if (node < number.size() && number[node] >= 0)
                visit(static_cast<std::size_t>(number[node]), i);
        }
    }
};

namespace {

//! Where the cut of a node may be.
struct Search
{
    int axis = 0;
    double from = 0, to = 0; //!< [m]
    double weight = 0, weight_below = 0,
           target = 0; //!< of the node, of what is below `from`, of the first half

    double border(int bin) const { return bin < bins ? from + (to - from) * bin / bins : to; }
    //! Bin of a coordinate between `from` and `to`.
    int bin_of(double x) const
    {
        int const bin = to > from ? std::min(static_cast<int>((x - from) / (to - from) * bins), bins - 1) : 0;
        return x < border(bin) ? bin - 1 : bin + 1 < bins && x >= border(bin + 1) ? bin + 1 : bin; // rounding
    }
    //! Goes on in the bin in which the target is reached.
    void narrow(double const* weight_of_bin)
    {
        int bin = 0;
        while (bin + 1 < bins && weight_below + weight_of_bin[bin] < target)
            weight_below += weight_of_bin[bin++];
        std::tie(from, to) = std::pair(border(bin), border(bin + 1));
    }
};

//! Searches that begin with all the extent of the nodes, along the longest side.
template <class Cutting>
std::vector<Search> begin_searches(Cutting const& cutting, std::vector<int> const& nodes)
{
    // Of each node: largest coordinates, and the smallest ones with their sign changed.
    std::vector<std::array<double, 6>> extents(nodes.size(),
                                               {-1e300, -1e300, -1e300, -1e300, -1e300, -1e300});
    std::vector<double> weights(nodes.size(), 0.0);
    cutting.for_each_in(nodes, [&](std::size_t k, std::size_t i) {
        weights[k] += cutting.weights[i];
        for (int axis = 0; axis < 3; ++axis) {
            auto &upper = extents[k][static_cast<std::size_t>(axis)],
                 &lower = extents[k][static_cast<std::size_t>(axis) + 3];
            double const x = along(cutting.places[i], axis);
            upper = std::max(upper, x), lower = std::max(lower, -x);
        }
    });
    cutting.team.largest(std::span(extents.front().data(), 6 * extents.size()));
    cutting.team.sum(weights);
    std::vector<Search> searches(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        auto const& extent = extents[k];
        if (weights[k] == 0) // nobody there
            continue;
        std::size_t axis = 0;
        for (std::size_t const other : {1u, 2u})
            if (extent[other] + extent[other + 3] > extent[axis] + extent[axis + 3])
                axis = other;
        searches[k] = {static_cast<int>(axis), -extent[axis + 3], extent[axis], weights[k], 0, 0};
    }
    return searches;
}

} // namespace

//! The nodes of one depth are cut together, so that the number of messages grows with the depth only.
void Bisection::cut(Team& team, std::span<Place const> places, std::span<double const> weights)
{
    DEMENS_EXPECT(places.size() == weights.size() && team.size() == ranks_, "a weight a place, a box a rank");
    nodes_.resize(1);
    nodes_[0].half = -1;
    std::vector<int> node_of(places.size(), 0);
    for (std::vector<int> level = {0}; true;) {
        std::erase_if(level, [&](int node) { return nodes_[static_cast<std::size_t>(node)].ranks == 1; });
        if (level.empty())
            break;
        level = halve({team, places, weights, node_of}, level);
        for (std::size_t i = 0; i < places.size(); ++i)
            if (Node const& node = nodes_[static_cast<std::size_t>(node_of[i])]; node.half >= 0)
                node_of[i] = node.half + (along(places[i], node.axis) >= node.at);
    }
    find_boxes_of_ranks();
}

void Bisection::find_boxes_of_ranks()
{
    for (std::size_t k = 0; k < nodes_.size(); ++k)
        if (nodes_[k].half < 0)
            box_of_rank_[static_cast<std::size_t>(nodes_[k].first_rank)] = static_cast<int>(k);
}

Bisection::Cuts Bisection::cuts() const
{
    Cuts cuts;
    for (Node const& node : nodes_) {
        for (int const number : {node.first_rank, node.ranks, node.axis, node.half})
            cuts.numbers.push_back(number);
        cuts.borders.insert(cuts.borders.end(), node.lower.begin(), node.lower.end());
        cuts.borders.insert(cuts.borders.end(), node.upper.begin(), node.upper.end());
        cuts.borders.push_back(node.at);
    }
    return cuts;
}

void Bisection::restore(Cuts const& cuts)
{
    std::size_t const count = cuts.numbers.size() / 4;
    auto const is_within = [&](std::int64_t number, std::int64_t lower, std::int64_t end) {
        if (number < lower || number >= end)
            throw InputError("the state record does not fit together: the boxes of its ranks are no tree");
    };
    is_within(static_cast<std::int64_t>(count), 1, 2 * std::int64_t{ranks_});
    if (cuts.borders.size() != 7 * count || cuts.numbers.size() != 4 * count)
        is_within(-1, 0, 0);
    std::vector<Node> nodes(count);
    for (std::size_t k = 0; k < count; ++k) {
        std::int64_t const* number = cuts.numbers.data() + 4 * k;
        double const* border = cuts.borders.data() + 7 * k;
        is_within(number[0], 0, ranks_), is_within(number[1], 1, ranks_ + 1), is_within(number[2], 0, 3);
        if (number[3] != -1) // halves come later: a search for a box ends
            is_within(number[3], static_cast<std::int64_t>(k) + 1, static_cast<std::int64_t>(count) - 1);
        nodes[k] = {.first_rank = static_cast<int>(number[0]),
                    .ranks = static_cast<int>(number[1]),
                    .lower = {border[0], border[1], border[2]},
                    .upper = {border[3], border[4], border[5]},
                    .axis = static_cast<int>(number[2]),
                    .at = border[6],
                    .half = static_cast<int>(number[3])};
    }
    nodes_ = std::move(nodes);
    find_boxes_of_ranks();
}

std::vector<int> Bisection::halve(Cutting const& cutting, std::vector<int> const& nodes)
{
    auto searches = begin_searches(cutting, nodes);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        int const ranks = nodes_[static_cast<std::size_t>(nodes[k])].ranks, half = ranks / 2;
        searches[k].target = searches[k].weight * half / ranks;
    }
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> histogram(searches.size() * bins, 0.0);
        cutting.for_each_in(nodes, [&](std::size_t k, std::size_t i) {
            Search const& search = searches[k];
            double const x = along(cutting.places[i], search.axis);
            if (x >= search.from && x <= search.to)
                histogram[k * bins + static_cast<std::size_t>(search.bin_of(x))] += cutting.weights[i];
        });
        cutting.team.sum(histogram);
        for (std::size_t k = 0; k < searches.size(); ++k)
            searches[k].narrow(histogram.data() + k * bins);
    }
    std::vector<int> halves;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        auto const half = static_cast<int>(nodes_.size());
        Node& node = nodes_[static_cast<std::size_t>(nodes[k])];
        node.axis = searches[k].axis, node.at = searches[k].to, node.half = half;
        Node below = node, above = node;
        below.half = above.half = -1;
        below.ranks = node.ranks / 2;
        above.ranks -= below.ranks;
        above.first_rank += below.ranks;
        auto const axis = static_cast<std::size_t>(node.axis);
        below.upper[axis] = above.lower[axis] = node.at;
        nodes_.push_back(below), nodes_.push_back(above);
        halves.insert(halves.end(), {half, half + 1});
    }
    return halves;
}

int Bisection::owner(Place const& place) const
{
    std::size_t number = 0;
    while (nodes_[number].half >= 0) {
        Node const& node = nodes_[number];
        number = static_cast<std::size_t>(node.half) + (along(place, node.axis) >= node.at ? 1 : 0);
    }
    return nodes_[number].first_rank;
}

bool Bisection::is_deep_inside(int rank, Place const& place, double distance) const
{
    Node const& box = nodes_[static_cast<std::size_t>(box_of_rank_[static_cast<std::size_t>(rank)])];
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
