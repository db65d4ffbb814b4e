#pragma once

#include "ensemble/input/kinds.hpp"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace demens::tao_calib {

//! A product of powers of the factors, e.g. A^2 B.
struct Term
{
    std::vector<int> exponents; //!< one per factor

    int degree() const;
    //! Whether this term is a factor of the other one, itself included: A and A^2 are marginal to A^2 B.
    bool marginal_to(Term const& other) const;
    double value(Eigen::VectorXd const& coded) const;
    //! "constant", "A", "A*B", "A^2".
    std::string name(std::vector<std::string> const& factors) const;

    bool operator==(Term const&) const = default;
};

using ensemble::PolynomialModel;

//! Constant, main effects, products, squares; in the order of the factors.
std::vector<Term> polynomial_terms(PolynomialModel model, int factors);

//! What a coded column can take part in.
struct TermColumn
{
    int factor;            //!< columns of one factor have no products
    bool squared = true;   //!< not with two levels, whose square is a constant
    bool interacts = true; //!< not a block
};
//! The same of columns that are not all alike.
std::vector<Term> polynomial_terms(PolynomialModel model, std::vector<TermColumn> const& columns);

//! Factors that can carry a square: those of free values or at least three levels.
std::vector<TermColumn> columns_of_factors(std::vector<std::size_t> const& levels);

//! Value of each term at each coded point [points x terms].
Eigen::MatrixXd model_matrix(std::vector<Term> const& terms, Eigen::MatrixXd const& coded);

} // namespace demens::tao_calib
