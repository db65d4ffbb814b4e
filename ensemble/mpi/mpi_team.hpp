#pragma once

#include "demens/dem/decomposition/team.hpp"

#include <mpi.h>

namespace demens::ensemble {

//! The ranks of a communicator as the team of a simulation. The communicator must outlive it and serve
//! nothing else meanwhile.
class MpiTeam : public dem::Team
{
  public:
    explicit MpiTeam(MPI_Comm communicator);

    int rank() const override { return rank_; }
    int size() const override { return size_; }
    void sum(std::span<double> values) override;
    using dem::Team::largest;
    void largest(std::span<double> values) override;
    std::vector<Parcel> exchange(std::vector<Parcel> const& out) override;
    std::vector<Bytes> gather(Bytes const& mine) override;
    void begin(std::span<Link const> links, double const* out, double* in) override;
    void finish() override;

  private:
    MPI_Comm communicator_;
    int rank_, size_;
    std::vector<MPI_Request> requests_; //!< of the exchange that has begun
};

} // namespace demens::ensemble
