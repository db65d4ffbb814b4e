#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <cstdint>
#include <vector>

namespace demens::dem {

//! The second stage of the search: which candidates are contacts for the time being.
class ContactRenewal
{
  public:
    //! Makes contacts of the candidates whose surfaces are nearer than `reach` [m]; contacts keep their
    //! histories, and those that touch stay.
    void renew(ContactList& list, Particles const& particles, Periods const& periods, double reach);

  private:
    std::vector<std::uint32_t> near_; //!< numbers of candidates
    ContactList old_;
};

} // namespace demens::dem
