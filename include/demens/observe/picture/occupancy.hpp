#pragma once

#include "demens/observe/end_view.hpp"

namespace demens::observe {

//! A simulation's picture of a drum: the share of the frames in which grains cover a pixel. It is what a
//! photograph of long exposure would be, on its raster.
class Occupancy
{
  public:
    explicit Occupancy(PictureFrame const& frame) : view_(frame), sum_(frame.columns, frame.rows) {}

    //! Adds a frame: the true outlines of all particles along the drum's axis, y.
    void add(std::span<dem::Place const> places);
    int frames() const { return frames_; }
    //! Share of the frames [rows x columns], of one at least.
    GreyImage mean() const;

  private:
    EndView view_;
    GreyImage sum_;
    int frames_ = 0;
};

} // namespace demens::observe
