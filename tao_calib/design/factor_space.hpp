#pragma once

#include "demens/base/random.hpp"
#include "ensemble/input/campaign_input.hpp"

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace demens::tao_calib {

//! The region that the factors may take, seen from the unit cube: linear or logarithmic between the bounds,
//! discrete factors on their levels, and linear constraints in the factors' own units.
class FactorSpace
{
  public:
    //! \throws InputError when bounds, levels or constraints contradict each other or leave no room.
    FactorSpace(std::vector<ensemble::Factor> factors, std::vector<ensemble::LinearConstraint> constraints);

    int size() const { return static_cast<int>(factors_.size()); }
    bool constrained() const { return !constraints_.empty(); }
    std::vector<ensemble::Factor> const& factors() const { return factors_; }
    std::vector<ensemble::LinearConstraint> const& constraints() const { return constraints_; }

    //! Values in own units at a point of the unit cube; a discrete factor takes the level whose share holds
    //! the point.
    Eigen::VectorXd own_units(Eigen::VectorXd const& unit) const;
    //! The same row by row.
    Eigen::MatrixXd own_units_of_rows(Eigen::MatrixXd const& unit) const;
    //! Position between the bounds, -1 at the lower and +1 at the upper one, logarithmic where the factor is.
    Eigen::VectorXd coded(Eigen::VectorXd const& values) const;

    //! Whether values (own units) lie within all bounds and constraints, but for rounding.
    bool feasible(Eigen::VectorXd const& values) const;
    //! What values (own units) break, in words; empty when they are feasible.
    std::string violation(Eigen::VectorXd const& values) const;
    //! Point of the unit cube in the middle of the feasible region.
    Eigen::VectorXd const& middle() const { return middle_; }
    //! Draws a point of the unit cube, uniform over the part that is feasible.
    Eigen::VectorXd sample(RandomStream& random) const;
    //! The same over the part that is `inside`, which must be feasible but for rounding or levels.
    Eigen::VectorXd sample_where(std::function<bool(Eigen::VectorXd const&)> const& inside,
                                 RandomStream& random) const;
    //! The last feasible point on the way from the middle of the feasible region to `unit`, or nothing when
    //! the levels of discrete factors leave none there.
    std::optional<Eigen::VectorXd> pulled_inside(Eigen::VectorXd const& unit) const;

  private:
    //! A point that is inside, out of some thousand drawn anywhere.
    std::optional<Eigen::VectorXd> drawn_anywhere(std::function<bool(Eigen::VectorXd const&)> const& inside,
                                                  RandomStream& random) const;
    //! Finds points to begin walks at. \throws InputError where there is no room
    void find_room();
    //! A combination of levels and the middle of what it leaves to the other factors.
    std::optional<Eigen::VectorXd> point_on_levels() const;

    std::vector<ensemble::Factor> factors_;
    std::vector<ensemble::LinearConstraint> constraints_;
    Eigen::VectorXd middle_;
    Eigen::VectorXd start_;                //!< well inside the feasible part, unit cube
    std::vector<Eigen::VectorXd> corners_; //!< of it, levels left aside, unit cube
    bool rare_ = false;                    //!< so small a part that drawing anywhere does not find it
};

} // namespace demens::tao_calib
