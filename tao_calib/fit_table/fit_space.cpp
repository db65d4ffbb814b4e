#include "tao_calib/fit_table/fit_space.hpp"

#include "demens/base/error.hpp"
#include "ensemble/input/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::size_t most_choices = 200;

ensemble::Factor factor_of(FitFactor const& factor)
{
    return {factor.column, factor.column, factor.lower, factor.upper, factor.log_scale};
}

std::string without_blanks(std::string text)
{
    std::erase(text, ' ');
    return text;
}

} // namespace

FitSpace::FitSpace(FitInput const& input) : factors_(input.factors)
{
    add_columns(input);
    make_free(input);
    make_choices(input);
}

void FitSpace::add_columns(FitInput const& input)
{
    std::vector<ensemble::Factor> continuous;
    for (int k = 0; k < static_cast<int>(input.factors.size()); ++k) {
        auto const& factor = input.factors[k];
        if (factor.kind == FactorKind::continuous) {
            continuous.push_back(tao_calib::factor_of(factor));
            bool const log = factor.log_scale;
            double const low = log ? std::log(factor.lower) : factor.lower;
            double const slope = 2 / ((log ? std::log(factor.upper) : factor.upper) - low);
            names_.push_back(factor.column);
            codings_.push_back(
                {log ? fmt::format("ln({})", factor.column) : factor.column, -1 - slope * low, slope});
            factor_of_.push_back(k);
            level_of_.push_back(-1);
            terms_.push_back({k, factor.levels.empty() || factor.levels.size() > 2});
            continue;
        }
        for (int level = 1; level < static_cast<int>(factor.levels.size()); ++level) {
            names_.push_back(fmt::format("{}[{}]", factor.column, factor.levels[level]));
            codings_.push_back({names_.back()});
            factor_of_.push_back(k);
            level_of_.push_back(level);
            terms_.push_back({k, false, factor.kind == FactorKind::categorical});
        }
    }
    if (!continuous.empty())
        continuous_.emplace(continuous, std::vector<ensemble::LinearConstraint>{});
}

void FitSpace::make_free(FitInput const& input)
{
    std::vector<ensemble::Factor> free;
    for (auto const& factor : input.factors)
        if (factor.kind == FactorKind::continuous && std::isnan(factor.fixed))
            free.push_back(tao_calib::factor_of(factor));
    std::vector<ensemble::LinearConstraint> left;
    for (auto const& constraint : input.constraints) {
        left.push_back({constraint.text, {}, constraint.bound});
        for (std::size_t k = 0; k < constraint.coefficients.size(); ++k) {
            auto const& factor = input.factors[k];
            if (factor.kind != FactorKind::continuous && constraint.coefficients[k] != 0)
                throw InputError(fmt::format("{}: constraint \"{}\": the levels of `{}` are no numbers",
                                             input.origin, constraint.text, factor.column));
            if (factor.kind == FactorKind::continuous && std::isnan(factor.fixed))
                left.back().coefficients.push_back(constraint.coefficients[k]);
            else if (factor.kind == FactorKind::continuous)
                left.back().bound -= constraint.coefficients[k] * factor.fixed;
        }
    }
    if (!free.empty())
        free_.emplace(free, left);
}

void FitSpace::make_choices(FitInput const& input)
{
    choices_ = {Levels(input.factors.size(), -1)};
    bool any_free = free_.has_value();
    for (std::size_t k = 0; k < input.factors.size(); ++k) {
        auto const& factor = input.factors[k];
        if (factor.kind != FactorKind::categorical)
            continue;
        std::vector<Levels> next;
        for (auto const& choice : choices_)
            for (std::size_t level = 0; level < factor.levels.size(); ++level) {
                if (!factor.fixed_level.empty() && factor.levels[level] != factor.fixed_level)
                    continue;
                next.push_back(choice);
                next.back()[k] = static_cast<int>(level);
            }
        if (next.empty())
            throw InputError(fmt::format("{}: factor `{}`: fixed_level = \"{}\" is not in the table: {}",
                                         input.origin, factor.column, factor.fixed_level,
                                         ensemble::input::suggestion(factor.fixed_level, factor.levels)));
        if (next.size() > most_choices)
            throw InputError(
                fmt::format("{}: the categorical factors have more than {} combinations of levels; give "
                            "some a fixed_level",
                            input.origin, most_choices));
        any_free |= factor.fixed_level.empty();
        choices_ = std::move(next);
    }
    if (!any_free)
        throw InputError(fmt::format("{}: every factor is fixed; leave at least one free", input.origin));
}

VectorXd FitSpace::coded(VectorXd const& values) const
{
    std::vector<double> numbers;
    for (std::size_t k = 0; k < factors_.size(); ++k)
        if (factors_[k].kind == FactorKind::continuous)
            numbers.push_back(values[static_cast<Index>(k)]);
    VectorXd continuous;
    if (continuous_)
        continuous = continuous_->coded(VectorXd::Map(numbers.data(), static_cast<Index>(numbers.size())));
    VectorXd result(static_cast<Index>(names_.size()));
    Index next = 0;
    for (std::size_t c = 0; c < names_.size(); ++c) {
        double const value = values[factor_of_[c]];
        auto& place = result[static_cast<Index>(c)];
        if (level_of_[c] < 0)
            place = continuous[next++];
        else
            place = value == level_of_[c] ? 1 : value == 0 ? -1 : 0;
    }
    return result;
}

VectorXd FitSpace::all_values(VectorXd const& free_values, Levels const& levels) const
{
    VectorXd values(static_cast<Index>(factors_.size()));
    Index next = 0;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
        auto& value = values[static_cast<Index>(k)];
        if (factors_[k].kind == FactorKind::block)
            value = std::numeric_limits<double>::quiet_NaN();
        else if (factors_[k].kind == FactorKind::categorical)
            value = levels.at(k);
        else
            value = std::isnan(factors_[k].fixed) ? free_values[next++] : factors_[k].fixed;
    }
    return values;
}

std::vector<Term> terms_of(FitInput const& input, FitSpace const& space)
{
    auto terms = polynomial_terms(input.model, space.term_columns());
    auto const factors_of = [&](Term const& term) {
        std::vector<std::string> factors; // one for each power
        for (std::size_t c = 0; c < term.exponents.size(); ++c)
            for (int power = 0; power < term.exponents[c]; ++power)
                factors.push_back(without_blanks(input.factors[space.factor_of()[c]].column));
        return factors;
    };
    auto const names_of = [&](Term const& term) {
        auto const f = factors_of(term);
        if (f.size() < 2)
            return f;
        return f[0] == f[1] ? std::vector{f[0] + "^2", f[0] + "*" + f[0]}
                            : std::vector{f[0] + "*" + f[1], f[1] + "*" + f[0]};
    };
    for (auto const& unwanted : input.leave_out) {
        std::vector<std::string> known;
        auto const before = terms.size();
        std::erase_if(terms, [&](Term const& term) {
            auto const names = names_of(term);
            if (!names.empty())
                known.push_back(names.front());
            return std::find(names.begin(), names.end(), without_blanks(unwanted)) != names.end();
        });
        if (terms.size() == before)
            throw InputError(fmt::format("{}: leave_out: there is no term `{}`: {}", input.origin, unwanted,
                                         ensemble::input::suggestion(unwanted, known)));
    }
    return terms;
}

} // namespace demens::tao_calib
