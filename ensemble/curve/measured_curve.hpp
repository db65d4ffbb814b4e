#pragma once

#include <string>
#include <vector>

namespace demens::ensemble {

//! Values over an ascending axis, e.g. a mass over time; both of one length.
struct MeasuredCurve
{
    std::vector<double> axis, values;

    std::size_t size() const { return axis.size(); }
    //! Share of each point in the length of the axis that the points cover: half of the way to its
    //! neighbours; they sum to 1.
    std::vector<double> shares() const;
    //! Value at a place of the axis, on straight lines between the points; NaN outside.
    double at(double place) const;
};

//! Which columns of a CSV file a curve is made of, and in which units it is wanted.
struct CurveColumns
{
    std::string axis, value;
    std::string axis_units, value_units; //!< of what is simulated
};

//! \param origin the file in messages \throws InputError with file and line, for a gap, an axis that does not
//! ascend, or a unit that cannot fit
MeasuredCurve read_curve(std::string const& csv, std::string const& origin, CurveColumns const& columns);

//! What scatters in a curve, seen beside smooth pieces of it (a parabola through every 12 points or more,
//! eight at the most): points next to each other scatter alike, so that they count for fewer.
struct CurveScatter
{
    double sd;        //!< of a point, in the unit of the values; NaN: too few points to tell
    double effective; //!< number of points that scatter by themselves, n (1 - r)/(1 + r) with r between
                      //!< neighbours
};
CurveScatter scatter_of(MeasuredCurve const& curve);

} // namespace demens::ensemble
