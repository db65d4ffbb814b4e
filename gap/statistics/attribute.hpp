#pragma once

#include "gap/statistics/hypotheses.hpp"
#include "gap/statistics/locate.hpp"

//! Which effect the model lacks.
namespace demens::gap {

struct AttributeOptions
{
    double global_level = 0.05; //!< of the test of the whole: above it nothing is named
    double gate = 0.97;         //!< quantile of the winner's own twins above which a misfit means unknown
    //! For effects that are not linear, where the misfit is 0.75 to 1.5 of chi-square's quantile; else that
    //! is taken.
    int gate_twins = 500;
    double named_at = 0.80;     //!< probability from which an effect, or a group of effects, is named
    double decoy_level = 0.05;  //!< p of the closure among decoys, up to which they are beaten
    int twins = 500;            //!< of the base model, for the test of the whole
    std::uint64_t seed = 90210; //!< of all twins
};

enum class Verdict
{
    within_floor,     //!< nothing beyond what even the right model would miss
    effects_named,    //!< one, or two
    group_named,      //!< one of these effects, which these experiments cannot tell apart
    unknown,          //!< something that no effect describes
    not_resolvable,   //!< the experiments do not decide
    decoys_not_beaten //!< probable by the fit, but others close the gap as well
};

char const* words(Verdict verdict);

struct ScoredHypothesis
{
    Hypothesis hypothesis;
    double log_bayes_factor; //!< ln, against none
    double probability;
};

struct ScoredEffect
{
    double probability;    //!< that it acts, alone or in a pair
    double amplitude;      //!< posterior mean, alone [own unit]
    double deviation;      //!< of the amplitude's posterior [own unit]
    double absorbed_share; //!< what recalibration hides of it
};

struct Attribution
{
    std::vector<ScoredHypothesis> hypotheses; //!< in the order of `Hypotheses::list`
    std::vector<ScoredEffect> effects;        //!< in the order of the effects
    std::vector<std::vector<int>> groups;     //!< effects that cannot be told apart at the strength found
    std::vector<double> group_probabilities;  //!< that one of the group's members acts [groups]
    double probability_none, probability_unknown;
    int winner;                  //!< most probable hypothesis but unknown
    double misfit, misfit_limit; //!< of the winner, and the gate's quantile
    double global_p;             //!< of the largest local statistic, trials counted
    bool beyond_floor;           //!< global_p is at most the level
    Verdict verdict;
    std::vector<int> named; //!< effects that are named, one or two
    std::vector<std::vector<int>>
        named_groups; //!< of which one member each is missing; which one is not known

    bool gate_holds() const { return misfit <= misfit_limit; }
};

//! What attribution needs of the evidence but for the residuals, made once.
class Attributor
{
  public:
    //! All are kept by reference.
    Attributor(Evidence const& evidence, Projection const& projection, Locator const& locator,
               Hypotheses const& hypotheses, AttributeOptions const& options = {});

    //! \param residual y - m0 [n] \param decoy_p p of each effect's closure among decoys, NaN where that was
    //! not tried; empty: of none
    Attribution attribute(Eigen::VectorXd const& residual, std::vector<double> const& decoy_p = {}) const;

    //! p of the largest of all local statistics: cells, groups, all cells together, and each effect's
    //! direction.
    double global_p(Eigen::VectorXd const& residual) const;

  private:
    double smallest_p(Eigen::VectorXd const& residual) const;
    void test_winner(Attribution& found, Eigen::VectorXd const& residual) const;
    void group(Attribution& found) const;
    void judge(Attribution& found, std::vector<double> const& decoy_p) const;

    Evidence const& evidence_;
    Projection const& projection_;
    Locator const& locator_;
    Hypotheses const& hypotheses_;
    AttributeOptions options_;
    Eigen::MatrixXd directions_; //!< reduced signatures of length 1 [n x effects]
    std::vector<double> null_;   //!< smallest p of the twins, ascending
};

} // namespace demens::gap
