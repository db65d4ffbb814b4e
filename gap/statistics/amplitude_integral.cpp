#include "gap/statistics/amplitude_integral.hpp"

#include "gap/statistics/gaussian.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace demens::gap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

//! A function about a point: value + gradient x - x' precision x / 2.
struct Expansion
{
    double value;
    VectorXd gradient;
    MatrixXd precision;
};

//! By central differences; exact for a quadratic at any step.
template <class Function>
Expansion expand(Function const& f, VectorXd const& at, double step)
{
    auto const count = at.size();
    Expansion found{f(at), VectorXd(count), MatrixXd(count, count)};
    auto shifted = [&](Eigen::Index k, double by) {
        VectorXd x = at;
        x[k] += by;
        return x;
    };
    for (Eigen::Index k = 0; k < count; ++k) {
        double const up = f(shifted(k, step)), down = f(shifted(k, -step));
        found.gradient[k] = (up - down) / (2 * step);
        found.precision(k, k) = (2 * found.value - up - down) / (step * step);
        for (Eigen::Index l = 0; l < k; ++l) {
            auto corner = [&](double a, double b) {
                VectorXd x = shifted(k, a * step);
                x[l] += b * step;
                return f(x);
            };
            found.precision(k, l) = found.precision(l, k) =
                -(corner(1, 1) - corner(1, -1) - corner(-1, 1) + corner(-1, -1)) / (4 * step * step);
        }
    }
    return found;
}

//! The same precision with no eigenvalue below `least`.
MatrixXd at_least(MatrixXd const& precision, double least)
{
    Eigen::SelfAdjointEigenSolver<MatrixXd> const eigen(precision);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(least).asDiagonal() *
           eigen.eigenvectors().transpose();
}

void into_domain(AmplitudeModel const& model, VectorXd& u)
{
    for (Eigen::Index k = 0; k < u.size(); ++k)
        if (model.one_signed(static_cast<int>(k)))
            u[k] = std::max(u[k], 0.0);
}

//! Newton step that keeps amplitudes of one sign at 0 where the slope holds them there.
VectorXd constrained_step(AmplitudeModel const& model, VectorXd const& u, Expansion const& about)
{
    std::vector<int> free;
    for (int k = 0; k < model.effects(); ++k)
        if (!model.one_signed(k) || u[k] > 0 || about.gradient[k] > 0)
            free.push_back(k);
    VectorXd step = VectorXd::Zero(u.size());
    if (!free.empty()) {
        MatrixXd const precision = at_least(about.precision(free, free), 1e-8);
        step(free) = VectorXd(precision.llt().solve(VectorXd(about.gradient(free))));
    }
    return step;
}

constexpr double small_step = 1e-3; // of finite differences, in amplitudes over `typical`

template <class Function>
VectorXd climb(AmplitudeModel const& model, Function const& f, VectorXd u)
{
    double const difference = model.linear() ? 1 : small_step;
    into_domain(model, u);
    for (int round = 0; round < 50; ++round) {
        auto const about = expand(f, u, difference);
        VectorXd const step = constrained_step(model, u, about);
        VectorXd next;
        double length = 1;
        do {
            next = u + length * step;
            into_domain(model, next);
            length /= 2;
        } while (f(next) < about.value && length > 1e-4);
        if (!(f(next) > about.value) || (next - u).norm() < 1e-9 * (1 + u.norm()))
            return f(next) > about.value ? next : u;
        u = next;
    }
    return u;
}

//! A normal distribution truncated to the signs, drawn from one amplitude after the other.
class Proposal
{
  public:
    Proposal(AmplitudeModel const& model, VectorXd mean, MatrixXd const& covariance)
        : model_(model), mean_(std::move(mean)), root_(covariance.llt().matrixL())
    {
    }

    //! The point that belongs to a point of the unit cube.
    VectorXd at(VectorXd const& cube) const
    {
        VectorXd x(mean_.size());
        for (Eigen::Index k = 0; k < x.size(); ++k)
            x[k] = upper_tail_quantile(std::log(cube[k]) + log_room(x, k));
        VectorXd u = mean_ + root_.triangularView<Eigen::Lower>() * x;
        into_domain(model_, u);
        return u;
    }

    double log_density(VectorXd const& u) const
    {
        VectorXd const x = root_.triangularView<Eigen::Lower>().solve(u - mean_);
        double sum = -0.5 * x.squaredNorm();
        for (Eigen::Index k = 0; k < x.size(); ++k)
            sum -= 0.5 * std::log(2 * std::numbers::pi) + std::log(root_(k, k)) + log_room(x, k);
        return sum;
    }

  private:
    //! ln of the probability that amplitude k has its sign, given those before it.
    double log_room(VectorXd const& x, Eigen::Index k) const
    {
        if (!model_.one_signed(static_cast<int>(k)))
            return 0;
        return log_upper_tail(-(mean_[k] + root_.row(k).head(k).dot(x.head(k))) / root_(k, k));
    }

    AmplitudeModel const& model_;
    VectorXd mean_;
    MatrixXd root_;
};

//! Evenly spread over the unit square: multiples of the golden section.
VectorXd cube_point(int point, int points, Eigen::Index dimensions)
{
    VectorXd cube(dimensions);
    cube[0] = (point + 0.5) / points;
    if (dimensions > 1) {
        double const along = 0.5 + point / std::numbers::phi;
        cube[1] = along - std::floor(along);
        cube[1] = std::clamp(cube[1], 0.1 / points, 1 - 0.1 / points);
    }
    return cube;
}

VectorXd in_own_units(AmplitudeModel const& model, VectorXd u)
{
    for (Eigen::Index k = 0; k < u.size(); ++k)
        u[k] *= model.unit(static_cast<int>(k));
    return u;
}

//! ln of likelihood times prior, but for the constants of the prior.
auto log_joint(AmplitudeModel const& model, AmplitudeModel::Data const& data)
{
    return [&](VectorXd const& u) { return model.log_likelihood(data, u) - 0.5 * u.squaredNorm(); };
}

//! Starts from which different modes are reached: where the density may have two, both sides.
template <class Function>
std::vector<VectorXd> modes(AmplitudeModel const& model, Function const& f)
{
    auto const count = static_cast<Eigen::Index>(model.effects());
    std::vector<VectorXd> found{climb(model, f, VectorXd::Constant(count, model.linear() ? 0 : 0.5))};
    if (!model.linear())
        for (double start : {0.0, -0.5, 2.0}) {
            VectorXd const other = climb(model, f, VectorXd::Constant(count, start));
            bool known = false;
            for (auto const& mode : found)
                known = known || (other - mode).norm() < 1e-3 * (1 + mode.norm());
            if (!known)
                found.push_back(other);
        }
    return found;
}

} // namespace

VectorXd best_amplitudes(AmplitudeModel const& model, AmplitudeModel::Data const& data, AmplitudePrior prior)
{
    if (model.effects() == 0)
        return {};
    auto f = [&](VectorXd const& u) {
        double const least = 1e-6; // keeps the amplitude of a signature that is zero
        return prior == AmplitudePrior::typical ? model.log_likelihood(data, u) - 0.5 * u.squaredNorm()
                                                : -0.5 * (model.misfit(data, u) + least * u.squaredNorm());
    };
    auto const found = modes(model, f);
    auto best = found.front();
    for (auto const& mode : found)
        if (f(mode) > f(best))
            best = mode;
    return best;
}

AmplitudePosterior integrate_amplitudes(AmplitudeModel const& model, AmplitudeModel::Data const& data,
                                        int points)
{
    auto const count = static_cast<Eigen::Index>(model.effects());
    if (count == 0)
        return {model.log_likelihood(data, VectorXd()), {}, {}, {}};
    auto const f = log_joint(model, data);
    auto const found = modes(model, f);
    double log_prior = -0.5 * static_cast<double>(count) * std::log(2 * std::numbers::pi);
    int one_signed = 0;
    for (int k = 0; k < count; ++k)
        one_signed += model.one_signed(k);
    log_prior += one_signed * std::numbers::ln2;

    std::vector<Proposal> proposals;
    VectorXd best = found.front();
    for (auto const& mode : found) {
        if (f(mode) > f(best))
            best = mode;
        auto const about = expand(f, mode, model.linear() ? 1 : small_step);
        MatrixXd const precision = at_least(about.precision, 0.5);
        MatrixXd const covariance = precision.inverse();
        VectorXd const mean = mode + covariance * about.gradient;
        if (model.linear() && one_signed == 0) {
            double const volume = -0.5 * std::log((precision / (2 * std::numbers::pi)).determinant());
            return {f(mean) + volume + log_prior, in_own_units(model, mean), in_own_units(model, mean),
                    in_own_units(model, covariance.diagonal().cwiseSqrt()).cwiseAbs()};
        }
        double const wider = model.linear() ? 1 : 1.5; // the true density may have heavier tails
        proposals.emplace_back(model, mean, wider * covariance);
    }

    auto const each = points / static_cast<int>(proposals.size());
    auto const total = each * static_cast<int>(proposals.size());
    VectorXd log_weights(total);
    MatrixXd places(count, total);
    for (int i = 0, place = 0; i < static_cast<int>(proposals.size()); ++i)
        for (int point = 0; point < each; ++point, ++place) {
            VectorXd const u = proposals[i].at(cube_point(point, each, count));
            VectorXd densities(proposals.size());
            for (std::size_t j = 0; j < proposals.size(); ++j)
                densities[static_cast<int>(j)] = proposals[j].log_density(u);
            log_weights[place] =
                f(u) - log_sum_exp(densities) + std::log(static_cast<double>(proposals.size()));
            places.col(place) = u;
        }
    VectorXd const weights = normalised(log_weights);
    VectorXd const mean = places * weights;
    VectorXd const variance = (places.colwise() - mean).cwiseAbs2() * weights;
    return {log_sum_exp(log_weights) - std::log(static_cast<double>(total)) + log_prior,
            in_own_units(model, best), in_own_units(model, mean),
            in_own_units(model, variance.cwiseSqrt()).cwiseAbs()};
}

} // namespace demens::gap
