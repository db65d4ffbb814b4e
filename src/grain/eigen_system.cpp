#include "src/grain/eigen_system.hpp"

#include <algorithm>
#include <cmath>

namespace demens::grain {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

//! Makes a[p][q] zero by a turn in the plane of p and q (Golub & Van Loan, section 8.5).
void turn(Matrix& a, Matrix& vectors, std::size_t p, std::size_t q)
{
    if (a[p][q] == 0)
        return;
    double const tau = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double const t = std::copysign(1 / (std::abs(tau) + std::sqrt(1 + tau * tau)), tau);
    double const c = 1 / std::sqrt(1 + t * t), s = t * c;
    for (std::size_t k = 0; k < 3; ++k) {
        double const kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq;
        a[k][q] = s * kp + c * kq;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        double const pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk;
        a[q][k] = s * pk + c * qk;
    }
    a[p][q] = a[q][p] = 0;
    for (auto& row : vectors) {
        double const kp = row[p], kq = row[q];
        row[p] = c * kp - s * kq;
        row[q] = s * kp + c * kq;
    }
}

} // namespace

EigenSystem eigen_system(SymmetricTensor const& t)
{
    Matrix a = {{{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}};
    Matrix vectors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    double const scale =
        std::abs(t.xx) + std::abs(t.yy) + std::abs(t.zz) + std::abs(t.xy) + std::abs(t.xz) + std::abs(t.yz);
    constexpr int most_sweeps = 30; // convergence is quadratic: five or six are enough
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        if (std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]) <= 1e-18 * scale)
            break;
        turn(a, vectors, 0, 1);
        turn(a, vectors, 0, 2);
        turn(a, vectors, 1, 2);
    }
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return a[i][i] < a[j][j]; });
    EigenSystem system{};
    for (std::size_t k = 0; k < 3; ++k) {
        system.values[k] = a[order[k]][order[k]];
        system.vectors[k] = {vectors[0][order[k]], vectors[1][order[k]], vectors[2][order[k]]};
    }
    system.vectors[2] = cross(system.vectors[0], system.vectors[1]);
    return system;
}

} // namespace demens::grain
