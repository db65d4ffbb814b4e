#pragma once

#include "demens/rig/rig.hpp"
#include "ensemble/curve/curve_target.hpp"
#include "ensemble/effect.hpp"
#include "ensemble/input/file_source.hpp"
#include "ensemble/input/kinds.hpp"
#include "ensemble/picture/picture_target.hpp"

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace demens::ensemble {

//! What a target was made of.
enum class TargetSource
{
    value,  //!< `target.RESPONSE`
    curve,  //!< a window of `target.CURVE`
    picture //!< a segment of `target.picture`
};

//! A measured value to be met by one response of one experiment.
struct Target
{
    std::string response; //!< name of a response of the experiment's rig
    int response_index;   //!< its place in Experiment::responses
    double value;     //!< in the unit the name carries; NaN: not measured, of an experiment to be considered
    double scale;     //!< the deviation that counts as one, same unit, > 0
    double sd;        //!< standard deviation of the measurement; NaN: not given
    double tolerance; //!< deviation that is good enough; NaN: not given
    TransformKind transform = TransformKind::none;
    double lower = std::numeric_limits<double>::quiet_NaN(); //!< range of the response, for logit
    double upper = std::numeric_limits<double>::quiet_NaN();
    TargetSource comes_of = TargetSource::value;
};

//! What an experiment is for.
enum class ExperimentRole
{
    calibrate, //!< the factors are fitted to its targets
    hold_out,  //!< it takes no part in that; a diagnosis is tested on it
    consider   //!< not made yet: would it tell effects apart?
};

//! One rig under one set of conditions, with what was measured there.
struct Experiment
{
    std::string name;
    rig::RigInfo const* rig;
    int replicates = 1;                       //!< runs per design point, each with its own packing seed
    std::vector<rig::ResponseInfo> responses; //!< what its rig measures, then what curves and a picture add
    std::vector<Target> targets;
    std::vector<CurveTarget> curves = {};      //!< measured; each of their windows is a target
    std::optional<PictureTarget> picture = {}; //!< photographed; each of its segments is a target
    ExperimentRole role = ExperimentRole::calibrate;
    std::vector<Target> held_out = {}; //!< instead of `targets` where the role is another
};

//! A key of an experiment that names a material.
struct NamedMaterial
{
    int experiment;
    std::string key; //!< path in the experiment, e.g. `wall_material` or `wall.floor.material`
    std::string material;
};

//! A value that a run of an experiment is made from.
struct ModelValue
{
    std::string path; //!< as a factor's, with the experiment's name
    std::string text; //!< as the resolved input has it, or that of a factor
    int factor;       //!< that takes its place; -1: none
};

//! A scalar of the resolved input that is to be found.
struct Factor
{
    std::string path; //!< e.g. `contact.quartz_quartz.static_friction` or `experiment.bench.mass_kg`
    std::string name; //!< short name for tables and plots; default the last part of the path
    double lower, upper;
    bool log_scale = false;
    std::vector<double> levels = {}; //!< the only values it may take, ascending; empty: continuous
    //! value when screening finds it inactive; NaN: the middle of its range
    double inactive_value = std::numeric_limits<double>::quiet_NaN();
};

//! sum_k coefficients[k] * factor[k] <= bound, in the factors' own units.
struct LinearConstraint
{
    std::string text; //!< as the author wrote it, e.g. `kinetic_friction <= static_friction`
    std::vector<double> coefficients;
    double bound;
};

//! First wave. Unused members keep their defaults.
struct DesignOptions
{
    DesignKind kind = DesignKind::latin_hypercube;
    int points = 0;             //!< 0: a default that suits the factors
    int centre_repetitions = 0; //!< central composite and Box-Behnken take at least one
    double axial_distance = 0;  //!< central composite; 0: rotatable, 1: on the faces
    int levels = 2;             //!< full factorial; D-optimal: of a factor's candidates, at least 3
    PolynomialModel model = PolynomialModel::quadratic; //!< D-optimal
    std::vector<std::string>
        generators; //!< fractional factorial and its composite, e.g. "E=ABC"; empty: chosen
    std::vector<std::vector<double>>
        table;              //!< rows of factor values: `kind = "table"`, or kept by a D-optimal design
    std::string table_file; //!< CSV file that they come from; empty: inline
};

//! A wave before the design that finds out which factors act.
struct ScreeningOptions
{
    int points = 0;                      //!< of a two-level fraction over all factors; 0: no screening
    int centre_repetitions = 1;          //!< points at the centre
    double significance = 0.05;          //!< a factor with a p value up to this in some target is active
    std::vector<std::string> generators; //!< e.g. "E=ABC"; empty: chosen
};

//! A further residual: a sum of simulated responses less the value of a target.
struct TargetCombination
{
    std::string text;                 //!< as written, e.g. `break - rest = avalanche`
    std::vector<double> coefficients; //!< of all targets, in the order of the campaign
    int target;                       //!< whose value the sum should have
};

struct ObjectiveOptions
{
    ObjectiveKind kind = ObjectiveKind::wmse;
    std::vector<TargetCombination> combinations;
};

struct SurrogateOptions
{
    SurrogateChoice kind = SurrogateChoice::automatic;
};

struct SearchOptions
{
    SearchKind kind = SearchKind::surrogate_minima;
    int batch = 0; //!< new design points per wave; 0: max(4, 2 x factors), whatever the number of groups
    //! Waves have half as many points, and the next one is planned before the last one is complete.
    bool overlap = false;
};

struct SolverOptions
{
    SolverKind kind = SolverKind::pounders;
    int starts = 20; //!< starts of the search on the surrogate
};

struct StopOptions
{
    double wmse = 0; //!< stop when the best point's weighted mean square error is at most this; 0: never
    bool within_tolerance = true; //!< stop when every target with a tolerance is met
    int waves = 50;               //!< most waves after the design
    int runs = 200;               //!< most runs in all
    double wall_time_s = 0;       //!< 0: no limit
    int no_improvement_waves = 4; //!< stop after so many waves without a better point
    int confirmation = 1; //!< times the best point is repeated, with new packings, before the campaign ends
};

struct RunOptions
{
    static double constexpr limit_by_prediction = -1;

    int ranks_per_group = 1;                      //!< in a file 0: chosen by the number of particles
    double run_wall_time_s = limit_by_prediction; //!< a run slower than this is `timed_out`; 0: no limit
    rig::EngineChoice engine = rig::EngineChoice::cpu;
    int runs_together = 0; //!< on a device at once; 0: as many as its memory holds
    std::string bank = {}; //!< campaign file whose runs are taken over where they hold; empty: none
};

//! `[gap]`: what is diagnosed once the campaign is calibrated.
struct GapOptions
{
    std::vector<std::string> held_out;     //!< names of experiments
    std::vector<std::string> candidates;   //!< names of experiments that might be made next
    std::vector<std::string> effects;      //!< of the catalogue or of the campaign; empty: all that it allows
    std::map<std::string, double> typical; //!< amplitudes of effects of the catalogue in place of its own
    bool diagnose = true;       //!< false: what is held out is compared with, and no effect is looked for
    double form_floor = 0.04;   //!< share of a response that the right model would miss, its laws being forms
    double form_error = 0.2;    //!< share of an effect's signature that another form of its law would change
    int packings = 6;           //!< runs of the base model and of a full signature, each with its own packing
    int screening_packings = 2; //!< runs of each effect in the first look
    int effects_in_full = 3;    //!< effects whose signatures are simulated in full, the most probable ones
    int runs = 2000;            //!< most runs of the diagnosis
    double named_from = 0.8;    //!< probability from which on an effect is named
    double temperature = 1;     //!< ln of evidence is divided by it
};

//! What `rig = "..."` in a campaign may name.
using Rigs = std::vector<rig::RigInfo>;

namespace input {
//! What is done where `[solver]` is written as it was before `[search]` existed.
enum class OldWords
{
    refused,   //!< in what an author writes: the message says what to write now
    understood //!< in what a campaign file holds, so that it can be gone on with
};
} // namespace input

//! A campaign as its author wrote it, checked and complete with defaults.
class CampaignInput
{
  public:
    //! Reads and checks a TOML file. \throws InputError with file, line, key, value and what would be right.
    //! \param rigs what `rig = "..."` may name; must outlive the campaign
    static CampaignInput from_file(std::filesystem::path const& file, Rigs const& rigs = rig::all_rigs());
    //! The same from text; `origin` stands for the file in messages, `files` has those that the text names.
    static CampaignInput from_text(std::string const& toml, std::string const& origin,
                                   Rigs const& rigs = rig::all_rigs(),
                                   input::FileSource const& files = input::no_files,
                                   input::OldWords old_words = input::OldWords::refused);

    std::string name;
    std::uint64_t seed = 1;
    std::vector<Experiment> experiments;
    std::vector<Factor> factors;
    std::vector<LinearConstraint> constraints;
    ScreeningOptions screening;
    DesignOptions design;
    ObjectiveOptions objective;
    SurrogateOptions surrogate;
    SearchOptions search;
    SolverOptions solver;
    StopOptions stop;
    RunOptions run;
    std::optional<GapOptions> gap; //!< where it is asked for
    std::vector<Effect> effects;   //!< the campaign's own, beside the catalogue's

    //! Puts a number in the place of the one that the input has there; its text stays as it was written.
    //! \param path as a factor's \throws InputError where it names no number, or one that may not have this
    //! value
    void set(std::string const& path, double value);

    //! The author's text, byte for byte.
    std::string const& text() const { return text_; }
    //! The same as TOML with every default written out; reading it gives this campaign again.
    std::string const& resolved_text() const { return resolved_text_; }
    //! The same with factor values in the place of those that were given.
    std::string resolved_text_at(std::vector<double> const& factor_values) const;
    //! What is doubtful about it, though it can run: for whoever makes a campaign of it.
    std::vector<std::string> warnings() const;
    //! What was made of it that its author may want to know.
    std::vector<std::string> const& notes() const { return notes_; }
    //! Contents of the files that it names.
    rig::Files const& files() const;

    //! Input of one run: factor values set at their paths, the seed derived from (campaign seed, point,
    //! experiment, replicate). \throws InputError when the values make an input that a rig refuses.
    //! \param overrides what effects change, once the factors are set
    rig::RunInput run_input(std::vector<double> const& factor_values, int point, int experiment,
                            int replicate, std::vector<Override> const& overrides = {}) const;
    //! The base value at a path, of the first place that it names; none where it names nothing.
    std::optional<OptionValue> base_value(std::string const& path) const;
    //! All values that a run of an experiment is made from, with what effects change at the base values.
    std::vector<ModelValue> model_values(int experiment, std::vector<Override> const& overrides = {}) const;
    //! Where experiments name a material.
    std::vector<NamedMaterial> named_materials() const;
    //! Names of the pairs of materials that have a table `[contact.A_B]`.
    std::vector<std::pair<std::string, std::string>> pairs() const;
    //! Reads `[[effect]]` of this campaign. \param origin the text's place in messages \throws InputError
    std::vector<Effect> effects_of(std::string const& text, std::string const& origin) const;
    //! The seed of a run; the same replicate of every design point has its own packing.
    std::uint64_t run_seed(int point, int experiment, int replicate) const;

  private:
    std::string text_, resolved_text_;
    std::vector<std::string> warnings_, notes_; //!< of the reading
    struct Tree;                                //!< the resolved input, private to the reader
    std::shared_ptr<Tree const> tree_;
};

} // namespace demens::ensemble
