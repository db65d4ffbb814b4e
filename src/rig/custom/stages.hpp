#pragma once

#include "demens/rig/rig.hpp"
#include "src/rig/custom/world.hpp"

namespace demens::rig::custom {

//! `[[experiment.stage]]`
TableSpec stage_table();

//! When a stage ends, beside its time.
struct Condition
{
    std::string kind; //!< `time`: none
    Selection selection;
    double below, above; //!< limits; NaN: none
    bool holds(World const& world) const;
};

struct Stage
{
    std::string name;
    double duration, shortest; //!< [s]
    bool may_run_out;          //!< whether the run goes on when the condition does not hold in time
    Condition condition;
    std::vector<std::string> walls_on, walls_off;
};

//! \throws InputError
std::vector<Stage> read_stages(OptionValues const& experiment, Regions const& regions);

} // namespace demens::rig::custom
