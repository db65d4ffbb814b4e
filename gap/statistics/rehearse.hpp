#pragma once

#include "gap/statistics/attribute.hpp"

//! What these experiments can tell, before any are made: twins of every effect, diagnosed.
namespace demens::gap {

struct RehearseOptions
{
    int twins = 500; //!< of each class and strength
    std::vector<double> strengths = {
        1}; //!< amplitudes over `typical`; both signs in turn where either is possible
    std::vector<double> outside = {
        0.01, 0.03, 0.1}; //!< strengths of what no effect describes, over the scale of responses
    std::uint64_t seed = 1999;
};

//! Diagnoses of twins of one kind.
struct RehearsedRow
{
    int effect;              //!< -1: none, -2: something outside the list
    double strength;         //!< over `typical`, or over the scale of responses; NaN for none
    Eigen::VectorXd answers; //!< shares: none, the effects, unknown, by the largest probability and the gate
    double in_group;         //!< share in which the effect, or one that cannot be told from it, comes first
    double named;         //!< share in which anything was named at the options' probability, groups as well
    double wrongly_named; //!< share in which an effect, or a group, was named that is not the cause
    double flagged;       //!< share whose misfit the gate refuses, or where unknown is most probable
    double beyond_floor;  //!< share of which the global test says that there is something
};

struct Rehearsal
{
    std::vector<RehearsedRow> rows; //!< none, the effects at each strength, outside
    Distances distances;            //!< at the typical amplitudes
    std::vector<std::vector<int>> groups;
};

//! Twin i of a row depends on seed, row and i alone.
Rehearsal rehearse(Evidence const& evidence, Projection const& projection, Hypotheses const& hypotheses,
                   Attributor const& attributor, RehearseOptions const& options = {});

//! Class of an attribution: 0 none, 1 + k effect k, 1 + effects unknown. Effects count with their pairs.
int answer(Attribution const& attribution);

} // namespace demens::gap
