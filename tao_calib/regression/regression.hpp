#pragma once

#include "tao_calib/regression/terms.hpp"

#include <optional>

namespace demens::tao_calib {

//! One response of a number of runs.
struct RegressionData
{
    std::vector<std::string> factors; //!< names
    std::string response;             //!< name
    Eigen::MatrixXd coded; //!< [runs x factors], -1 to 1 where p values of interactions are to mean something
    Eigen::VectorXd values; //!< [runs]
};

//! Estimate of one coefficient, and the test of whether it is zero.
struct Coefficient
{
    Term term;
    double value;
    double standard_error;
    double t; //!< value / standard error: the standardised effect
    double p; //!< of |t| when the coefficient is zero
};

//! Least squares polynomial of one response, by QR with column pivoting.
class Regression
{
  public:
    //! \throws InputError when there are fewer runs than terms, the response is constant, a number is
    //! missing, or the runs cannot tell terms apart (the message names them).
    Regression(RegressionData data, std::vector<Term> terms);

    RegressionData const& data() const { return data_; }
    std::vector<Coefficient> const& coefficients() const
    {
        return coefficients_;
    } //!< in the order of the terms
    std::vector<Term> terms() const;
    int runs() const { return static_cast<int>(data_.values.size()); }
    int residual_degrees_of_freedom() const { return runs() - static_cast<int>(coefficients_.size()); }

    Eigen::VectorXd const& fitted() const { return fitted_; }
    Eigen::VectorXd residuals() const { return data_.values - fitted_; }
    Eigen::VectorXd const& leverages() const { return leverages_; }
    double residual_sum_of_squares() const { return residuals().squaredNorm(); }
    double total_sum_of_squares() const; //!< about the mean
    //! Standard deviation of the residual; NaN without degrees of freedom.
    double residual_standard_deviation() const;
    double r_squared() const;
    double adjusted_r_squared() const;
    //! Sum of squares of each run less its prediction from all other runs (PRESS).
    double prediction_sum_of_squares() const;
    double predicted_r_squared() const { return 1 - prediction_sum_of_squares() / total_sum_of_squares(); }

    double predict(Eigen::VectorXd const& coded) const;
    //! Of the predicted mean.
    double prediction_standard_error(Eigen::VectorXd const& coded) const;
    //! Slope with respect to each coded factor.
    Eigen::VectorXd gradient(Eigen::VectorXd const& coded) const;

  private:
    Eigen::VectorXd row(Eigen::VectorXd const& coded) const;

    RegressionData data_;
    std::vector<Coefficient> coefficients_;
    Eigen::MatrixXd inverse_root_; //!< W with W W' = (X'X)^-1
    Eigen::VectorXd fitted_, leverages_;
};

//! Terms that the runs cannot tell from earlier ones, each as "C = A*B"; empty when all can be.
std::vector<std::string> aliased_terms(RegressionData const& data, std::vector<Term> const& terms);

//! Which terms stay in a model because of others.
enum class Hierarchy
{
    products, //!< a product keeps its factors; a square can stand alone
    strict //!< a square keeps its factor as well: the model does not depend on where the coding has its zero
};

struct EliminationOptions
{
    double alpha = 0.05; //!< a term whose p exceeds this may go
    Hierarchy hierarchy = Hierarchy::products;
};

//! A term that was left out, and the p value it had then.
struct Elimination
{
    Term term;
    double p;
};

struct ReducedRegression
{
    Regression regression;
    std::vector<Elimination> eliminated; //!< in the order in which they went
};

//! Leaves out the least significant term that hierarchy lets go, again and again; the constant stays. \throws
//! InputError also when no degree of freedom is left to test with.
ReducedRegression eliminate_backward(RegressionData const& data, std::vector<Term> const& terms,
                                     EliminationOptions const& options = {});

} // namespace demens::tao_calib
