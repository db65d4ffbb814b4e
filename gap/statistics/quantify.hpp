#pragma once

#include "gap/statistics/floor.hpp"
#include "gap/statistics/refit.hpp"

#include <cstdint>

//! How far an effect closes the gap, on experiments that took no part.
namespace demens::gap {

//! What was measured there, and how sure that and a prediction can be.
struct HeldOut
{
    std::vector<Cell> cells;
    Eigen::VectorXd measured; //!< [m, response units]
    Floor floor;              //!< with the packings that are behind a prediction
};

//! \throws InputError for bad evidence, and where there is no cell: without held-out experiments there is no
//! closure
HeldOut held_out(Evidence const& evidence);

//! What a model that was fitted to other experiments says.
struct HeldOutPrediction
{
    Eigen::MatrixXd packings;        //!< runs that differ by their seed alone [S x m, response units]
    Eigen::MatrixXd estimation = {}; //!< covariance of its mean by the fit [m x m]; empty: none
};

//! Covariance of what a linear fit of the factors, and of amplitudes with the prior N(0, typical^2), to
//! `fitted` leaves uncertain on other cells; less what fitted and held-out cells have in common in their form
//! errors. [m x m]
Eigen::MatrixXd estimation_covariance(Evidence const& fitted, Projection const& projection,
                                      Evidence const& held_out,
                                      std::vector<Signature> const& effects_fitted = {},
                                      std::vector<Signature> const& effects_held_out = {});

//! Misfit of held-out cells.
struct ExcessMisfit
{
    double square; //!< D^2: residuals over the floor, experiment by experiment, over the number of cells
    double excess; //!< E = D^2 - 1 - estimation term
    //! D^2 that even the right model reaches 5 times in 100.
    double floor_limit;
    bool at_floor() const { return square <= floor_limit; }
};
ExcessMisfit excess_misfit(HeldOut const& held_out, HeldOutPrediction const& prediction);

struct CellGap
{
    double before, after; //!< measured less predicted [response units]
    double floor;         //!< standard deviation [response units]
};

struct QuantifyOptions
{
    int resamples = 1000;
    double confidence = 0.90;
    std::uint64_t seed = 4711;
};

struct Closure
{
    ExcessMisfit before, after;
    bool at_floor;              //!< before: there is no gap to close, and no ratio
    double closure;             //!< C = 1 - E_after / E_before, 1 at most; NaN at the floor
    double lower, upper;        //!< its interval by bootstrap; NaN at the floor
    double resamples_at_floor;  //!< share of resamples in which nothing is left to close: these count as no
                                //!< closure
    std::vector<CellGap> cells; //!< [m]
};

//! Bootstrap over experiments, within them over measurements (by their scatter) and packings.
Closure quantify(HeldOut const& held_out, HeldOutPrediction const& before, HeldOutPrediction const& after,
                 QuantifyOptions const& options = {});

} // namespace demens::gap
