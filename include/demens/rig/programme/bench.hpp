#pragma once

#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "demens/rig/rig.hpp"

#include <any>
#include <limits>
#include <optional>
#include <typeindex>

namespace demens::rig {

//! Particles that entered under one name.
struct EnteredGroup
{
    dem::IdRange ids = {};                                   //!< none before it enters
    double level = std::numeric_limits<double>::quiet_NaN(); //!< height of the surface that it met [m]
};

//! Everything of a run beside its simulation: where it is in its programme and what it has recorded. With the
//! simulation's state it can be stored, and gone on with.
struct Progress
{
    std::size_t stage = 0;
    bool entered = false;                     //!< whether the stage has begun
    std::vector<double> begins = {};          //!< when each stage began [s]; NaN: not yet
    std::int64_t looks = 0;                   //!< in this stage
    std::int64_t steps_to_look = 0;           //!< before the next one
    std::optional<std::size_t> model_of = {}; //!< the stage whose coefficients hold; none: those of the start
    std::optional<double> origin;             //!< of the series' time [s]; none before the first sample
    std::vector<EnteredGroup> groups = {};
    std::map<std::string, double> notes = {}; //!< what stages wrote down for later ones
    RandomStream random{0};                   //!< of what is drawn while the run goes on

    Series series = {};
    struct Rows
    {
        std::size_t first = 0, end = 0;
    };
    std::vector<Rows> rows = {}; //!< of the series, of each stage
    std::vector<Profile> profiles = {};
    //! Of a profile that is averaged over the samples of a stage.
    struct Average
    {
        std::vector<double> axis = {}, sum = {}, count = {};
    };
    std::vector<Average> averages = {}; //!< of each profile reading
    std::vector<Snapshot> snapshots = {};
    std::vector<double> responses = {}; //!< NaN where not reached

    //! The rows of a column that are of one stage.
    std::vector<double> column_in(std::size_t number, std::string const& name) const;
    //! The profile of that name; it must be there.
    Profile const& profile(std::string const& name) const;
};

//! A run that goes on.
struct Bench
{
    dem::Simulation simulation;
    Progress progress = {};

    double time_in_stage() const { return simulation.time() - progress.begins[progress.stage]; } //!< [s]
};

//! The bench at one moment, as conditions and readings see it: the particles are read once for all of them,
//! and what several need is made once.
class Look
{
  public:
    explicit Look(Bench& bench) : bench_(bench) {}

    dem::Simulation& simulation() { return bench_.simulation; }
    Progress& progress() { return bench_.progress; }
    Bench& bench() { return bench_; }
    double time() const { return bench_.simulation.time(); }

    //! The particles, read when somebody needs them: spheres, and those that other grains are made of. For
    //! outlines.
    dem::StateView const& particles();
    //! Whole grains; for masses and motions.
    dem::StateView const& grains();
    //! The kept result of `make(*this)`, made when it is first asked for; one of each type.
    template <class Made, class Make>
    Made const& once(Make const& make)
    {
        std::any& kept = made_[std::type_index(typeid(Made))];
        if (!kept.has_value())
            kept = Made(make(*this));
        return *std::any_cast<Made>(&kept);
    }

  private:
    Bench& bench_;
    std::optional<dem::StateView> particles_, grains_;
    std::map<std::type_index, std::any> made_;
};

} // namespace demens::rig
