#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

//! The numbers of the gap diagnosis. n: cells, p: calibrated factors, response unit: that of the
//! cell, which may differ from cell to cell.
namespace demens::gap {

//! One thing that is compared: a response of an experiment, or a window of a curve or picture of it.
struct Cell
{
    std::string name;
    int experiment = 0;      //!< cells of one experiment come from the same runs
    int response_family = 0; //!< the same response under other conditions: form error is smooth over these
    std::vector<double> condition; //!< coordinates of the experiment, each scaled to about 0 to 1, e.g. speed
    double scale = 0;              //!< size of the response [response unit]: of its form error
};

//! How the cells of one experiment scatter between packings.
struct PackingScatter
{
    std::vector<int> cells; //!< places in `Evidence::cells` [m]
    //! Of each run from the mean of the runs at its own point [runs x m, response units].
    Eigen::MatrixXd deviations;
    int degrees_of_freedom = 0; //!< runs less points
    int packings = 1;           //!< S: so many are averaged in the prediction
};

//! All fitted, or all held-out, cells stacked; what was measured, what the calibrated model says, and how
//! sure each is.
struct Evidence
{
    std::vector<Cell> cells;
    Eigen::VectorXd measured;       //!< mean of the repeats [n, response units]
    Eigen::VectorXd predicted;      //!< m0 at theta0, the calibrated optimum [n, response units]
    Eigen::MatrixXd nuisance;       //!< J, response units per unit of a factor's unit-cube coordinate [n x p]
    Eigen::MatrixXd nuisance_prior; //!< Lambda, covariance of the factors' prior about theta0 [p x p]

    Eigen::VectorXd experiment_variance;         //!< of one measurement [n, response units squared]
    Eigen::VectorXd repeats;                     //!< measurements behind `measured` [n]; empty: one of each
    Eigen::MatrixXd experiment_correlation = {}; //!< between cells [n x n]; empty: none
    std::vector<PackingScatter> packing = {};    //!< cells that are in none of them have no such part
    Eigen::VectorXd surrogate_variance = {};     //!< [n, response units squared]; empty: none
    double form_floor = 0.04;                    //!< form error over `Cell::scale`
    double correlation_length = 0.5;             //!< of the form error over the conditions

    int size() const { return static_cast<int>(cells.size()); }
    int factors() const { return static_cast<int>(nuisance.cols()); }
    Eigen::VectorXd residual() const { return measured - predicted; }
};

//! \throws InputError when sizes do not fit, a number is missing, or a variance or scale is negative; the
//! message names the cell.
void check(Evidence const& evidence);

//! Which amplitudes an effect can have.
enum class Sign
{
    either,
    positive,
    negative
};

//! How all cells change with an effect's amplitude a: m(a, theta) = m0 + J d + a s + a T d + a^2 q, with d =
//! theta - theta0. Its prior is N(0, typical^2), or the half of that on the side of its sign.
struct Signature
{
    std::string name;
    Eigen::VectorXd first;               //!< s [n, response units per amplitude]
    Eigen::MatrixXd interaction = {};    //!< T [n x p]; empty: none
    Eigen::VectorXd second = {};         //!< q [n]; empty: none
    Eigen::VectorXd first_variance = {}; //!< of the regression that gave s [n]; empty: s is exact
    double typical = 1;                  //!< standard deviation of the amplitude's prior
    Sign sign = Sign::either;
    double form_error = 0.2; //!< kappa: error of the effect's own form, over the size of its signature
};

//! \throws InputError when sizes do not fit the evidence or a number is missing; the message names the
//! effect.
void check(Signature const& signature, Evidence const& evidence);

//! Some of the cells, in the order given: those fitted or those held out, or a fold.
Evidence subset(Evidence const& evidence, std::vector<int> const& cells);
Signature subset(Signature const& signature, std::vector<int> const& cells);

//! Cells that are judged together.
struct CellGroup
{
    std::string name;
    std::vector<int> cells; //!< places in `Evidence::cells`
};

//! One group for each experiment, named by its number, in ascending order.
std::vector<CellGroup> groups_by_experiment(std::vector<Cell> const& cells);

} // namespace demens::gap
