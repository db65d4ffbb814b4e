#pragma once

#include "demens/base/random.hpp"
#include "tao_calib/design/factor_space.hpp"

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace demens::tao_calib {

//! Factors seen by surrogates and solvers: each between 0 (lower bound) and 1 (upper bound), evenly in the
//! factor or in its logarithm, and the part of that cube in which the linear constraints hold.
class UnitCube
{
  public:
    //! \throws InputError when bounds or constraints contradict each other or leave no room.
    //! \param fixed values that some factors keep, own units, NaN for free ones [k]; empty: all are free
    UnitCube(std::vector<ensemble::Factor> factors, std::vector<ensemble::LinearConstraint> constraints,
             std::vector<double> const& fixed = {});

    int size() const { return static_cast<int>(factors_.size()); }
    //! Factors that may vary.
    std::vector<int> const& free_factors() const { return free_; }
    bool is_free(int factor) const { return std::isnan(fixed_[factor]); }
    ensemble::Factor const& factor(int number) const { return factors_[static_cast<std::size_t>(number)]; }
    //! The same with one more factor fixed, at a place of the cube. \throws InputError where that leaves no
    //! room
    UnitCube with_fixed(int factor, double unit) const;
    //! The free factors and the constraints between them.
    FactorSpace const& space() const { return space_; }
    //! Points of the free factors, own units, completed by the fixed ones [points x k].
    Eigen::MatrixXd whole_points(Eigen::MatrixXd const& free_points) const;
    //! The point with all fixed factors at their values.
    Eigen::VectorXd pinned(Eigen::VectorXd unit) const;
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
    Eigen::VectorXd completed(Eigen::VectorXd const& free_values) const;

    std::vector<ensemble::Factor> factors_;
    std::vector<ensemble::LinearConstraint> constraints_;
    Eigen::VectorXd fixed_; //!< [k] own units, NaN for free factors
    std::vector<int> free_;
    FactorSpace space_;      //!< of the free factors
    Eigen::VectorXd inside_; //!< shares of the ranges at a point well inside the feasible region
};

} // namespace demens::tao_calib
