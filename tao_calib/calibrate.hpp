#pragma once

#include "ensemble/session.hpp"

#include <functional>
#include <mpi.h>
#include <string>

namespace demens::tao_calib {

//! How a calibration ended.
enum class CalibrationEnd
{
    finished, //!< a stop criterion was met; Campaign::ended says which
    failed,   //!< too few runs finished to calibrate anything; Campaign::ended says why
    drained   //!< asked to stop; nothing lost, go on later; the program exits with 75
};

//! Plans, runs and analyses waves until a stop criterion of the campaign is met. Goes on where the campaign
//! is. Collective over `communicator`, the one the session was opened with; rank 0 decides. `on_wave` is
//! called on rank 0 after each analysed wave, with the campaign up to that wave.
CalibrationEnd calibrate(ensemble::Session& session, MPI_Comm communicator = MPI_COMM_WORLD,
                         std::function<void(ensemble::Campaign const&)> const& on_wave = {});

} // namespace demens::tao_calib
