#pragma once

#include "src/dem/cpu/state.hpp"
#include "src/dem/params.hpp"

#include <memory>

namespace demens::dem {

//! Evaluates contacts: finds those of a list that touch, gathers them in blocks, calls the laws, and adds
//! loads, histories and losses to the state.
class ContactLoop
{
  public:
    void compute(Params const& params, State& state, ContactList& list);

  private:
    void evaluate(Params const& params, State& state, ContactList& list, std::uint32_t const* slots,
                  std::size_t count);

    std::unique_ptr<ContactBlock> block_ = std::make_unique<ContactBlock>();
    std::vector<std::uint32_t> touching_, parted_; //!< slots found by the pair test
};

} // namespace demens::dem
