#pragma once

#include "demens/base/rotation.hpp"

#include <cstdint>
#include <numbers>

namespace demens::grain {

//! Numbers between 0 and 1 that are the same everywhere.
class Numbers
{
  public:
    double operator()()
    {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }
    Vector3 direction()
    {
        while (true) {
            Vector3 const v{2 * (*this)() - 1, 2 * (*this)() - 1, 2 * (*this)() - 1};
            if (double const n = norm(v); n > 0.1 && n < 1)
                return v / n;
        }
    }
    Rotation rotation() { return rotation_about(direction(), 2 * std::numbers::pi * (*this)()); }

  private:
    std::uint64_t state_ = 7;
};

} // namespace demens::grain
