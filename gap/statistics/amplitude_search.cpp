#include "gap/statistics/amplitude_search.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

namespace demens::gap {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Expansion expand(AmplitudeModel const& model, AmplitudeFunction const& f, VectorXd const& at)
{
    double const step = model.linear() ? 1 : 1e-3;
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

MatrixXd at_least(MatrixXd const& symmetric, double least)
{
    Eigen::SelfAdjointEigenSolver<MatrixXd> const eigen(symmetric);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(least).asDiagonal() *
           eigen.eigenvectors().transpose();
}

namespace {

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

VectorXd climb(AmplitudeModel const& model, AmplitudeFunction const& f, VectorXd u)
{
    into_domain(model, u);
    for (int round = 0; round < 50; ++round) {
        auto const about = expand(model, f, u);
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

} // namespace

AmplitudeFunction log_joint(AmplitudeModel const& model, AmplitudeModel::Data const& data)
{
    return
        [&model, &data](VectorXd const& u) { return model.log_likelihood(data, u) - 0.5 * u.squaredNorm(); };
}

std::vector<VectorXd> modes(AmplitudeModel const& model, AmplitudeFunction const& f)
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

namespace {

AmplitudeFunction goodness(AmplitudeModel const& model, AmplitudeModel::Data const& data,
                           AmplitudePrior prior)
{
    if (prior == AmplitudePrior::typical)
        return log_joint(model, data);
    return [&model, &data](VectorXd const& u) {
        constexpr double least = 1e-6; // keeps the amplitude of a signature that is zero
        return -0.5 * (model.misfit(data, u) + least * u.squaredNorm());
    };
}

} // namespace

VectorXd best_amplitudes(AmplitudeModel const& model, AmplitudeModel::Data const& data, AmplitudePrior prior)
{
    if (model.effects() == 0)
        return {};
    auto const f = goodness(model, data, prior);
    auto const found = modes(model, f);
    return *std::max_element(found.begin(), found.end(),
                             [&](VectorXd const& a, VectorXd const& b) { return f(a) < f(b); });
}

VectorXd best_amplitudes_near(AmplitudeModel const& model, AmplitudeModel::Data const& data,
                              AmplitudePrior prior, VectorXd const& start)
{
    return model.effects() == 0 ? VectorXd() : climb(model, goodness(model, data, prior), start);
}

} // namespace demens::gap
