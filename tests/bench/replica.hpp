#pragma once

#include "demens/dem/simulation.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace demens::bench {

//! One sphere of a prepared state, SI units.
struct Sphere
{
    double radius;
    Vector3 position, velocity, spin;
};

//! A granular state that every code starts from: a dense bed in a box, or a drum in flow.
struct State
{
    std::string kind;            //!< "box" or "drum"
    double width = 0, depth = 0; //!< box: sides along x and y; drum: radius, length along y [m]
    double spin = 0;             //!< of the drum about y [rad/s]
    double time_step = 0;        //!< [s]
    double skin = 0;             //!< of the neighbour list [m]
    std::vector<Sphere> spheres = {};
};

//! Radii of the spheres of a state.
enum class Sizes
{
    spread,     //!< 0.5 to 1 mm
    equal,      //!< 0.5 mm
    one_to_ten, //!< 0.5 mm, and as much volume again in spheres of 5 mm
};

//! What may differ between simulations of one state.
struct Setting
{
    contact::Model model;
    int mantle_triangles = 0; //!< of the drum's mantle, about; 0: a cylinder
    double skin = 0;          //!< [m]; 0: that of the state
    dem::Team* team = nullptr;
};

//! E = 5 MPa, nu = 0.3, e = 0.4, mu = 0.5, mu_r = 0.1, 2500 kg/m^3: Hertz-Mindlin with history, as the peers
//! have it; `rolling`: none or epsd2.
contact::Model powder(std::string const& rolling);
//! The state as a simulation, without contact histories.
std::unique_ptr<dem::Simulation> make_simulation(State const& state, Setting const& setting);

//! Spheres at rest in a box as wide as the bed is high.
State settled_box(int spheres, Sizes sizes);
//! The box side by side with itself, `along_x` times `along_y` boxes without walls between them.
State tiled_box(State const& box, int along_x, int along_y);
//! Spheres in a drum, 15 to 25 % full, Froude number 0.01, after a quarter of a turn.
State flowing_drum(int spheres, Sizes sizes);

//! Exact text file. \throws InputError
void write_state(State const& state, std::filesystem::path const& file);
State read_state(std::filesystem::path const& file);
//! The same state for `read_data` of LIGGGHTS and LAMMPS (atom style sphere).
void write_peer_data(State const& state, std::filesystem::path const& file);
//! The drum's mantle as an STL of the given number of quads around.
void write_drum_stl(State const& state, int quads, std::filesystem::path const& file);

} // namespace demens::bench
