#pragma once

#include "gap/statistics/amplitude_integral.hpp"
#include "gap/statistics/projection.hpp"

namespace demens::gap {

//! What may have made the residuals: nothing but the floor, one effect, two, or something that no effect
//! describes.
struct Hypothesis
{
    enum class Kind
    {
        none,
        effects,
        unknown
    };
    Kind kind;
    std::vector<int> effects = {}; //!< places in the list of effects, ascending
};

struct HypothesisOptions
{
    double prior_none = 0.25;
    double prior_single = 0.50;  //!< shared out among the effects
    double prior_pairs = 0.10;   //!< shared out among their pairs
    double prior_unknown = 0.15; //!< what hypotheses there are none of leaves its part to the others
    std::vector<double> unknown_strengths = {0.01, 0.03, 0.1,
                                             0.3}; //!< tau, over the response's scale; mixed alike
    //! Pairs of effects that are not linear count as if they were where that makes them less probable than
    //! the best hypothesis by a factor exp(-pair_screen).
    double pair_screen = 8;
    double temperature = 1; //!< ln of evidence is divided by it
};

//! The densities of residuals r = y - m0 under all hypotheses, prepared once for any r:
//! none N(0, C); effect k: factors and amplitude integrated, with k's form error over its signature,
//! E[a^2] (kappa^2 diag(s) K diag(s) + error of s) in the covariance; unknown N(0, C + tau^2 W K W), W the
//! scales.
class Hypotheses
{
  public:
    //! \throws InputError for bad evidence, effects or options, and for two effects of the same name
    Hypotheses(Evidence const& evidence, Projection const& projection, std::vector<Signature> effects,
               HypothesisOptions const& options = {});

    //! None, then the effects as given, then their pairs, then unknown.
    std::vector<Hypothesis> const& list() const { return list_; }
    std::vector<Signature> const& effects() const { return effects_; }
    HypothesisOptions const& options() const { return options_; }
    Eigen::VectorXd const& priors() const { return priors_; }

    //! ln of the density of r under each hypothesis.
    Eigen::VectorXd log_evidences(Eigen::VectorXd const& residual) const;
    //! Of each, given ln of their densities; at the temperature of the options.
    Eigen::VectorXd probabilities(Eigen::VectorXd const& log_evidences) const;
    //! Of a hypothesis with effects.
    AmplitudePosterior posterior(int hypothesis, Eigen::VectorXd const& residual) const;
    //! Where it is unknown there is none.
    AmplitudeModel const& model(int hypothesis) const { return models_[hypothesis]; }

  private:
    std::vector<Signature> effects_;
    HypothesisOptions options_;
    std::vector<Hypothesis> list_;
    Eigen::VectorXd priors_;
    std::vector<AmplitudeModel> models_;         //!< of all but unknown
    std::vector<Eigen::MatrixXd> unknown_roots_; //!< lower triangles, one for each strength
};

//! Sigma_F and what the effects' own form errors and the errors of their signatures add, amplitudes squared
//! [K] given [n x n].
Eigen::MatrixXd covariance_with(Evidence const& evidence, Eigen::MatrixXd const& floor,
                                std::vector<Signature> const& effects, Eigen::VectorXd const& squares);

} // namespace demens::gap
