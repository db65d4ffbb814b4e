#pragma once

#include "demens/dem/hull_place.hpp"
#include "demens/dem/particles.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace demens::observe {

//! A rounded hull as it is seen: its true outline.
class HullOutline
{
  public:
    explicit HullOutline(dem::HullPlace const& hull);
    //! The same seen from other axes. \param axes images of x, y and z
    HullOutline(dem::HullPlace const& hull, demens::Rotation const& axes);

    //! Its centre, and the radius of the ball around it that holds it.
    dem::Place const& place() const { return place_; }
    //! Height of its highest point over a place [m]; none beside it.
    std::optional<double> top(double x, double y) const;

    // Its silhouette as seen from the front, along y [m]:
    std::pair<double, double> across() const;                        //!< from the left to the right
    std::pair<double, double> upwards() const;                       //!< from the bottom to the top
    std::optional<double> top(double x) const;                       //!< of its upper edge
    std::optional<std::pair<double, double>> across(double z) const; //!< at a height

  private:
    //! Where a line meets the silhouette. \param at along u, a coordinate of a point of it \return of v
    template <double Vector3::*u, double Vector3::*v>
    std::optional<std::pair<double, double>> chord(double at) const;

    dem::Place place_;
    double rounding_;
    std::vector<Vector3> vertices_;                 //!< of the core [m]
    grain::Hull const* core_;                       //!< whose faces and edges name them
    std::shared_ptr<grain::BodyShape const> shape_; //!< keeps it alive
    std::vector<Vector3> normals_;                  //!< of faces
    std::vector<Vector3> silhouette_; //!< vertices around the core as seen along y, counter-clockwise
};

} // namespace demens::observe
