#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace demens::dem {

//! The processes that share one simulation, as the engine sees them; whoever starts them says how they talk.
//! All of them call everything here in the same order.
class Team
{
  public:
    using Bytes = std::vector<std::byte>;

    //! Bytes for a rank, or from it.
    struct Parcel
    {
        int rank;
        Bytes bytes;
    };
    //! Numbers that go to a rank and come from it at every step: their places in two buffers.
    struct Link
    {
        int rank;
        std::size_t out_begin, out_count, in_begin, in_count;
    };

    virtual ~Team() = default;

    virtual int rank() const = 0;
    virtual int size() const = 0;
    //! Sums over all ranks in place, the same bits on all of them.
    virtual void sum(std::span<double> values) = 0;
    //! Largest values of all ranks, in place. No value may be NaN.
    virtual void largest(std::span<double> values) = 0;
    //! Delivers parcels to a few other ranks; gives back those for this one, in the order of their senders.
    virtual std::vector<Parcel> exchange(std::vector<Parcel> const& out) = 0;
    //! What every rank gives, in the order of the ranks.
    virtual std::vector<Bytes> gather(Bytes const& mine) = 0;
    //! Sends and receives over links while the caller goes on; links and buffers must live until `finish`.
    virtual void begin(std::span<Link const> links, double const* out, double* in) = 0;
    virtual void finish() = 0;

    double largest(double value)
    {
        largest(std::span(&value, 1));
        return value;
    }
    //! Whether it holds on any rank.
    bool any(bool here) { return largest(here ? 1.0 : 0.0) > 0; }
};

} // namespace demens::dem
