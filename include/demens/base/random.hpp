#pragma once

#include <cstdint>

namespace demens {

//! Mixes a 64-bit word so that every input bit changes every output bit (SplitMix64 finaliser, Steele 2014).
constexpr std::uint64_t mix_bits(std::uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
}

//! Seed of a child stream: depends on the parent seed and the child's key only, never on an order of calls.
constexpr std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t key)
{
    return mix_bits(mix_bits(seed + 0x9e3779b97f4a7c15ull) ^ mix_bits(key + 0xd1b54a32d192ed03ull));
}

//! Counter-based random numbers: number n of a stream is a function of (seed, n).
class RandomStream
{
  public:
    //! \param drawn so many numbers were drawn before
    explicit constexpr RandomStream(std::uint64_t seed, std::uint64_t drawn = 0)
        : seed_(seed), counter_(drawn)
    {
    }

    constexpr std::uint64_t seed() const { return seed_; }
    constexpr std::uint64_t drawn() const { return counter_; }

    //! Next 64 random bits.
    constexpr std::uint64_t next() { return derive_seed(seed_, counter_++); }
    //! Uniform in [0, 1).
    constexpr double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
    //! Uniform in [lower, upper).
    constexpr double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
    //! Uniform integer in [0, n), n > 0.
    constexpr std::uint64_t below(std::uint64_t n) { return next() % n; }

  private:
    std::uint64_t seed_;
    std::uint64_t counter_;
};

} // namespace demens
