#pragma once

#include "demens/base/error.hpp"

#include <functional>
#include <string>

namespace demens::test {

//! The message with which an input is refused; empty where it is not.
inline std::string fault_of(std::function<void()> const& use)
{
    try {
        use();
    } catch (InputError const& error) {
        return error.what();
    }
    return {};
}

} // namespace demens::test
