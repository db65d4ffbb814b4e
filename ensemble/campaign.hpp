#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "ensemble/stored_arrays.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace demens::ensemble {

//! One run (design point x experiment x replicate) and what came of it.
struct RunRecord
{
    int run = 0; //!< number in the campaign, from 0, in the order in which runs were planned
    int wave = 0;
    int point = 0; //!< number of the design point in the campaign
    int experiment = 0;
    int replicate = 0;
    std::uint64_t seed = 0;
    std::vector<double> factors; //!< own units, in the order of CampaignInput::factors
    std::shared_ptr<std::vector<Effect> const> effects = {}; //!< of its wave; null where it has none
    std::vector<double> amplitudes = {};                     //!< of each of them
    double predicted_cost = 0;                               //!< [steps of a sphere]

    rig::RunStatus status = rig::RunStatus::not_run;
    std::string reason;
    std::vector<double> responses; //!< of the experiment's rig; NaN where not reached
    double wall_time = 0;          //!< [s]
    double start_time = 0;         //!< [s] since the wave began
    int group = -1;                //!< which group ran it
    double simulated_time = 0;     //!< [s]
    std::int64_t steps = 0;
    std::int64_t particles = 0;
    std::optional<dem::EnergyLedger> energy = {}; //!< at the end, of a run with the ledger

    //! What is changed in it beside the factors.
    std::vector<Override> overrides() const
    {
        return effects ? overrides_of(*effects, amplitudes) : std::vector<Override>{};
    }
};

//! Snapshots (e.g. "settled", "final"; without velocities), series and profiles of one run.
struct RunDetails
{
    std::vector<rig::Snapshot> snapshots;
    rig::Series series;
    std::vector<rig::Profile> profiles = {};
};

//! An array that the calibration stores with a wave; `stored` lists them.
struct NamedArray
{
    std::string path; //!< below /waves/NNNN/
    std::vector<std::size_t> shape;
    std::vector<double> data; //!< row-major
    std::string units;        //!< "1" when dimensionless, "mixed" with a column list in `doc`
    std::string doc;
};

//! What the runs of a wave are for.
enum class WavePurpose
{
    screening,    //!< which factors act
    design,       //!< the first look at all of the range
    search,       //!< the way to the optimum
    confirmation, //!< the best location again, with fresh packings
    signatures,   //!< what effects that the model may lack would change
    closure       //!< what the candidates predict where nothing was fitted
};

//! Whether the factors are fitted to the runs of such a wave.
constexpr bool calibrates(WavePurpose purpose)
{
    return purpose != WavePurpose::signatures && purpose != WavePurpose::closure;
}

//! Runs that were planned together, and what the calibration made of all runs up to them.
struct Wave
{
    int number = 0;
    WavePurpose purpose = WavePurpose::design;
    std::vector<RunRecord> runs;
    int replicates = 0; //!< of each of its experiments; 0: as the campaign says
    std::vector<NamedArray> analysis;
    double wall_time = 0;   //!< [s]
    double time_before = 0; //!< [s] in which no group worked, since the wave before it in the same session
    int groups = 0;
    bool planned_ahead = false;  //!< before all runs of the wave before it were over
    std::string taken_from = {}; //!< campaign file whose runs these were, with its check sum; empty: own ones

    //! The stored array of that name, or null.
    NamedArray const* find(stored::ArrayName const& name) const;
};

//! Whether the results of all runs are there.
bool is_complete(Wave const& wave);
//! [s] What the runs of a wave took, and what its groups had for it since the wave before; they are as busy
//! as the one is of the other.
double time_in_runs(Wave const& wave);
double time_of_groups(Wave const& wave);

//! A wave that is to be simulated.
struct WavePlan
{
    WavePurpose purpose = WavePurpose::design;
    std::vector<std::vector<double>> points;          //!< design points, own units
    std::vector<Effect> effects = {};                 //!< that act beside the factors
    std::vector<std::vector<double>> amplitudes = {}; //!< of them [points x effects]
    std::vector<int> experiments = {};                //!< in their order; empty: all that calibrate
    int replicates = 0;                               //!< of each experiment; 0: as the campaign says
};

//! A change of a campaign that had begun; see `ensemble/reuse/extension.hpp`.
struct Extension
{
    int first_wave = 0;                    //!< the first one that was planned with it
    int runs = 0;                          //!< to be made from then on, whatever its goals; 0: as [stop] says
    std::vector<std::string> changes = {}; //!< one line each
    std::string toml_before = {};          //!< the author's file until then
};

//! All of a campaign that later decisions rest on.
struct Campaign
{
    CampaignInput input;
    std::vector<Wave> waves;
    std::string ended; //!< why the campaign ended; empty while it goes on
    std::vector<Extension> extensions = {};

    //! The first wave of which runs are to be run, or null.
    Wave const* open_wave() const;
    int runs_planned() const;
    int points_planned() const;
    //! From which on waves are counted against [stop]: the first one, or that after the last extension.
    int first_counted_wave() const { return extensions.empty() ? 0 : extensions.back().first_wave; }
    //! How many runs [stop] still allows. Runs taken over from another campaign were paid there.
    int runs_left() const;
    //! All records of all waves in the order of their numbers.
    std::vector<RunRecord> all_runs() const;
};

} // namespace demens::ensemble

namespace demens {

template <>
std::vector<Word<ensemble::WavePurpose>> const& words_of();

} // namespace demens
