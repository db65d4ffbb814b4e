#pragma once

#include "demens/dem/team.hpp"

#include <mpi.h>

namespace demens::ensemble {

//! When the ghosts of a step travel while forces are computed. Within one machine the processor copies them
//! anyway, and ranks that meet once more in the middle of a step lose more than they hide.
enum class Overlap
{
    across_machines,
    always
};

//! The ranks of a communicator as the team of a simulation. The communicator must outlive it and serve
//! nothing else meanwhile.
class MpiTeam : public dem::Team
{
  public:
    explicit MpiTeam(MPI_Comm communicator, Overlap overlap = Overlap::across_machines);

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
    bool overlaps_;
    std::vector<MPI_Request> requests_; //!< of the exchange that has begun
};

} // namespace demens::ensemble
