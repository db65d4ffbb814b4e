#include "tao_calib/unit_cube.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;
using ensemble::Factor;

constexpr int inside_samples = 500;
constexpr int level_samples = 2000;
constexpr int most_level_choices = 12; // discrete factors whose two nearest levels are combined

std::vector<int> free_of(VectorXd const& fixed)
{
    std::vector<int> free;
    for (int k = 0; k < fixed.size(); ++k)
        if (std::isnan(fixed[k]))
            free.push_back(k);
    return free;
}

//! The free factors and what the constraints leave to them.
FactorSpace free_space(std::vector<Factor> const& factors,
                       std::vector<ensemble::LinearConstraint> const& constraints, VectorXd const& fixed)
{
    auto const free = free_of(fixed);
    std::vector<Factor> left;
    for (int k : free)
        left.push_back(factors[k]);
    std::vector<ensemble::LinearConstraint> between;
    for (auto const& constraint : constraints) {
        ensemble::LinearConstraint rest{constraint.text, {}, constraint.bound};
        bool binds = false;
        for (std::size_t k = 0; k < factors.size(); ++k) {
            double const value = fixed[static_cast<Eigen::Index>(k)],
                         coefficient = constraint.coefficients[k];
            if (std::isnan(value)) {
                rest.coefficients.push_back(coefficient);
                binds = binds || coefficient != 0;
            } else
                rest.bound -= coefficient * value;
        }
        if (binds)
            between.push_back(std::move(rest));
    }
    return {left, between};
}

double to_unit(Factor const& factor, double value)
{
    return factor.log_scale ? std::log(value / factor.lower) / std::log(factor.upper / factor.lower)
                            : (value - factor.lower) / (factor.upper - factor.lower);
}

double to_value(Factor const& factor, double unit)
{
    double const value = factor.log_scale ? factor.lower * std::pow(factor.upper / factor.lower, unit)
                                          : (1 - unit) * factor.lower + unit * factor.upper;
    return std::clamp(value, factor.lower, factor.upper);
}

//! Shares of the ranges, linear in the factors also where their scale is logarithmic: constraints are
//! straight here.
VectorXd to_shares(std::vector<Factor> const& factors, VectorXd const& values)
{
    VectorXd shares(values.size());
    for (Eigen::Index k = 0; k < values.size(); ++k)
        shares[k] = (values[k] - factors[k].lower) / (factors[k].upper - factors[k].lower);
    return shares;
}

VectorXd from_shares(std::vector<Factor> const& factors, VectorXd const& shares)
{
    VectorXd values(shares.size());
    for (Eigen::Index k = 0; k < shares.size(); ++k)
        values[k] = std::clamp((1 - shares[k]) * factors[k].lower + shares[k] * factors[k].upper,
                               factors[k].lower, factors[k].upper);
    return values;
}

//! normal . shares <= bound
struct HalfSpace
{
    VectorXd normal;
    double bound;
};

//! The constraint as far as the free factors can meet it.
HalfSpace in_free_shares(std::vector<Factor> const& factors, ensemble::LinearConstraint const& constraint,
                         VectorXd const& fixed)
{
    HalfSpace half{VectorXd::Zero(static_cast<Eigen::Index>(factors.size())), constraint.bound};
    for (std::size_t k = 0; k < factors.size(); ++k) {
        if (double const value = fixed[static_cast<Eigen::Index>(k)]; !std::isnan(value)) {
            half.bound -= constraint.coefficients[k] * value;
            continue;
        }
        half.normal[k] = constraint.coefficients[k] * (factors[k].upper - factors[k].lower);
        half.bound -= constraint.coefficients[k] * factors[k].lower;
    }
    return half;
}

//! Nearest point of the box [0,1]^k within all half spaces, but for rounding (Boyle and Dykstra 1986).
VectorXd nearest(VectorXd point, std::vector<HalfSpace> const& halves)
{
    constexpr int most_rounds = 2000;
    std::vector<VectorXd> corrections(halves.size() + 1, VectorXd::Zero(point.size()));
    for (int round = 0; round < most_rounds; ++round) {
        VectorXd const before = point;
        for (std::size_t s = 0; s <= halves.size(); ++s) {
            VectorXd const shifted = point + corrections[s];
            if (s == halves.size())
                point = shifted.cwiseMax(0).cwiseMin(1);
            else {
                double const excess = halves[s].normal.dot(shifted) - halves[s].bound;
                point = excess > 0
                            ? VectorXd(shifted - halves[s].normal * (excess / halves[s].normal.squaredNorm()))
                            : shifted;
            }
            corrections[s] = shifted - point;
        }
        if ((point - before).lpNorm<Eigen::Infinity>() < 1e-15)
            break;
    }
    return point;
}

} // namespace

UnitCube::UnitCube(std::vector<Factor> factors, std::vector<ensemble::LinearConstraint> constraints,
                   std::vector<double> const& fixed)
    : factors_(std::move(factors)), constraints_(std::move(constraints)),
      fixed_(fixed.empty() ? VectorXd::Constant(size(), std::numeric_limits<double>::quiet_NaN())
                           : VectorXd(VectorXd::Map(fixed.data(), size()))),
      free_(free_of(fixed_)), space_(free_space(factors_, constraints_, fixed_))
{
    inside_ = VectorXd::Constant(size(), 0.5);
    if (!constrained())
        return;
    inside_.setZero(); // the mean of feasible points is inside, since the region is convex in the factors
    RandomStream random(0);
    for (int i = 0; i < inside_samples; ++i)
        inside_ += to_shares(factors_, completed(space_.own_units(space_.sample(random)))) / inside_samples;
}

UnitCube UnitCube::with_fixed(int factor, double unit) const
{
    std::vector<double> fixed(fixed_.begin(), fixed_.end());
    fixed[static_cast<std::size_t>(factor)] = to_value(factors_[static_cast<std::size_t>(factor)], unit);
    return {factors_, constraints_, fixed};
}

VectorXd UnitCube::completed(VectorXd const& free_values) const
{
    VectorXd values = fixed_;
    values(free_) = free_values;
    return values;
}

Eigen::MatrixXd UnitCube::whole_points(Eigen::MatrixXd const& free_points) const
{
    Eigen::MatrixXd points(free_points.rows(), size());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        points.row(i) = completed(free_points.row(i).transpose()).transpose();
    return points;
}

VectorXd UnitCube::pinned(VectorXd unit) const
{
    for (int k = 0; k < size(); ++k)
        if (!is_free(k))
            unit[k] = tao_calib::to_unit(factors_[k], fixed_[k]);
    return unit;
}

VectorXd UnitCube::to_unit(VectorXd const& values) const
{
    VectorXd unit(size());
    for (int k = 0; k < size(); ++k)
        unit[k] = std::clamp(tao_calib::to_unit(factors_[k], values[k]), 0.0, 1.0);
    return unit;
}

VectorXd UnitCube::to_values(VectorXd const& unit) const
{
    VectorXd values(size());
    for (int k = 0; k < size(); ++k)
        values[k] = is_free(k) ? to_value(factors_[k], unit[k]) : fixed_[k];
    return values;
}

bool UnitCube::feasible(VectorXd const& values) const
{
    for (int k = 0; k < size(); ++k)
        if (!(values[k] >= factors_[k].lower && values[k] <= factors_[k].upper))
            return false;
    return std::all_of(constraints_.begin(), constraints_.end(), [&](auto const& constraint) {
        double sum = 0;
        for (int k = 0; k < size(); ++k)
            sum += constraint.coefficients[k] * values[k];
        return sum <= constraint.bound;
    });
}

VectorXd UnitCube::project(VectorXd const& unit) const
{
    VectorXd const clamped = pinned(unit.cwiseMax(0).cwiseMin(1));
    if (!constrained() || feasible(to_values(clamped)))
        return clamped;
    std::vector<HalfSpace> halves;
    for (auto const& constraint : constraints_)
        if (auto half = in_free_shares(factors_, constraint, fixed_); !half.normal.isZero())
            halves.push_back(std::move(half));
    VectorXd const shares = nearest(to_shares(factors_, to_values(clamped)), halves);
    // The nearest point is on the edge but for rounding: the smallest step inwards that the exact check
    // accepts.
    VectorXd inwards = to_unit(from_shares(factors_, shares));
    for (double step = 1e-16; step < 1 && !feasible(to_values(inwards)); step *= 4)
        inwards = to_unit(from_shares(factors_, shares + step * (inside_ - shares)));
    return feasible(to_values(inwards)) ? inwards : to_unit(from_shares(factors_, inside_));
}

VectorXd UnitCube::sample(RandomStream& random) const
{
    auto whole = [&](VectorXd const& free) {
        VectorXd unit = VectorXd::Zero(size());
        unit(free_) = free;
        return pinned(unit);
    };
    VectorXd const unit = whole(
        space_.sample_where([&](VectorXd const& free) { return feasible(to_values(whole(free))); }, random));
    return feasible(to_values(unit)) ? unit : to_unit(from_shares(factors_, inside_));
}

//! The feasible combination of the nearest levels below and above that is nearest to `values`.
VectorXd UnitCube::on_levels(VectorXd const& values) const
{
    std::vector<int> discrete;
    for (int k = 0; k < size(); ++k)
        if (!factors_[k].levels.empty() && is_free(k))
            discrete.push_back(k);
    if (discrete.empty())
        return values;

    VectorXd const wanted = to_unit(values);
    VectorXd best;
    double best_distance = std::numeric_limits<double>::infinity();
    auto consider = [&](VectorXd const& candidate) {
        double const distance = (to_unit(candidate) - wanted).squaredNorm();
        if (distance < best_distance && feasible(candidate))
            best = candidate, best_distance = distance;
    };
    int const choices = std::min<int>(static_cast<int>(discrete.size()), most_level_choices);
    for (unsigned choice = 0; choice < (1u << choices); ++choice) {
        VectorXd candidate = values;
        for (std::size_t d = 0; d < discrete.size(); ++d) {
            auto const& levels = factors_[discrete[d]].levels;
            auto upper = std::lower_bound(levels.begin(), levels.end(), values[discrete[d]]);
            bool const below = static_cast<int>(d) < choices && (choice >> d & 1u);
            if (upper == levels.end() || (below && upper != levels.begin()))
                --upper;
            candidate[discrete[d]] = *upper;
        }
        consider(candidate);
    }
    RandomStream random(0);
    for (int i = 0; i < level_samples && best.size() == 0; ++i)
        consider(completed(space_.own_units(space_.sample(random))));
    return best;
}

std::vector<double> UnitCube::to_design_point(VectorXd const& unit) const
{
    VectorXd const values = on_levels(to_values(project(unit)));
    return {values.data(), values.data() + values.size()};
}

} // namespace demens::tao_calib
