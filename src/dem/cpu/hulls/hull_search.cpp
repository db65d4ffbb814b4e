#include "src/dem/cpu/hulls/hull_search.hpp"

#include <algorithm>
#include <utility>

namespace demens::dem {
namespace {

//! The two in the order in which they always are, whatever their numbers: a hull before a ball, else the one
//! that was added first.
HullPair in_order(CandidatePair const& pair, Particles const& particles)
{
    auto const [i, j] = pair;
    bool const turned = particles.is_hull(i) == particles.is_hull(j) ? particles.id[j] < particles.id[i]
                                                                     : particles.is_hull(j);
    return turned ? HullPair{j, i} : HullPair{i, j};
}

bool comes_before(HullPair const& a, HullPair const& b)
{
    return a.first != b.first ? a.first < b.first : a.second < b.second;
}

//! Gives the pairs of a list, which are new, what they had in old ones. \param new_number of a particle
template <class NewNumber>
void carry_over(HullContactList& list, std::initializer_list<HullContactList const*> all_old,
                NewNumber const& new_number)
{
    std::sort(list.pairs.begin(), list.pairs.end(), comes_before);
    struct Old
    {
        HullPair pair; // by its new numbers
        HullContactList const* list;
        Slots contacts;
    };
    std::vector<Old> before;
    for (HullContactList const* old : all_old)
        old->for_each_pair([&](HullPair pair, Slots const& contacts) {
            pair.first = new_number(pair.first);
            if (!old->with_walls())
                pair.second = new_number(pair.second);
            before.push_back({pair, old, contacts});
        });
    std::sort(before.begin(), before.end(),
              [](Old const& a, Old const& b) { return comes_before(a.pair, b.pair); });
    auto next = before.begin();
    for (std::uint32_t p = 0; p < list.pairs.size(); ++p) {
        HullPair& pair = list.pairs[p];
        while (next != before.end() && comes_before(next->pair, pair))
            ++next;
        if (next == before.end() || comes_before(pair, next->pair))
            continue;
        pair.memory = next->pair.memory;
        list.add_contacts(p, *next->list, next->contacts);
    }
}

} // namespace

std::size_t HullContactList::touching() const
{
    std::size_t count = 0;
    for (std::size_t c = 0; c < contacts.size(); ++c)
        count += c == 0 || contacts[c].pair != contacts[c - 1].pair;
    return count;
}

void HullSearch::rebuild(NeighbourSearch const& search, Particles const& particles,
                         std::vector<Wall> const& walls, HullContactLists& lists)
{
    HullContactLists const old = std::exchange(lists, {});
    old.for_each([&](HullContactList const& list) { lists.of(list.kind).push_back(list.emptied()); });
    auto const laws_of = [&](std::uint32_t hull, std::uint32_t other) {
        return interaction_[particles.material[hull] * materials_ + other];
    };
    for (CandidatePair const& candidate : search.hull_pairs()) {
        HullPair const pair = in_order(candidate, particles);
        bool const with_ghost = std::max(pair.first, pair.second) >= particles.owned();
        auto const laws = laws_of(pair.first, particles.material[pair.second]);
        (with_ghost ? lists.ghosts : lists.pairs)[laws].pairs.push_back(pair);
    }
    for (auto const& [hull, wall] : search.hulls_at_walls())
        lists.walls[laws_of(hull, walls[wall].material.value)].pairs.push_back({hull, wall});
    auto const new_number = [&](std::uint32_t particle) { return search.new_numbers()[particle]; };
    for (std::size_t k = 0; k < lists.pairs.size(); ++k) {
        carry_over(lists.walls[k], {&old.walls[k]}, new_number);
        if (lists.ghosts.empty()) {
            carry_over(lists.pairs[k], {&old.pairs[k]}, new_number);
            continue;
        }
        for (auto* now :
             {&lists.pairs[k], &lists.ghosts[k]}) // one of a pair may have become a ghost, or none
            carry_over(*now, {&old.pairs[k], &old.ghosts[k]}, new_number);
    }
}

} // namespace demens::dem
