#pragma once

#include "gap/statistics/evidence.hpp"

#include <string>
#include <vector>

//! What of an effect is left once the calibrated factors have bent to hide it.
namespace demens::gap {

//! Covariances of residuals, factored once: Sigma_F of the floor, and C = Sigma_F + J Lambda J' with the
//! factors' freedom. In space whitened by Sigma_F, C^-1 is Pi = (I + J Lambda J')^-1, and <u, v> = u' Pi v.
class Projection
{
  public:
    //! \param floor Sigma_F [n x n] \throws InputError for bad evidence, and where the floor leaves a cell,
    //! or a combination of cells, without any error
    Projection(Evidence const& evidence, Eigen::MatrixXd floor);

    Eigen::MatrixXd const& floor() const { return floor_; }
    Eigen::MatrixXd const& total() const { return total_; } //!< C [n x n]
    Eigen::Index size() const { return floor_.rows(); }

    //! Columns in units of the floor: the inverse root of Sigma_F times them.
    Eigen::MatrixXd whiten(Eigen::MatrixXd const& columns) const;
    //! The inverse root of C times columns: dot products of these are the inner products <.,.>.
    Eigen::MatrixXd reduce(Eigen::MatrixXd const& columns) const;
    //! C^-1 times columns.
    Eigen::MatrixXd solve(Eigen::MatrixXd const& columns) const;
    //! Pi, in whitened space [n x n].
    Eigen::MatrixXd whitened_projector() const;

    //! <u, v> of vectors in response units.
    double inner(Eigen::VectorXd const& u, Eigen::VectorXd const& v) const;
    //! 1 - <s, s> / s's: what recalibration hides of a signature; 1 for a signature that is zero.
    double absorbed_share(Eigen::VectorXd const& signature) const;

  private:
    Eigen::MatrixXd floor_, total_;
    Eigen::MatrixXd floor_root_, total_root_; //!< lower triangles
};

//! The lower triangle L with L L' = covariance. \throws InputError that names the cell where it is singular
Eigen::MatrixXd checked_root(Eigen::MatrixXd const& covariance, std::vector<Cell> const& cells);

//! |a s| that is told from none 95 times in 100 by a one-sided test at 5 %: twice 1.645.
inline constexpr double least_distance = 3.3;

//! How far the projected signatures of effects are from none and from each other.
struct Distances
{
    Eigen::VectorXd norms;    //!< a |s| [effects]
    Eigen::VectorXd absorbed; //!< shares [effects]
    Eigen::MatrixXd cosines;  //!< [effects x effects]
    Eigen::MatrixXd between;  //!< d = a min(|s_i|, |s_j|) sqrt(1 - cos^2) [effects x effects]
    //! Amplitude that is told from none [effects, over `typical`]; infinite where all of it is absorbed.
    Eigen::VectorXd smallest_detectable;
};

//! \param strength a over `typical`, of all effects
Distances distances(Projection const& projection, std::vector<Signature> const& effects, double strength = 1);

//! Sets of effects that cannot be told apart (connected by d < `least`), each ascending, in the order of
//! their first members. An effect that is itself below `least` of none connects only with those that point
//! where it points (sqrt(1 - cos^2) < 0.1): else one weak effect would join all.
std::vector<std::vector<int>> confusable_groups(Distances const& distances, double least = least_distance);

} // namespace demens::gap
