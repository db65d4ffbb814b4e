#pragma once

#include "ensemble/campaign.hpp"
#include "ensemble/fit_quality.hpp"
#include "ensemble/verdict.hpp"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace demens::ensemble {

//! What becomes of a campaign now.
enum class CampaignState
{
    running,     //!< a session or tasks of a job array work on it
    waiting,     //!< it is to be gone on with
    to_diagnose, //!< calibrated; the diagnosis of its gap is to be gone on with
    ended
};

struct RunCounts
{
    int planned = 0, done = 0, failed = 0, running = 0, dropped = 0; //!< failed and dropped ones are done
};

//! Starts of runs after which nothing came, and which are made again. None of them is a result, so that no
//! fit and no search knows of them; a run that its point kills again and again becomes `quarantined`.
struct StartsWithoutEnd
{
    int lost = 0;    //!< without a word: the machine, its memory or a kill
    int crashed = 0; //!< with a deadly signal of the program itself
    int stopped = 0; //!< given up when the session was asked to stop

    bool any() const { return lost + crashed + stopped > 0; }
};

//! A wave as far as it is.
struct WaveStatus
{
    int number = 0;
    WavePurpose purpose = WavePurpose::design;
    RunCounts runs;
    bool is_complete = false;
    double wall_time = 0; //!< [s]; of a complete wave
    double busy_share =
        0; //!< of its groups' time, from the end of the wave before, spent in runs; NaN while it goes on
    StartsWithoutEnd begun_again; //!< of its runs; zeros once it is complete
};

//! Runs that did not finish, by how they ended.
struct FailureStatus
{
    rig::RunStatus status = rig::RunStatus::error;
    int runs = 0;
    int first_run = 0;  //!< an example
    std::string reason; //!< of that one; empty: it cannot be read now
};

//! A run in progress.
struct RunInProgress
{
    int run = 0;
    std::string experiment;
    double elapsed = 0; //!< [s]
    //! [s] as a whole, by what it has told, else by runs that have finished; none: not known yet.
    std::optional<double> expected;
    double share = 0;   //!< of what it simulates that was done when it last told; 0: it has not
    std::string moment; //!< where it was then, e.g. `in stage "flow" at 0.85 s`
};

//! How long the wave in progress still takes.
struct TimeLeft
{
    double seconds = 0, standard_error = 0;
    int at_a_time = 1; //!< runs
};

//! The best run, and what the targets tell of each factor.
struct BestFit
{
    struct Known
    {
        double estimate = 0, lower = 0, upper = 0; //!< 95 %
        Verdict verdict = Verdict::not_determined;
    };
    struct Factor
    {
        std::string name;
        double value = 0; //!< of the best run
        std::optional<Known> known;
    };
    struct Response
    {
        std::string name; //!< EXPERIMENT.RESPONSE
        double value = 0, target = 0, scale = 0;
    };
    double wmse = 0;
    int run = -1;                      //!< -1: not known
    std::optional<FitQuality> quality; //!< of the best run
    std::string targets;               //!< whether they can be met together; empty: not known
    double noise_inflation = 1;        //!< with which intervals were made
    std::vector<Factor> factors;
    std::vector<Response> responses;
};

//! Where a campaign stands. Shown as text and as JSON.
struct CampaignStatus
{
    std::string name, file;
    CampaignState state = CampaignState::waiting;
    std::string owner;                 //!< who works on it, e.g. "process 123 on host4"
    std::string ended;                 //!< why its calibration ended
    std::vector<Extension> extensions; //!< changes of its input since it began
    std::vector<WaveStatus> waves;
    RunCounts all;
    double busy_share =
        std::numeric_limits<double>::quiet_NaN(); //!< of all complete waves; NaN: none was run here
    std::vector<FailureStatus> failures;          //!< most frequent first
    std::vector<RunInProgress> in_progress;       //!< longest first
    std::optional<TimeLeft> time_left;            //!< none: nothing is to be run, or no run has finished
    std::optional<BestFit> best;
};

//! Reads only, and is safe while a session works on the file. \throws InputError
CampaignStatus read_status(std::filesystem::path const& file, Rigs const& rigs = rig::all_rigs());
//! What the waves of a campaign say of its best run.
std::optional<BestFit> best_fit(Campaign const& campaign);

} // namespace demens::ensemble

namespace demens {

template <>
std::vector<Word<ensemble::CampaignState>> const& words_of();

} // namespace demens
