#pragma once

#include "gap/statistics/evidence.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace demens::gap {

//! Residuals r = y - m0 under a hypothesis with K effects (none, one, two), given their amplitudes u over
//! `typical`, each counted in the direction of its sign: r | u ~ N(sum u s + u^2 q, Sigma + J_u Lambda J_u'),
//! J_u = J + sum u T; the factors are integrated exactly. All of it is a polynomial in u between products
//! that are made once, so that one u costs O(p^3).
class AmplitudeModel
{
  public:
    //! \param covariance Sigma of r for given factors and amplitudes [n x n]
    AmplitudeModel(Evidence const& evidence, Eigen::MatrixXd const& covariance,
                   std::vector<Signature> const& effects);

    //! What one residual vector has to do with the model.
    struct Data
    {
        double square;            //!< r' Sigma^-1 r
        Eigen::VectorXd products; //!< with the columns of the model
    };
    Data project(Eigen::VectorXd const& residual) const;

    int effects() const { return static_cast<int>(units_.size()); }
    bool linear() const { return linear_; } //!< neither T nor q
    bool one_signed(int effect) const { return one_signed_[effect]; }
    double unit(int effect) const { return units_[effect]; } //!< amplitude of u = 1

    //! ln of the density of r given u, times exp(-u'u / 2), where T and q are left out: value + slope u - u'
    //! precision u / 2.
    struct Quadratic
    {
        double value;
        Eigen::VectorXd slope;     //!< [K]
        Eigen::MatrixXd precision; //!< [K x K]
    };
    Quadratic linearised(Data const& data) const;

    //! min over the factors of the squares of what is left and of the factors, each over its covariance.
    double misfit(Data const& data, Eigen::VectorXd const& u) const;
    //! ln of the density of r given u.
    double log_likelihood(Data const& data, Eigen::VectorXd const& u) const;
    //! d at that minimum [p, unit-cube].
    Eigen::VectorXd factors(Data const& data, Eigen::VectorXd const& u) const;
    //! Covariance of the factors given u [p x p].
    Eigen::MatrixXd factor_covariance(Eigen::VectorXd const& u) const;

  private:
    struct Solved
    {
        double square;             //!< of the whitened r less what the amplitudes make of it
        Eigen::VectorXd along;     //!< its products with the columns of whitened J_u [p]
        Eigen::MatrixXd precision; //!< I + J_u' J_u [p x p]
    };
    Solved solve(Data const& data, Eigen::VectorXd const& u) const;

    Eigen::Index p_;
    bool linear_ = true;
    std::vector<double> units_;
    std::vector<bool> one_signed_;
    Eigen::MatrixXd prior_root_; //!< of Lambda [p x p]
    Eigen::MatrixXd root_;       //!< of Sigma, lower triangle [n x n]
    double log_determinant_;     //!< of 2 pi Sigma
    //! Whitened J, then each T, then each s, then each q, with units and signs; the columns of J and T are
    //! those of factors with a prior N(0, I).
    Eigen::MatrixXd columns_;
    Eigen::MatrixXd gram_; //!< columns' columns
    // Of the linearised model; these do not depend on r.
    Eigen::LLT<Eigen::MatrixXd> base_precision_; //!< I + J'J [p x p]
    Eigen::MatrixXd hidden_;                     //!< factors that signatures make in a fit anew [p x K]
    Eigen::MatrixXd precision_;                  //!< of u [K x K]
    double log_freedom_;                         //!< ln of the determinant of I + J'J
};

} // namespace demens::gap
