#pragma once

#include "demens/observe/picture/picture.hpp"
#include "demens/rig/programme/bench.hpp"

#include <limits>

namespace demens::rig {

//! What stands there before the first stage begins.
struct Apparatus
{
    contact::Model model;
    dem::SimulationOptions options; //!< the team is whoever runs it
    dem::BodyBatch bodies = {};
    std::vector<dem::Wall> walls = {}; //!< in the order of their ids
};

//! What becomes of a run when a stage has lasted as long as it may, and what it waits for has not come.
enum class Overrun
{
    fail,
    go_on
};

//! What happens one after another.
struct Stage
{
    std::string name;
    std::function<bool(Look&)> needed = {};   //!< whether it takes place at all; null: it does
    std::optional<contact::Model> model = {}; //!< coefficients from its beginning on; none: as before
    std::function<void(Bench&)> enter = {};   //!< changes walls and particles at its beginning
    std::function<void(Bench&)> at_look =
        {};                                //!< what happens on the way, after each look that does not end it
    std::function<bool(Look&)> until = {}; //!< ends it; null: it takes `shortest`
    std::string waits_for = {};            //!< in words, for messages
    double shortest = 0;                   //!< not asked whether it ends before [s]
    double longest = 0;                    //!< with `until`: by when that must hold [s]
    Overrun overrun = Overrun::fail;       //!< ... and if it does not
    std::function<bool(Look&)> repeats = {}; //!< whether it begins again when it is over
    std::int64_t looks_per_sample = 0;       //!< a row of the series every so many looks; 0: none
    std::string landmark = {};               //!< name of a snapshot that is kept of its end
};

//! A column of the series.
struct Reading
{
    std::string name, units, doc;
    std::function<double(Look&)> take; //!< NaN: there is nothing to look at
};

//! A curve over another axis than time, read at the end of a stage or averaged over its samples.
struct ProfileReading
{
    enum class Over
    {
        end,
        samples //!< mean over the samples of the stage, with the axis of the first one
    };
    struct Axis
    {
        std::string name, units;
    };
    struct Points
    {
        std::vector<double> axis, values; //!< NaN: no value there
    };

    std::string name, doc;
    Axis axis, value;
    std::size_t stage;
    Over over;
    std::function<Points(Look&)> take;
};

//! A number that is made of the curves which the run has recorded, once a stage is over.
struct Response
{
    ResponseInfo info;
    std::size_t stage;                             //!< whose end has all that it needs
    std::string if_none;                           //!< why it may have no value, for messages
    std::function<double(Progress const&)> reduce; //!< NaN: it has none, and the run fails
};

//! A run as a rig describes it. Whatever is asked about a run follows from it.
struct Programme
{
    double time_step = 0;            //!< [s]
    std::int64_t steps_per_look = 1; //!< how often conditions are asked, readings taken, the health checked
    double expected_particles = 1;
    double work_per_particle = 1; //!< what a step of one takes over one of a sphere in a bed, about
    double expected_duration = 0; //!< [s]
    std::uint64_t seed = 0;       //!< of the random numbers that stages draw
    EngineChoice engine = EngineChoice::cpu;
    bool has_rigid_bodies =
        false; //!< grains of several spheres: the CPU's engine alone moves them, on one rank
    bool removes_particles = false; //!< the CPU's engine alone takes particles out
    bool reads_loads = false;       //!< whether forces must be known at the very first look
    std::vector<Stage> stages = {};
    observe::SnapshotNames names = {}; //!< of materials, groups and walls, by their numbers; for frames
    std::vector<Reading> readings = {};
    std::vector<ProfileReading> profiles = {};
    std::vector<Response> responses = {};
    //! Raster of the profile `picture`, pixel after pixel from the upper left corner; none: it is not
    //! recorded.
    std::optional<observe::PictureFrame> picture = {};
    //! Checks that take too long for every time that a run is planned; gives back what is doubtful about a
    //! run that can be done. \throws InputError
    std::function<std::vector<std::string>()> check = {};
    //! Makes what stands there at first. \throws InputError
    std::function<Apparatus()> build = {};

    double expected_work() const //!< [steps of a sphere]
    {
        return expected_particles * work_per_particle * expected_duration / time_step;
    }
    EngineNeeds needs(bool with_team) const { return {with_team, has_rigid_bodies, removes_particles}; }
};

//! A run of a rig that is described, for so many ranks. \throws InputError where it cannot be done
Programme programme_of(RigInfo const& rig, RunInput const& input, int ranks);

} // namespace demens::rig
