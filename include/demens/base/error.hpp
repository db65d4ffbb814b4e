#pragma once

#include <stdexcept>
#include <string>

namespace demens {

//! Bad input, found before anything runs. The message says what is wrong, where, and what would be right.
class InputError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

} // namespace demens
