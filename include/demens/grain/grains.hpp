#pragma once

#include "demens/grain/body_shape.hpp"
#include "demens/grain/sizes.hpp"
#include "demens/shape/packing.hpp"
#include "demens/shape/size_distribution.hpp"

#include <memory>
#include <string>

namespace demens::grain {

//! A shape as a distribution of sizes takes it.
struct GrainShape
{
    std::string name;                       //!< for messages
    std::shared_ptr<BodyShape const> shape; //!< none: a sphere
    double equivalent_per_size =
        1; //!< diameter of the sphere of the same volume over what is called its size

    bool is_sphere() const { return !shape || shape->is_sphere(); }
    bool is_hull() const { return shape && shape->is_hull(); }
    //! Of the furthest point from the centre, over the radius of the sphere of the same volume.
    double reach() const { return shape ? shape->reach() : 1; }
    double smallest_ball() const { return grain::smallest_ball(shape.get()); }
};

//! \param measured what is called its size
GrainShape grain_shape(std::string name, std::span<Ball const> clump, SizeMeasure measured);
GrainShape grain_shape(std::string name, RoundedHull const& hull, SizeMeasure measured);

//! One grain.
struct Grain
{
    double diameter;    //!< of the sphere of the same volume [m]
    std::uint32_t kind; //!< number of its shape
};

//! What shares of shapes are shares of.
enum class ShareOf : std::uint8_t
{
    mass,
    number //!< of the grains of each size
};

//! Shapes that go together, with shares that sum to 1.
struct ShapeMixture
{
    std::vector<GrainShape> shapes;
    std::vector<double> shares;
    ShareOf share_of = ShareOf::mass;
};

//! Grains of one or several shapes, distributed by mass over their sizes. Each has the mass of the sphere of
//! its volume: masses, densities and numbers are those of such spheres.
class Grains
{
  public:
    //! Spheres.
    explicit Grains(shape::SizeDistribution const& sizes);
    //! All shapes have the same distribution of what is called their size [m]. \throws InputError for shares
    //! that are none
    Grains(shape::SizeDistribution const& sizes, ShapeMixture mixture);

    bool are_spheres() const;
    bool have_hulls() const; //!< among them
    GrainShape const& shape_of(Grain const& grain) const { return kinds_[grain.kind].shape; }

    // Diameters of spheres of the same volume [m]
    double smallest() const;
    double largest() const;
    double quantile(double mass_fraction) const; //!< below it lies that fraction of the mass
    double mean_volume_diameter() const;
    double per_volume() const; //!< expected number of grains in a unit of solid volume [1/m^3]

    //! ... of the spheres that grains are made of; a hull counts as one.
    double balls_per_volume() const;
    //! Diameter of the smallest sphere that grains are made of; a hull counts as that of its volume [m].
    double smallest_ball() const;
    double widest() const; //!< diameter of the ball around its centre that holds the widest grain [m]
    //! How densely grains can be put at random, over spheres: the mean radius of volume over the radius of
    //! the ball that holds it; of hulls, which are put as such balls, its third power [-].
    double looseness() const;

    //! What a step of a mean grain takes over one of a sphere, about (`step_work`).
    double work_per_grain() const;

    //! Grains that make up the mass [kg], as `shape::SizeDistribution::sample_mass`.
    std::vector<Grain> sample_mass(double mass, double density, RandomStream& random) const;
    //! As `shape::sample_whole`. \throws InputError
    std::vector<Grain> sample_whole(double mass, double density, RandomStream& random) const;
    //! As `shape::sample_warning`.
    std::string sample_warning(double mass, double density) const;

    //! Their balls, for packing, of a hull the ball that holds it; valid as long as this.
    std::vector<shape::SphereGroup> outlines(std::vector<Grain> const& grains) const;

  private:
    struct Kind
    {
        GrainShape shape;
        double share;                       //!< of the mass
        shape::SizeDistribution sizes;      //!< diameters of spheres of the same volume [m]
        std::vector<shape::Sphere> outline; //!< in radii of this sphere
    };

    std::vector<Kind> kinds_;
};

} // namespace demens::grain
