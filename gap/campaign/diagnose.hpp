#pragma once

#include "ensemble/session.hpp"

#include <mpi.h>

namespace demens::gap {

//! Goes on with a campaign that is calibrated: plans and runs the waves of its diagnosis until it is
//! complete. Collective over `communicator`, the one the session was opened with; rank 0 decides. \return
//! drained when asked to stop: go on later
ensemble::WaveEnd diagnose(ensemble::Session& session, MPI_Comm communicator = MPI_COMM_WORLD);

//! Goes on with a campaign whose design stands first: the design, then first looks at all effects about the
//! middle of the factors. What it finds needs no measured values.
ensemble::WaveEnd plan_ahead(ensemble::Session& session, MPI_Comm communicator = MPI_COMM_WORLD);

//! Goes on with a bank whose design stands first: each effect at so many points over the range of the
//! factors.
ensemble::WaveEnd fill_bank(ensemble::Session& session, int points_per_effect,
                            MPI_Comm communicator = MPI_COMM_WORLD);

} // namespace demens::gap
