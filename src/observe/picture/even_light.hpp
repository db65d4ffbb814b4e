#pragma once

#include "demens/observe/picture/cut.hpp"

#include "src/observe/picture/quadratic_field.hpp"

#include <algorithm>

namespace demens::observe {

//! Darkness of bed and light as they vary over a picture: a polynomial each, fitted inside the circle where
//! the surface is not near.
class EvenLight
{
  public:
    //! All are kept by reference. \param smooth the image without its noise
    EvenLight(GreyImage const& image, GreyImage const& smooth, Circle const& inside);

    //! Moves a first cut to the middle between bed and light at each place. \return whether there are both
    bool follow(Cut& cut);

    // After `follow`:

    double contrast() const
    {
        return contrast_;
    } //!< darkness of the bed less that of the light at the surface
    double light_spread() const { return light_.spread; } //!< scatter about the polynomial
    double bed_spread() const { return bed_.spread; }
    //! What the polynomials do not describe, over the contrast.
    double unevenness() const { return std::max(light_.remainder, bed_.remainder) / contrast_; }
    //! How far the surface may be off because the polynomials do not describe the light [pixels].
    double shift() const;

  private:
    //! One side of the cut.
    struct Side
    {
        QuadraticField field{};
        double lowest = 0, highest = 0; //!< darkness; beyond it the polynomial is not believed
        double spread = 0;
        double remainder = 0; //!< what the polynomial misses over blocks of pixels, 95th percentile of all or
                              //!< of those near the surface
    };
    struct Pixel
    {
        int column, row;
    };

    Side fit(std::vector<Pixel> const& pixels) const;
    void refine(Side& side, std::vector<Pixel> const& pixels) const;
    void judge(Side& side, std::vector<Pixel> const& pixels, Mask const& mask) const;
    double remainder_of(Side const& side, std::vector<Pixel> const& pixels, Mask const& mask) const;
    double at(Side const& side, int column, int row) const;
    double u(int column) const { return (column + 0.5 - inside_.x) / inside_.radius; }
    double v(int row) const { return (row + 0.5 - inside_.y) / inside_.radius; }
    double darkness(Pixel const& pixel) const
    {
        return static_cast<double>(image_.at(pixel.column, pixel.row));
    }
    //! Finds the surface, and how many pixels half of the contrast is passed over. \return whether there is
    //! one
    bool find_surface(Cut& cut);
    bool is_at_surface(std::vector<float> const& share, int column, int row) const;

    GreyImage const &image_, &smooth_;
    Circle const& inside_;
    int box_; //!< pixels that are looked at to tell how near the surface is
    Side light_, bed_;
    std::vector<float> share_; //!< of grains in the box about each pixel
    std::vector<Pixel> surface_;
    double contrast_ = 0, width_ = 0;
};

} // namespace demens::observe
