#pragma once

#include "demens/contact/model.hpp"
#include "demens/dem/periods.hpp"
#include "demens/dem/surroundings.hpp"

namespace demens::dem {

class DeviceBatch;
class Team;

//! Where a simulation is computed.
enum class EngineKind
{
    cpu,         //!< this process, or with a team several
    cuda,        //!< a CUDA device
    cuda_on_host //!< what runs on such a device, as loops of this process: slow, for tests
};

struct SimulationOptions
{
    double time_step = 1e-5;         //!< [s]
    Vector3 gravity = {0, 0, -9.81}; //!< [m/s^2]
    Surroundings surroundings = {};  //!< what acts on particles beside contacts and gravity
    double skin = 1e-3;              //!< distance beyond contact that a neighbour list covers [m]
    double overlap_limit = 0.5;      //!< largest overlap over the smaller radius that counts as healthy
    Vector3 domain_lower = {-1e9, -1e9, -1e9}; //!< particles outside have escaped [m]
    Vector3 domain_upper = {1e9, 1e9, 1e9};
    Periods periodic = {};       //!< particles that leave a period come back on its other side
    bool energy_ledger = false;  //!< account for all energy; the motion is the same, bit for bit
    double closure_limit = 0.05; //!< largest closure error of the ledger that counts as healthy
    Team* team = nullptr;        //!< who shares the simulation; null: nobody
    EngineKind engine = EngineKind::cpu;
    DeviceBatch* batch = nullptr; //!< whose slot an engine of its kind takes; null: a device to itself
};

//! Rayleigh time of a sphere: a wave crosses its surface (Ning and Thornton 1993) [s].
double rayleigh_time(double radius, contact::Material const& material);

} // namespace demens::dem
