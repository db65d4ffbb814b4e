#pragma once

#include "demens/rig/programme/programme.hpp"
#include "src/rig/custom/selection.hpp"

namespace demens::rig::custom {

//! `[[experiment.stage]]`
TableSpec stage_table();

//! What the end of a stage may wait for.
struct ConditionKind
{
    TableKind keys;
    std::string below = {}, above = {}; //!< its keys that hold limits; empty: it has no such limit
    double (*read)(Look&, Selection const&) = nullptr; //!< what is compared with them; null: nothing
};

//! When a stage ends, beside its time.
struct Condition
{
    ConditionKind const* kind;
    Selection selection;
    double below, above; //!< limits; NaN: none

    bool holds(Look& look) const;
};

struct StagePlan
{
    std::string name;
    double duration, shortest; //!< [s]
    Overrun overrun;
    Condition condition;
    std::vector<std::string> walls_on, walls_off;
};

//! \throws InputError
std::vector<StagePlan> read_stages(OptionValues const& experiment, Regions const& regions);
//! The stage of a programme that it is, without its beginning.
Stage make_stage(StagePlan const& plan);

} // namespace demens::rig::custom
