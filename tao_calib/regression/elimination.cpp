// Backward elimination. A model of many terms is refitted from its covariance, which costs t^2 where a new
// decomposition costs n t^2, and decomposed anew now and then.
#include "tao_calib/regression/distributions.hpp"
#include "tao_calib/regression/regression.hpp"

#include "demens/base/error.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t small = 60; //!< terms up to which every step is a decomposition
constexpr int steps_by_update = 16;

//! Powers of the factors, over all columns of each.
Term by_factor(Term const& term, RegressionData const& data)
{
    Term result{std::vector<int>(term.exponents.size(), 0)};
    for (std::size_t k = 0; k < term.exponents.size(); ++k)
        result.exponents[data.factor(static_cast<int>(k))] += term.exponents[k];
    return result;
}

bool keeps(Term const& kept, Term const& by, Hierarchy hierarchy)
{
    bool const is_square =
        by.degree() == 2 && *std::max_element(by.exponents.begin(), by.exponents.end()) == 2;
    return !(kept == by) && kept.marginal_to(by) && (hierarchy == Hierarchy::strict || !is_square);
}

//! A fit that can lose terms.
class ShrinkingFit
{
  public:
    ShrinkingFit(RegressionData const& data, Regression const& fit)
        : exact_(fit.scatter() == Scatter::none), rounding_(fit.rounding_sum_of_squares()),
          terms_(fit.terms()), covariance_(fit.inverse_root() * fit.inverse_root().transpose()),
          residual_(fit.residual_sum_of_squares()), degrees_(fit.residual_degrees_of_freedom())
    {
        values_.resize(static_cast<Index>(terms_.size()));
        for (std::size_t t = 0; t < terms_.size(); ++t) {
            values_[static_cast<Index>(t)] = fit.coefficients()[t].value;
            by_factor_.push_back(by_factor(terms_[t], data));
            decomposed_p_.push_back(fit.coefficients()[t].p);
        }
    }

    std::vector<Term> const& terms() const { return terms_; }
    //! Places of the terms that share the factors of this one: they go together.
    std::vector<Index> together_with(std::size_t term) const
    {
        std::vector<Index> places;
        for (std::size_t t = 0; t < terms_.size(); ++t)
            if (by_factor_[t] == by_factor_[term])
                places.push_back(static_cast<Index>(t));
        return places;
    }
    bool may_go(std::size_t term, EliminationOptions const& options) const
    {
        auto const& powers = by_factor_[term].exponents;
        bool const stays = std::any_of(options.always.begin(), options.always.end(),
                                       [&](int factor) { return powers[factor] > 0; });
        return by_factor_[term].degree() > 0 && !stays &&
               std::none_of(by_factor_.begin(), by_factor_.end(), [&](Term const& other) {
                   return keeps(by_factor_[term], other, options.hierarchy);
               });
    }
    //! Of these terms being zero; where nothing scatters, 1 for those that have no part in the fit, else 0.
    double p(std::vector<Index> const& places) const
    {
        if (!exact_ && places.size() == 1 && !std::isnan(decomposed_p_[static_cast<std::size_t>(places[0])]))
            return decomposed_p_[static_cast<std::size_t>(places[0])];
        double const part = sum_of_squares(places);
        if (exact_)
            return part <= rounding_ ? 1 : 0;
        auto const count = static_cast<double>(places.size());
        return f_p_value(part / count / (residual_ / degrees_), count, degrees_);
    }
    void leave_out(std::vector<Index> const& places)
    {
        residual_ += sum_of_squares(places);
        degrees_ += static_cast<int>(places.size());
        MatrixXd const across = covariance_(Eigen::all, places);
        MatrixXd const gain =
            MatrixXd(covariance_(places, places)).ldlt().solve(MatrixXd(across.transpose())).transpose();
        values_ -= gain * values_(places);
        covariance_ -= gain * across.transpose();
        std::vector<Index> kept;
        for (Index t = 0; t < values_.size(); ++t)
            if (std::find(places.begin(), places.end(), t) == places.end())
                kept.push_back(t);
        values_ = VectorXd(values_(kept));
        covariance_ = MatrixXd(covariance_(kept, kept));
        for (auto place = places.rbegin(); place != places.rend(); ++place) {
            terms_.erase(terms_.begin() + *place);
            by_factor_.erase(by_factor_.begin() + *place);
        }
        decomposed_p_.assign(terms_.size(), std::numeric_limits<double>::quiet_NaN());
    }

  private:
    //! By which the residual's would grow without these terms.
    double sum_of_squares(std::vector<Index> const& places) const
    {
        VectorXd const own = values_(places);
        return own.dot(VectorXd(MatrixXd(covariance_(places, places)).ldlt().solve(own)));
    }

    bool exact_;
    double rounding_;
    std::vector<Term> terms_, by_factor_;
    std::vector<double> decomposed_p_; //!< NaN where the fit was updated
    VectorXd values_;
    MatrixXd covariance_; //!< over the residual variance
    double residual_;
    int degrees_;
};

//! The least significant terms that may go and their p; none when all have to stay.
std::pair<std::vector<Index>, double> weakest_of(ShrinkingFit const& fit, EliminationOptions const& options)
{
    struct Candidate
    {
        std::vector<Index> places;
        double p;
    };
    std::vector<Candidate> candidates;
    for (std::size_t t = 0; t < fit.terms().size(); ++t) {
        auto places = fit.together_with(t);
        if (places.front() != static_cast<Index>(t))
            continue;
        if (double const p = fit.p(places); p > options.alpha)
            candidates.push_back({std::move(places), p});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](auto const& a, auto const& b) { return a.p > b.p; });
    for (auto& candidate : candidates)
        if (fit.may_go(static_cast<std::size_t>(candidate.places.front()), options))
            return {std::move(candidate.places), candidate.p};
    return {};
}

} // namespace

ReducedRegression eliminate_backward(RegressionData const& data, std::vector<Term> const& terms,
                                     EliminationOptions const& options)
{
    ReducedRegression reduced{Regression(data, terms), {}};
    if (reduced.regression.residual_degrees_of_freedom() < 1)
        throw InputError(
            fmt::format("response `{}`: {} runs leave nothing to test {} coefficients against: add runs or "
                        "take a smaller model",
                        data.response, data.values.size(), terms.size()));
    ShrinkingFit fit(data, reduced.regression);
    for (int updates = 0;;) {
        auto const [places, p] = weakest_of(fit, options);
        if (places.empty() && updates == 0)
            return reduced;
        for (Index const place : places)
            reduced.eliminated.push_back({fit.terms()[static_cast<std::size_t>(place)], p});
        if (!places.empty())
            fit.leave_out(places);
        if (places.empty() || fit.terms().size() <= small || ++updates == steps_by_update) {
            reduced.regression = Regression(data, fit.terms());
            fit = ShrinkingFit(data, reduced.regression);
            updates = 0;
        }
    }
}

} // namespace demens::tao_calib
