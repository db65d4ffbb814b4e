#include "tao_calib/design/factor_space.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

using ensemble::Factor;

constexpr int max_draws = 1'000'000;
constexpr int middle_samples = 1000;

void check(Factor const& factor)
{
    auto fail = [&](std::string const& what) {
        throw InputError(fmt::format("factor `{}`: {}", factor.path, what));
    };
    if (!(factor.lower < factor.upper))
        fail(fmt::format("lower = {} is not below upper = {}", factor.lower, factor.upper));
    if (factor.log_scale && !(factor.lower > 0))
        fail(fmt::format("a logarithmic scale needs lower > 0, not {}", factor.lower));
    if (!std::is_sorted(factor.levels.begin(), factor.levels.end(), std::less_equal<>()))
        fail("levels have to be in ascending order, each once");
    if (!factor.levels.empty() &&
        (factor.levels.front() < factor.lower || factor.levels.back() > factor.upper))
        fail(fmt::format("levels {} to {} leave the bounds {} to {}", factor.levels.front(),
                         factor.levels.back(), factor.lower, factor.upper));
}

double value_at(Factor const& factor, double unit)
{
    if (!factor.levels.empty()) {
        auto const count = static_cast<double>(factor.levels.size());
        double const place = std::clamp(std::floor(unit * count), 0.0, count - 1);
        return factor.levels[static_cast<std::size_t>(place)];
    }
    double const value = factor.log_scale ? factor.lower * std::pow(factor.upper / factor.lower, unit)
                                          : (1 - unit) * factor.lower + unit * factor.upper;
    return std::clamp(value, factor.lower, factor.upper);
}

bool holds(ensemble::LinearConstraint const& constraint, Eigen::VectorXd const& values)
{
    double sum = 0, magnitude = std::abs(constraint.bound);
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        sum += constraint.coefficients[k] * values[k];
        magnitude += std::abs(constraint.coefficients[k] * values[k]);
    }
    return sum <= constraint.bound + 1e-14 * magnitude; // but for the rounding of the sum
}

bool within_bounds(Factor const& factor, double value)
{
    return value >= factor.lower && value <= factor.upper;
}

} // namespace

FactorSpace::FactorSpace(std::vector<Factor> factors, std::vector<ensemble::LinearConstraint> constraints)
    : factors_(std::move(factors)), constraints_(std::move(constraints))
{
    if (factors_.empty())
        throw InputError("a design needs at least one [[factor]]");
    for (auto const& factor : factors_)
        check(factor);
    for (auto const& constraint : constraints_)
        if (constraint.coefficients.size() != factors_.size())
            throw InputError(fmt::format("constraint `{}` has {} coefficients for {} factors",
                                         constraint.text, constraint.coefficients.size(), factors_.size()));

    middle_ = Eigen::VectorXd::Constant(size(), 0.5);
    if (!constrained())
        return;
    RandomStream random(0);
    std::vector<Eigen::VectorXd> samples;
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(size());
    for (int i = 0; i < middle_samples; ++i) {
        samples.push_back(sample(random));
        mean += samples.back() / middle_samples;
    }
    // Logarithmic or discrete factors can bend the region so that its mean is outside: then the sample
    // nearest to it.
    middle_ = feasible(own_units(mean))
                  ? mean
                  : *std::min_element(samples.begin(), samples.end(), [&](auto const& a, auto const& b) {
                        return (a - mean).squaredNorm() < (b - mean).squaredNorm();
                    });
}

Eigen::VectorXd FactorSpace::own_units(Eigen::VectorXd const& unit) const
{
    Eigen::VectorXd values(size());
    for (int k = 0; k < size(); ++k)
        values[k] = value_at(factors_[k], unit[k]);
    return values;
}

Eigen::MatrixXd FactorSpace::own_units_of_rows(Eigen::MatrixXd const& unit) const
{
    Eigen::MatrixXd values(unit.rows(), size());
    for (Eigen::Index i = 0; i < unit.rows(); ++i)
        values.row(i) = own_units(unit.row(i).transpose()).transpose();
    return values;
}

Eigen::VectorXd FactorSpace::coded(Eigen::VectorXd const& values) const
{
    Eigen::VectorXd result(size());
    for (int k = 0; k < size(); ++k) {
        auto const& factor = factors_[k];
        double const share = factor.log_scale
                                 ? std::log(values[k] / factor.lower) / std::log(factor.upper / factor.lower)
                                 : (values[k] - factor.lower) / (factor.upper - factor.lower);
        result[k] = 2 * share - 1;
    }
    return result;
}

bool FactorSpace::feasible(Eigen::VectorXd const& values) const
{
    for (int k = 0; k < size(); ++k)
        if (!within_bounds(factors_[k], values[k]))
            return false;
    return std::all_of(constraints_.begin(), constraints_.end(),
                       [&](auto const& constraint) { return holds(constraint, values); });
}

std::string FactorSpace::violation(Eigen::VectorXd const& values) const
{
    for (int k = 0; k < size(); ++k)
        if (!within_bounds(factors_[k], values[k]))
            return fmt::format("{} = {} is outside its bounds {} to {}", factors_[k].name, values[k],
                               factors_[k].lower, factors_[k].upper);
    for (auto const& constraint : constraints_)
        if (!holds(constraint, values))
            return fmt::format("`{}` does not hold", constraint.text);
    return {};
}

Eigen::VectorXd FactorSpace::sample(RandomStream& random) const
{
    Eigen::VectorXd unit(size());
    for (int draw = 0; draw < max_draws; ++draw) {
        for (int k = 0; k < size(); ++k)
            unit[k] = random.uniform();
        if (feasible(own_units(unit)))
            return unit;
    }
    std::string texts;
    for (auto const& constraint : constraints_)
        texts += (texts.empty() ? "`" : ", `") + constraint.text + "`";
    throw InputError(
        fmt::format("no point within the bounds of the factors meets the constraints {} ({} random points "
                    "tried): widen the bounds or loosen a constraint",
                    texts, max_draws));
}

std::optional<Eigen::VectorXd> FactorSpace::pulled_inside(Eigen::VectorXd const& unit) const
{
    if (feasible(own_units(unit)))
        return unit;
    double inside = 0, outside = 1;
    auto at = [&](double share) { return Eigen::VectorXd(middle_ + share * (unit - middle_)); };
    if (!feasible(own_units(at(inside))))
        return std::nullopt;
    while (outside - inside > 1e-12) {
        double const half = 0.5 * (inside + outside);
        (feasible(own_units(at(half))) ? inside : outside) = half;
    }
    return at(inside);
}

} // namespace demens::tao_calib
