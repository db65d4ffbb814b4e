#pragma once

#include "demens/dem/team.hpp"

#include <algorithm>
#include <barrier>
#include <functional>
#include <thread>

namespace demens::test {

//! Threads of one process as a team.
class ThreadTeam : public dem::Team
{
  public:
    //! What the threads see of each other.
    struct Meeting
    {
        explicit Meeting(int size)
            : size(size), barrier(size), values(size), parcels(size), links(size), out(size)
        {
        }
        int size;
        std::barrier<> barrier;
        std::vector<std::vector<double>> values;
        std::vector<std::vector<Parcel>> parcels;
        std::vector<std::span<Link const>> links;
        std::vector<double const*> out;
    };

    ThreadTeam(Meeting& meeting, int rank) : meeting_(meeting), rank_(rank) {}

    int rank() const override { return rank_; }
    int size() const override { return meeting_.size; }
    void sum(std::span<double> values) override
    {
        reduce(values, [](double a, double b) { return a + b; });
    }
    using dem::Team::largest;
    void largest(std::span<double> values) override
    {
        reduce(values, [](double a, double b) { return std::max(a, b); });
    }
    std::vector<Parcel> exchange(std::vector<Parcel> const& out) override
    {
        meeting_.parcels[rank_] = out;
        meeting_.barrier.arrive_and_wait();
        std::vector<Parcel> in;
        for (int from = 0; from < size(); ++from)
            for (auto const& parcel : meeting_.parcels[from])
                if (parcel.rank == rank_)
                    in.push_back({from, parcel.bytes});
        meeting_.barrier.arrive_and_wait();
        return in;
    }
    std::vector<Bytes> gather(Bytes const& mine) override
    {
        std::vector<Parcel> out;
        for (int to = 0; to < size(); ++to)
            out.push_back({to, mine});
        std::vector<Bytes> all;
        for (auto& parcel : exchange(out))
            all.push_back(std::move(parcel.bytes));
        return all;
    }
    void begin(std::span<Link const> links, double const* out, double* in) override
    {
        meeting_.links[rank_] = links;
        meeting_.out[rank_] = out;
        in_ = in;
    }
    void finish() override
    {
        meeting_.barrier.arrive_and_wait();
        for (Link const& mine : meeting_.links[rank_])
            for (Link const& theirs : meeting_.links[mine.rank])
                if (theirs.rank == rank_)
                    std::copy_n(meeting_.out[mine.rank] + theirs.out_begin, theirs.out_count,
                                in_ + mine.in_begin);
        meeting_.barrier.arrive_and_wait();
    }

  private:
    template <class Operation>
    void reduce(std::span<double> values, Operation&& operation)
    {
        meeting_.values[rank_].assign(values.begin(), values.end());
        meeting_.barrier.arrive_and_wait();
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] = meeting_.values[0][k];
            for (int rank = 1; rank < size(); ++rank)
                values[k] = operation(values[k], meeting_.values[rank][k]);
        }
        meeting_.barrier.arrive_and_wait();
    }

    Meeting& meeting_;
    int rank_;
    double* in_ = nullptr;
};

//! Calls `body(team)` on a thread for each rank.
inline void with_team(int size, std::function<void(dem::Team&)> const& body)
{
    ThreadTeam::Meeting meeting(size);
    std::vector<std::thread> threads;
    for (int rank = 0; rank < size; ++rank)
        threads.emplace_back([&, rank] {
            ThreadTeam team(meeting, rank);
            body(team);
        });
    for (auto& thread : threads)
        thread.join();
}

} // namespace demens::test
