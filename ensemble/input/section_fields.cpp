#include "ensemble/input/section.hpp"

namespace demens::ensemble::input {

template <>
std::vector<Field<DesignOptions>> const& fields_of()
{
    static std::vector<Field<DesignOptions>> const fields = {
        field(&DesignOptions::kind, {.key = "kind", .doc = "how the points of the first wave are chosen"}),
        field(
            &DesignOptions::points,
            {.key = "points", .doc = "number of design points; 0: as many as suit the factors", .lower = 0}),
        field(&DesignOptions::centre_repetitions,
              {.key = "centre_repetitions", .doc = "points at the centre of the factors", .lower = 0}),
        field(&DesignOptions::axial_distance,
              {.key = "axial_distance",
               .doc = "distance of the axial points in half ranges; 0: rotatable, 1: on the faces",
               .lower = 0}),
        field(&DesignOptions::levels,
              {.key = "levels", .doc = "levels of each factor, or of its candidates", .lower = 2}),
        field(&DesignOptions::model,
              {.key = "model", .doc = "polynomial whose coefficients are to be found"}),
        field(&DesignOptions::table_file,
              {.key = "table_file",
               .doc = "CSV file with a column for each factor and a row for each design point",
               .names_file = true}),
    };
    return fields;
}

template <>
std::vector<Field<ScreeningOptions>> const& fields_of()
{
    static std::vector<Field<ScreeningOptions>> const fields = {
        field(&ScreeningOptions::points,
              {.key = "points",
               .doc = "points of a two-level fraction over all factors, a power of 2; 0: no screening",
               .lower = 0}),
        field(&ScreeningOptions::centre_repetitions,
              {.key = "centre_repetitions", .doc = "further points at the centre", .lower = 0}),
        field(&ScreeningOptions::significance,
              {.key = "significance",
               .doc = "a factor whose p value is at most this for some target is active",
               .lower = 1e-6,
               .upper = 0.5}),
    };
    return fields;
}

template <>
std::vector<Field<ObjectiveOptions>> const& fields_of()
{
    static std::vector<Field<ObjectiveOptions>> const fields = {
        field(&ObjectiveOptions::kind, {.key = "kind", .doc = "what is minimised"}),
    };
    return fields;
}

template <>
std::vector<Field<SurrogateOptions>> const& fields_of()
{
    static std::vector<Field<SurrogateOptions>> const fields = {
        field(&SurrogateOptions::kind, {.key = "kind", .doc = "model of each response between the runs"}),
    };
    return fields;
}

template <>
std::vector<Field<SearchOptions>> const& fields_of()
{
    static std::vector<Field<SearchOptions>> const fields = {
        field(&SearchOptions::kind, {.key = "kind", .doc = "how the points of a wave are chosen"}),
        field(&SearchOptions::batch,
              {.key = "batch",
               .doc = "new design points per wave; 0: twice the number of factors, at least 4",
               .lower = 0}),
        field(&SearchOptions::overlap, {.key = "overlap",
                                        .doc = "waves of half as many points, the next one planned while the "
                                               "last one is being run, so that no "
                                               "group waits"}),
    };
    return fields;
}

template <>
std::vector<Field<SolverOptions>> const& fields_of()
{
    static std::vector<Field<SolverOptions>> const fields = {
        field(&SolverOptions::kind, {.key = "kind", .doc = "what finds the minimum of the surrogates"}),
        field(&SolverOptions::starts,
              {.key = "starts", .doc = "starts of the search on the surrogates", .lower = 1}),
    };
    return fields;
}

template <>
std::vector<Field<StopOptions>> const& fields_of()
{
    static std::vector<Field<StopOptions>> const fields = {
        field(&StopOptions::wmse,
              {.key = "wmse",
               .doc = "stop when the best point's weighted mean square error is at most this; 0: never",
               .lower = 0}),
        field(&StopOptions::within_tolerance,
              {.key = "within_tolerance", .doc = "stop when every target that has a tolerance is met"}),
        field(&StopOptions::waves, {.key = "waves", .doc = "most waves after the design", .lower = 0}),
        field(&StopOptions::runs, {.key = "runs", .doc = "most runs in all", .lower = 1}),
        field(
            &StopOptions::wall_time_s,
            {.key = "wall_time_s", .doc = "longest wall time of the campaign [s]; 0: no limit", .lower = 0}),
        field(&StopOptions::no_improvement_waves,
              {.key = "no_improvement_waves",
               .doc = "stop after so many waves without a better point; 0: never",
               .lower = 0}),
        field(&StopOptions::confirmation,
              {.key = "confirmation",
               .doc = "times the best point is repeated, with new packings, before the campaign ends",
               .lower = 0}),
    };
    return fields;
}

template <>
std::vector<Field<RunOptions>> const& fields_of()
{
    static std::vector<Field<RunOptions>> const fields = {
        field(&RunOptions::ranks_per_group,
              {.key = "ranks_per_group",
               .doc = "MPI ranks that share one run; pays from some 10,000 particles a rank; 0: so many that "
                      "each has 10,000 of the largest run at least",
               .lower = 0}),
        field(&RunOptions::run_wall_time_s,
              {.key = "run_wall_time_s",
               .doc = "a slower run counts as timed out [s]; 0: no limit; -1: 30 times what is "
                      "expected of it, an hour at least, once a run has finished",
               .lower = -1}),
        field(&RunOptions::engine,
              {.key = "engine",
               .doc = "what computes a run: this machine's processors, a CUDA device, or a device where "
                      "there is one that can do it; each gives other packings"}),
        field(&RunOptions::runs_together,
              {.key = "runs_together",
               .doc = "runs that a group does at once on its device; 0: as many as its memory holds",
               .lower = 0,
               .upper = 65536}),
        field(&RunOptions::bank,
              {.key = "bank",
               .doc =
                   "campaign file of the same rigs and base model, relative to the TOML file, whose runs are "
                   "taken over; none: all runs are its own"}),
    };
    return fields;
}

template <>
std::vector<Field<GapOptions>> const& fields_of()
{
    static std::vector<Field<GapOptions>> const fields = {
        field(
            &GapOptions::diagnose,
            {.key = "diagnose",
             .doc = "false: held-out experiments are simulated at the estimate and compared, nothing else"}),
        field(
            &GapOptions::form_floor,
            {.key = "form_floor",
             .doc = "share of a response that even the right model would miss, since its laws are forms [-]",
             .lower = 0,
             .upper = 1}),
        field(&GapOptions::form_error,
              {.key = "form_error",
               .doc = "share of an effect's signature that another form of its law would change [-]",
               .lower = 0,
               .upper = 2}),
        field(&GapOptions::packings,
              {.key = "packings",
               .doc = "runs of the base model, of an effect in full, and on held-out experiments",
               .lower = 2,
               .upper = 1000}),
        field(&GapOptions::screening_packings, {.key = "screening_packings",
                                                .doc = "runs of each effect in the first look",
                                                .lower = 1,
                                                .upper = 1000}),
        field(&GapOptions::effects_in_full,
              {.key = "effects_in_full",
               .doc = "effects, the most probable ones, that are simulated in full and on what is held out",
               .lower = 1,
               .upper = 100}),
        field(&GapOptions::runs, {.key = "runs", .doc = "most runs of the diagnosis", .lower = 1}),
        field(&GapOptions::named_from, {.key = "named_from",
                                        .doc = "probability from which on an effect is named [-]",
                                        .lower = 0.5,
                                        .upper = 1}),
        field(&GapOptions::temperature,
              {.key = "temperature",
               .doc =
                   "by which ln of the evidence of each explanation is divided: above 1 where probabilities "
                   "were too sure in a rehearsal [-]",
               .lower = 0.2,
               .upper = 20}),
    };
    return fields;
}

} // namespace demens::ensemble::input
