#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

//! How good diagnoses were, once the truth is known.
namespace demens::gap {

//! Multiclass Brier score: mean over cases of the sum over classes of (P - truth)^2; 0 is best, 2 worst.
//! \param probabilities [cases x classes] \param truths [cases x classes] 1 for the class of a case; where
//! several are right, their shares, 1 together
double brier_score(Eigen::MatrixXd const& probabilities, Eigen::MatrixXd const& truths);
//! Mean of -ln P(any class that is right); P below 1e-12 counts as that.
double log_score(Eigen::MatrixXd const& probabilities, Eigen::MatrixXd const& truths);

struct ReliabilityBin
{
    double lower, upper; //!< of the probability said
    int cases;           //!< pairs of case and class
    double said;         //!< mean probability said; NaN without cases
    double happened;     //!< share of them that were right; NaN without cases
};
//! Of every class of every case.
std::vector<ReliabilityBin> reliability(Eigen::MatrixXd const& probabilities, Eigen::MatrixXd const& truths,
                                        int bins = 10);

//! Interval of a share by Clopper and Pearson (Biometrika 26:404, 1934): exact, so rather too wide.
std::pair<double, double> share_interval(int hits, int cases, double confidence = 0.95);

struct FScore
{
    double precision, recall, f1; //!< each 1 where there was nothing to find and nothing was found
};
//! Of cells said to be beyond the floor against those that truly are.
FScore location_score(std::vector<bool> const& said, std::vector<bool> const& truth);

} // namespace demens::gap
