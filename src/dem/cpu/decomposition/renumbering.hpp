#pragma once

#include "src/dem/cpu/removal.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace demens::dem {

//! What particles are numbered before they move to new owners and afterwards. Before it the contact lists
//! number them as `ContactNumbers` has it.
class Renumbering
{
  public:
    explicit Renumbering(ContactNumbers const& before) : before_(before) {}

    //! The particles that were here, and the new numbers of those that stay; others are `gone`.
    void set(std::vector<std::uint32_t> ids, std::vector<std::uint32_t> new_numbers);
    //! Those from this number on have come, or are the new ghosts.
    void add(Particles const& particles, std::size_t from);

    //! New number of a particle of the lists; `gone` where it is neither here nor a ghost.
    std::uint32_t number_of(std::uint32_t before) const;
    //! New number of what has come, or is a ghost; else `gone`.
    std::uint32_t find(std::uint32_t id) const;
    bool has_come(std::uint32_t number) const { return number >= stayed_; }
    bool have_all_stayed() const { return stayed_ == ids_.size(); }

  private:
    ContactNumbers before_;
    std::vector<std::uint32_t> ids_, new_numbers_;
    std::size_t stayed_ = 0;
    std::unordered_map<std::uint32_t, std::uint32_t> numbers_; //!< by id, of what came and of ghosts
};

//! Pairs that are known here already, of those of which one has come or is a ghost: two ranks may send the
//! same one, with the same history.
class KnownPairs
{
  public:
    //! Whether it is new, by the ids of both.
    bool insert(std::uint32_t a, std::uint32_t b)
    {
        return keys_.insert(static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b)).second;
    }

  private:
    std::unordered_set<std::uint64_t> keys_;
};

} // namespace demens::dem
