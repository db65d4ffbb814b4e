#include "tao_calib/design/factor_space.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/design/feasible_region.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

using ensemble::Factor;

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
    find_room();
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
    return sample_where([&](Eigen::VectorXd const& unit) { return feasible(own_units(unit)); }, random);
}

Eigen::VectorXd FactorSpace::sample_where(std::function<bool(Eigen::VectorXd const&)> const& inside,
                                          RandomStream& random) const
{
    if (auto const drawn = rare_ ? std::nullopt : drawn_anywhere(inside, random))
        return *drawn;
    Eigen::VectorXd const corner = corners_[random.below(corners_.size())];
    Eigen::VectorXd const towards = start_ + 0.9 * random.uniform() * (corner - start_);
    return walk(inside(towards) ? towards : start_, corners_, inside, random);
}

std::optional<Eigen::VectorXd>
FactorSpace::drawn_anywhere(std::function<bool(Eigen::VectorXd const&)> const& inside,
                            RandomStream& random) const
{
    constexpr int most_draws = 3000; // a part smaller than one in a thousand is walked through
    Eigen::VectorXd unit(size());
    for (int draw = 0; draw < most_draws; ++draw) {
        for (int k = 0; k < size(); ++k)
            unit[k] = random.uniform();
        if (inside(unit))
            return unit;
    }
    return std::nullopt;
}

namespace {

std::string texts_of(std::vector<ensemble::LinearConstraint> const& constraints)
{
    std::string texts;
    for (auto const& constraint : constraints)
        texts += (texts.empty() ? "`" : ", `") + constraint.text + "`";
    return texts;
}

double to_unit(Factor const& factor, double value)
{
    double const unit = factor.log_scale
                            ? std::log(value / factor.lower) / std::log(factor.upper / factor.lower)
                            : (value - factor.lower) / (factor.upper - factor.lower);
    return std::clamp(unit, 0.0, 1.0);
}

//! A point given in shares of the ranges, in the unit cube.
Eigen::VectorXd in_unit_cube(std::vector<Factor> const& factors, Eigen::VectorXd const& shares)
{
    Eigen::VectorXd unit(shares.size());
    for (Eigen::Index k = 0; k < shares.size(); ++k) {
        auto const& factor = factors[static_cast<std::size_t>(k)];
        unit[k] = to_unit(factor, factor.lower + shares[k] * (factor.upper - factor.lower));
    }
    return unit;
}

} // namespace

void FactorSpace::find_room()
{
    FeasibleRegion const region(factors_, constraints_);
    if (region.is_empty())
        throw InputError(
            fmt::format("no point within the bounds of the factors meets the constraints {}: widen the "
                        "bounds or loosen a constraint",
                        texts_of(constraints_)));
    bool const discrete = std::any_of(factors_.begin(), factors_.end(),
                                      [](auto const& factor) { return !factor.levels.empty(); });
    if (region.is_flat() && !discrete)
        throw InputError(
            fmt::format("the constraints {} leave no room within the bounds of the factors but a surface, "
                        "a line or a point: leave out a factor that the others fix, or loosen a "
                        "constraint",
                        texts_of(constraints_)));
    for (auto const& corner : region.corners())
        corners_.push_back(in_unit_cube(factors_, corner));
    RandomStream random(1);
    rare_ = !drawn_anywhere([&](Eigen::VectorXd const& unit) { return feasible(own_units(unit)); }, random);
    start_ = in_unit_cube(factors_, region.centre());
    if (feasible(own_units(start_)))
        return;
    if (auto const found = point_on_levels())
        start_ = *found;
    else
        throw InputError(fmt::format("no point on the levels and within the bounds of the factors meets the "
                                     "constraints {}: add levels, widen the bounds or loosen a constraint",
                                     texts_of(constraints_)));
}

std::optional<Eigen::VectorXd> FactorSpace::point_on_levels() const
{
    constexpr int most_combinations = 20'000, most_draws = 1'000'000;
    std::vector<int> discrete;
    double combinations = 1;
    for (int k = 0; k < size(); ++k)
        if (auto const count = factors_[static_cast<std::size_t>(k)].levels.size(); count > 0) {
            discrete.push_back(k);
            combinations *= static_cast<double>(count);
        }
    RandomStream random(0);
    if (combinations > most_combinations) {
        for (int draw = 0; draw < most_draws; ++draw) {
            Eigen::VectorXd unit(size());
            for (double& x : unit)
                x = random.uniform();
            if (feasible(own_units(unit)))
                return unit;
        }
        return std::nullopt;
    }
    for (int combination = 0; combination < static_cast<int>(combinations); ++combination) {
        Eigen::VectorXd unit(size());
        std::vector<Factor> left;
        auto between = constraints_;
        for (auto& constraint : between)
            constraint.coefficients.clear();
        int rest = combination;
        for (int k = 0; k < size(); ++k) {
            auto const& factor = factors_[static_cast<std::size_t>(k)];
            auto const count = static_cast<int>(factor.levels.size());
            if (count == 0)
                left.push_back(factor);
            else
                unit[k] = (rest % count + 0.5) / count;
            for (std::size_t c = 0; c < between.size(); ++c) {
                double const coefficient = constraints_[c].coefficients[static_cast<std::size_t>(k)];
                if (count == 0)
                    between[c].coefficients.push_back(coefficient);
                else
                    between[c].bound -= coefficient * factor.levels[static_cast<std::size_t>(rest % count)];
            }
            if (count > 0)
                rest /= count;
        }
        if (!left.empty()) {
            FeasibleRegion const region(left, between);
            if (region.is_empty())
                continue;
            Eigen::VectorXd const others = in_unit_cube(left, region.centre());
            for (int k = 0, next = 0; k < size(); ++k)
                if (factors_[static_cast<std::size_t>(k)].levels.empty())
                    unit[k] = others[next++];
        }
        if (feasible(own_units(unit)))
            return unit;
    }
    return std::nullopt;
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
