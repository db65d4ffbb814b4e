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

//! A run that cannot go on: becomes the status of that run, never the end of a campaign.
class RunError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

} // namespace demens
