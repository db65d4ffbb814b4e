#pragma once

#include "gap/statistics/projection.hpp"

#include <cstdint>

//! Where the model misses.
namespace demens::gap {

struct LocateOptions
{
    double level = 0.05;        //!< of the test of the whole, and false discovery rate below it
    double least_left = 0.1;    //!< V_jj over Sigma_F,jj below which a cell is not testable
    int twins = 500;            //!< of the base model
    std::uint64_t seed = 20611; //!< of the twins
};

enum class Finding
{
    not_testable, //!< absorbed by recalibration: nothing can be said of it
    within_floor,
    beyond_floor
};

//! "not testable: absorbed by recalibration", "within the floor", "beyond the floor".
char const* words(Finding finding);

struct LocatedCell
{
    Finding finding;
    double residual; //!< e, after the fit anew of the factors [response units]
    double sigmas;   //!< t = e over its standard deviation; NaN where not testable
    double floor;    //!< standard deviation of Sigma_F [response units]
    double left;     //!< V_jj over Sigma_F,jj
    double p;        //!< of |t| for this cell alone; NaN where not testable
};

struct LocatedGroup
{
    std::string name;
    Finding finding;
    double chi_square;          //!< of what recalibration leaves of it
    int degrees_of_freedom;     //!< directions of which it leaves at least `least_left`
    double p;                   //!< NaN where not testable
    double left_out_chi_square; //!< of the group against its prediction from all others
    double left_out_p;
};

struct Located
{
    std::vector<LocatedCell> cells;   //!< in the order of the evidence
    std::vector<LocatedGroup> groups; //!< in the order given
    double largest;                   //!< max |t|
    double critical;                  //!< its quantile 1 - level over twins
    double p;                         //!< of `largest`, over twins: of the whole, trials counted
    bool beyond_floor() const { return largest > critical; }
};

//! A part of the residuals that is tested as a whole: directions * e is N(0, I) where the base model is
//! right.
struct GroupTest
{
    CellGroup group;
    Eigen::MatrixXd directions; //!< of which recalibration leaves enough [degrees of freedom x cells]
};

//! What locating needs of the evidence but for the residuals, made once: the distribution of max |t| by
//! twins.
class Locator
{
  public:
    Locator(Evidence const& evidence, Projection const& projection, std::vector<CellGroup> groups,
            LocateOptions const& options = {});

    //! The whole by max |t|; where that is beyond, groups by their false discovery rate; within those, cells
    //! by theirs (Yekutieli, J. Am. Stat. Assoc. 103:309, 2008). A cell of no group is tested with those that
    //! are in none. \param residual y - m0 [n]
    Located locate(Eigen::VectorXd const& residual) const;

    //! What recalibration leaves of a change of all cells, over its standard deviation, as t is [n]; NaN
    //! where not testable.
    Eigen::VectorXd left_of(Eigen::VectorXd const& change) const;

    //! The smallest p value of all cells, all groups, and all cells together, each for itself.
    double smallest_p(Eigen::VectorXd const& residual) const;

  private:
    Eigen::VectorXd sigmas(Eigen::VectorXd const& refitted) const;

    Projection const& projection_;
    std::vector<GroupTest> groups_;
    LocateOptions options_;
    Eigen::MatrixXd covariance_; //!< V
    Eigen::MatrixXd precision_;  //!< C^-1
    std::vector<double> null_;   //!< max |t| of the twins, ascending
};

} // namespace demens::gap
