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
    Eigen::VectorXd values;          //!< [runs]
    Eigen::VectorXd weights = {};    //!< inverse variances but for a factor [runs]; empty: all alike
    std::vector<int> factor_of = {}; //!< factor of each column, where one has several; empty: each is its own

    int factor(int column) const { return factor_of.empty() ? column : factor_of[column]; }
};

//! Estimate of one coefficient, and the test of whether it is zero.
struct Coefficient
{
    Term term;
    double value;
    double standard_error; //!< NaN without degrees of freedom
    double t;              //!< value / standard error: the standardised effect; NaN without scatter
    double p;              //!< of |t| when the coefficient is zero
};

//! What the residuals say of the runs' scatter.
enum class Scatter
{
    known,
    saturated, //!< no degree of freedom is left: nothing is known of it
    none       //!< the model meets every run but for rounding
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
    Scatter scatter() const { return scatter_; }

    Eigen::VectorXd const& fitted() const { return fitted_; }
    Eigen::VectorXd residuals() const { return data_.values - fitted_; }
    Eigen::VectorXd const& leverages() const { return leverages_; }
    double residual_sum_of_squares() const; //!< weighted, as those below
    double total_sum_of_squares() const;    //!< about the mean
    //! Standard deviation of the residual, of weight 1; NaN without degrees of freedom.
    double residual_standard_deviation() const;
    double r_squared() const;
    double adjusted_r_squared() const; //!< NaN without degrees of freedom
    //! The run that alone determines a coefficient, if there is one: no other tells what it would be without
    //! it.
    std::optional<int> run_of_leverage_one() const;
    //! Sum of squares of each run less its prediction from all other runs (PRESS); NaN with such a run.
    double prediction_sum_of_squares() const;
    double predicted_r_squared() const { return 1 - prediction_sum_of_squares() / total_sum_of_squares(); }

    double predict(Eigen::VectorXd const& coded) const;
    //! Of the predicted mean.
    double prediction_standard_error(Eigen::VectorXd const& coded) const;
    //! Covariance of the coefficients over the residual variance is W W' [terms x terms].
    Eigen::MatrixXd const& inverse_root() const { return inverse_root_; }
    //! Mean of the runs' numbers by their weights.
    double weighted_mean(Eigen::VectorXd const& numbers) const;
    //! Residual sum of squares that rounding may leave of a model that meets every run.
    double rounding_sum_of_squares() const { return rounding_; }
    //! Slope with respect to each coded factor.
    Eigen::VectorXd gradient(Eigen::VectorXd const& coded) const;

  private:
    Eigen::VectorXd row(Eigen::VectorXd const& coded) const;
    double weighted_squares(Eigen::ArrayXd const& deviations) const;

    RegressionData data_;
    std::vector<Coefficient> coefficients_;
    Eigen::MatrixXd inverse_root_; //!< W with W W' = (X'X)^-1, X of weighted rows
    Eigen::VectorXd fitted_, leverages_;
    double rounding_ = 0;
    Scatter scatter_ = Scatter::known;
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
    std::vector<int> always = {}; //!< factors all of whose terms stay: blocks
};

//! A term that was left out, and the p value it had then: of all columns of its factors together.
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
