#pragma once

#include "demens/rig/programme/programme.hpp"

#include <string>

namespace demens::report {

//! What stands there when a run's first stage begins, for a deck of another program.
struct Scene
{
    contact::Model model;
    dem::SimulationOptions options;
    dem::BodyBatch bodies;
    std::vector<dem::Wall> walls;
    double expected_particles = 0;
    bool has_grains = false; //!< of several spheres
    double duration = 0;     //!< expected [s]
    Vector3 lower, upper;    //!< box that holds all of it, with room for what flies away [m]

    //! Mean of the particles' places [m].
    Vector3 middle() const;
};

//! \throws InputError where a rig refuses the input
Scene scene_of(rig::RigInfo const& rig, rig::RunInput const& input);
//! Why no deck can be written of it; empty: one can.
std::string fault_of(Scene const& scene);
//! What a deck leaves out, one line each.
std::vector<std::string> left_out(Scene const& scene);

//! Box, particles and their velocities as a data file that LIGGGHTS and LAMMPS read.
std::string data_file(Scene const& scene);
//! The surface of a wall as ASCII STL, cut to the scene.
std::string stl_file(Scene const& scene, dem::Wall const& wall, std::string const& name);
//! Whether a wall is to be written: it is there, and no repetition of another.
bool is_written(dem::Wall const& wall);

//! Input scripts. \param name of the experiment; the files it reads are NAME.data and, LIGGGHTS,
//! NAME.wallK.stl
std::string liggghts_deck(Scene const& scene, std::string const& name);
std::string lammps_deck(Scene const& scene, std::string const& name);

} // namespace demens::report
