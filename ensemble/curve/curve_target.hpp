#pragma once

#include "demens/rig/rig.hpp"
#include "ensemble/curve/measured_curve.hpp"

#include <string>
#include <vector>

namespace demens::ensemble {

//! Whether the zero of a measured axis is known.
enum class CurveShift
{
    fixed,
    free //!< the simulated curve is moved along the axis to where it fits best, run by run
};

//! A part of a measured curve, whose mean is a target: the mean of the simulated curve there should be the
//! same.
struct CurveWindow
{
    std::string name;
    double from, to;                //!< on the measured axis
    double weight = 1;              //!< in the objective, beside the other windows of the curve
    double measured = 0;            //!< mean of the measured curve in it
    double effective = 0;           //!< number of points in it that scatter by themselves
    std::size_t first = 0, end = 0; //!< the points of the curve that lie in it
};

//! A measured curve, to be met by a curve that a rig records: a reading of its series, over the time since
//! the first one, or a profile. Everything in the units of the simulated curve.
struct CurveTarget
{
    std::string name; //!< of the reading or profile
    bool is_profile = false;
    MeasuredCurve curve = {};
    double sd = 0;        //!< of a point
    double effective = 0; //!< number of all points that scatter by themselves
    CurveShift shift = CurveShift::fixed;
    double offset = 0;        //!< of the simulated curve along the axis, before a free shift
    double largest_shift = 0; //!< of a free shift, either way
    std::vector<CurveWindow> windows = {};
    OptionValues given = {}; //!< its keys, as its author wrote them; tables `window`
};

//! What the curve adds to the responses of its experiment, in order.
std::vector<rig::ResponseInfo> responses_of(CurveTarget const& target, std::string const& axis_units,
                                            std::string const& units);
//! The window whose mean a response is; none: it is of another curve, or something else.
CurveWindow const* window_of(CurveTarget const& target, std::string const& response);
//! The responses of a run: means over the windows, by straight lines between its points. Before its first and
//! after its last point a series stays as it is there; a profile has no value there. NaN where a window
//! cannot be filled.
std::vector<double> responses_of(CurveTarget const& target, rig::RunResult const& result);

//! Where the simulated curve is to be read for a place on the measured axis: what is to be added.
double shift_of(CurveTarget const& target, MeasuredCurve const& simulated);
//! The simulated curve that the target is about; empty when the run has none.
MeasuredCurve simulated_curve(CurveTarget const& target, rig::Series const& series,
                              std::vector<rig::Profile> const& profiles);

} // namespace demens::ensemble
