#pragma once

#include "demens/base/random.hpp"
#include "tao_calib/design/factor_space.hpp"

#include <Eigen/Core>
#include <vector>

namespace demens::tao_calib {

//! Factors seen by surrogates and solvers: each between 0 (lower bound) and 1 (upper bound), evenly in the
//! factor or in its logarithm, and the part of that cube in which the linear constraints hold.
class UnitCube
{
  public:
    //! \throws InputError when bounds or constraints contradict each other or leave no room.
    UnitCube(std::vector<ensemble::Factor> factors, std::vector<ensemble::LinearConstraint> constraints);

    int size() const { return space_.size(); }
    bool constrained() const { return !constraints_.empty(); }

    //! Place in the cube of values in own units.
    Eigen::VectorXd to_unit(Eigen::VectorXd const& values) const;
    //! Values in own units, exactly within their bounds; discrete factors as if they were continuous.
    Eigen::VectorXd to_values(Eigen::VectorXd const& unit) const;
    //! The nearest point that can be simulated, in own units: within bounds and constraints exactly, discrete
    //! factors on their levels.
    std::vector<double> to_design_point(Eigen::VectorXd const& unit) const;

    //! Whether values (own units) are within all bounds and constraints, without any tolerance.
    bool feasible(Eigen::VectorXd const& values) const;
    //! The nearest point of the cube whose values are feasible, distances being measured in shares of the
    //! ranges.
    Eigen::VectorXd project(Eigen::VectorXd const& unit) const;
    //! A point of the cube, uniform over its feasible part.
    Eigen::VectorXd sample(RandomStream& random) const;

  private:
    Eigen::VectorXd on_levels(Eigen::VectorXd const& values) const;

    FactorSpace space_;
    std::vector<ensemble::Factor> factors_;
    std::vector<ensemble::LinearConstraint> constraints_;
    Eigen::VectorXd inside_; //!< shares of the ranges at a point well inside the feasible region
};

} // namespace demens::tao_calib
