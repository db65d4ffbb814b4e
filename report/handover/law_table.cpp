#include "report/handover/counterpart.hpp"

#include <algorithm>
#include <iterator>

namespace demens::report {
namespace {

struct Cell
{
    Match match = Match::none;
    char const* name = "";
    char const* note = "";
};

//! A law and what stands for it in LIGGGHTS, LAMMPS, MFiX, EDEM and Rocky. HANDOVER.md tells the same.
struct Row
{
    char const *kind, *word;
    Cell there[5];
};

constexpr auto same = Match::same, nearest = Match::nearest, none = Match::none;
constexpr char const* shear = "stores the displacement, not the force";
constexpr char const* own_spin = "acts on the spin of each particle, not on the relative one";

constexpr Row table[] = {
    {"normal",
     "hertz",
     {{same, "model hertz"},
      {same, "hertz/material, damping tsuji"},
      {same, "DES_COLL_MODEL = 'HERTZIAN'"},
      {same, "Hertz-Mindlin (no slip)"},
      {nearest, "Hertzian spring dashpot", "check how it defines the damping"}}},
    {"normal",
     "hysteretic_spring",
     {{none, "", "hooke/hysteresis takes other stiffnesses"},
      {none},
      {none},
      {nearest, "Hysteretic Spring", "its loading stiffness follows from a yield strength"},
      {same, "Hysteretic linear spring"}}},
    {"tangential",
     "none",
     {{same, "no tangential"},
      {same, "mu 0"},
      {same, "MEW = 0"},
      {same, "friction 0"},
      {same, "friction 0"}}},
    {"tangential",
     "mindlin",
     {{same, "tangential history"},
      {same, "tangential mindlin"},
      {nearest, "DES_COLL_MODEL = 'HERTZIAN'", "its damping follows from DES_ET_INPUT"},
      {same, "Hertz-Mindlin (no slip)"},
      {nearest, "Mindlin-Deresiewicz", "softens as slip spreads"}}},
    {"tangential",
     "mindlin_rescale",
     {{nearest, "tangential history", shear},
      {same, "tangential mindlin_rescale/force"},
      {nearest, "DES_COLL_MODEL = 'HERTZIAN'",
       "stores the displacement; its damping follows from DES_ET_INPUT"},
      {nearest, "Hertz-Mindlin (no slip)", shear},
      {nearest, "Mindlin-Deresiewicz", "softens as slip spreads"}}},
    {"tangential", "mindlin_deresiewicz", {{none}, {none}, {none}, {none}, {same, "Mindlin-Deresiewicz"}}},
    {"tangential",
     "linear_coulomb",
     {{none, "", "tangential history takes the stiffness of Mindlin"},
      {nearest, "tangential linear_history", "a stiffness that is the same for all sizes and overlaps"},
      {none},
      {nearest, "Hysteretic Spring", "its own tangential part"},
      {same, "Linear spring Coulomb limit"}}},
    {"rolling",
     "none",
     {{same, "no rolling_friction"},
      {same, "no rolling"},
      {same, "MEW_R = 0"},
      {same, "rolling friction 0"},
      {same, "none"}}},
    {"rolling",
     "constant_torque",
     {{nearest, "rolling_friction cdt", "does not hold a body at rest"},
      {none},
      {nearest, "MEW_R", own_spin},
      {nearest, "Standard Rolling Friction (type A)", own_spin},
      {nearest, "Type 1: constant moment", own_spin}}},
    {"rolling", "viscous", {{none}, {none}, {none}, {none}, {none}}},
    {"rolling",
     "epsd",
     {{same, "rolling_friction epsd"},
      {none, "", "rolling sds takes one stiffness for all sizes and overlaps"},
      {none},
      {nearest, "Type C rolling friction", "from EDEM 2020"},
      {nearest, "Type 3: linear spring rolling limit", "its rolling stiffness is its own"}}},
    {"rolling",
     "epsd2",
     {{same, "rolling_friction epsd2"},
      {none, "", "rolling sds takes one stiffness for all sizes and overlaps"},
      {none},
      {none},
      {nearest, "Type 3: linear spring rolling limit", "its rolling stiffness is its own"}}},
    {"cohesion",
     "none",
     {{same, "no cohesion"},
      {same, "hertz"},
      {same, "USE_COHESION = .FALSE."},
      {same, "none"},
      {same, "none"}}},
    {"cohesion",
     "linear_cohesion",
     {{same, "cohesion sjkr"},
      {none},
      {none},
      {nearest, "Linear Cohesion", "check which area it takes"},
      {none}}},
    {"cohesion", "sjkr2", {{same, "cohesion sjkr2"}, {none}, {none}, {none}, {none}}},
    {"cohesion",
     "van_der_waals",
     {{none},
      {none},
      {nearest, "USE_COHESION, VAN_DER_WAALS", "no force beyond its outer cutoff"},
      {none},
      {none}}},
    {"cohesion", "dmt", {{none}, {same, "dmt"}, {none}, {none}, {none}}},
    {"cohesion",
     "jkr",
     {{none},
      {same, "jkr"},
      {none},
      {same, "Hertz-Mindlin with JKR"},
      {nearest, "JKR", "check which surface energy it asks for"}}},
    {"cohesion",
     "capillary",
     {{none, "", "its capillary models keep account of the liquid"}, {none}, {none}, {none}, {none}}},
};

} // namespace

Counterpart counterpart_of_law(Code code, std::string const& kind, std::string const& word)
{
    auto const row = std::find_if(std::begin(table), std::end(table),
                                  [&](Row const& r) { return r.kind == kind && r.word == word; });
    if (row == std::end(table))
        return {.note = "not known"};
    auto const& there = row->there[static_cast<std::size_t>(code)];
    return {.match = there.match, .name = there.name, .note = there.note};
}

} // namespace demens::report
