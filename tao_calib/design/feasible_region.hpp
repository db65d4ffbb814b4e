#pragma once

#include "demens/base/random.hpp"
#include "ensemble/input/campaign_input.hpp"

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace demens::tao_calib {

//! The x >= 0 that maximises c'x within A x <= b, where 0 is feasible (b >= 0) and the region bounded: the
//! simplex method with Bland's rule.
Eigen::VectorXd linear_maximum(Eigen::MatrixXd const& A, Eigen::VectorXd const& b, Eigen::VectorXd const& c);

//! What linear constraints leave of the bounds of the factors, in shares of the ranges; levels are left
//! aside. Decided exactly but for rounding, by linear programs.
class FeasibleRegion
{
  public:
    //! Factors and constraints must fit each other.
    FeasibleRegion(std::vector<ensemble::Factor> const& factors,
                   std::vector<ensemble::LinearConstraint> const& constraints);

    //! Radius of the largest ball inside; 0 where only a surface, a line or a point is left, negative where
    //! nothing is.
    double radius() const { return radius_; }
    bool is_empty() const { return radius_ < -rounding; }
    bool is_flat() const { return radius_ < flat && !is_empty(); }
    //! Its centre.
    Eigen::VectorXd const& centre() const { return centre_; }
    //! Some of the corners: the extreme ones along each factor and in some other directions.
    std::vector<Eigen::VectorXd> corners() const;

  private:
    static constexpr double rounding = 1e-13, flat = 1e-10;

    Eigen::MatrixXd normals_; //!< of the half spaces, unit length, bounds included [n x k]
    Eigen::VectorXd bounds_;  //!< normals x <= bounds [n]
    Eigen::VectorXd centre_;
    double radius_ = 0;
};

//! A random walk that ends up uniform over the places of the unit cube that are `inside`, where these are so
//! few that drawing anywhere does not find them: along single coordinates and along differences of `corners`,
//! shrinking what is drawn from (Neal 2003, Ann. Stat. 31, 705). \param start inside
Eigen::VectorXd walk(Eigen::VectorXd start, std::vector<Eigen::VectorXd> const& corners,
                     std::function<bool(Eigen::VectorXd const&)> const& inside, RandomStream& random);

} // namespace demens::tao_calib
