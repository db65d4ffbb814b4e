#pragma once

#include <unistd.h>
#include <utility>

namespace demens::ensemble {

//! An open file of the operating system; closed with its owner.
class Descriptor
{
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }

    int get() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }
    //! Closes early; 0 or -1 with errno, since a full network disk may only be told now.
    int close() { return number_ < 0 ? 0 : ::close(std::exchange(number_, -1)); }

  private:
    int number_ = -1;
};

} // namespace demens::ensemble
