#pragma once

#include <stdexcept>

namespace demens {

//! A file that cannot be written or read although the input is good: full disk, no permission, damage.
class FileError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

} // namespace demens
