#pragma once

#include <Eigen/Core>
#include <vector>

namespace demens::gap {

//! A normal distribution of which some variables are positive, drawn from one variable after the other, each
//! from what is left for it (Geweke, Hajivassiliou and Keane); its own density, which is not the truncated
//! one, is known.
class TruncatedNormal
{
  public:
    TruncatedNormal(std::vector<bool> one_signed, Eigen::VectorXd mean, Eigen::MatrixXd const& covariance);

    //! The point that belongs to a point of the unit cube, whose coordinates are above 0 and below 1.
    Eigen::VectorXd at(Eigen::VectorXd const& cube) const;
    //! Of the points that are drawn.
    double log_density(Eigen::VectorXd const& u) const;

  private:
    //! ln of the probability that variable k has its sign, given those before it.
    double log_room(Eigen::VectorXd const& x, Eigen::Index k) const;

    std::vector<bool> one_signed_;
    Eigen::VectorXd mean_;
    Eigen::MatrixXd root_;
};

//! ln of the probability that both of two normal variables are positive.
double log_both_positive(Eigen::VectorXd const& mean, Eigen::MatrixXd const& covariance);

//! Point of `points` that are evenly spread over the unit interval or square: multiples of the golden
//! section.
Eigen::VectorXd cube_point(int point, int points, Eigen::Index dimensions);

} // namespace demens::gap
