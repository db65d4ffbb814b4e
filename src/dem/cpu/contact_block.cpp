#include "src/dem/cpu/contact_block.hpp"

#include <cmath>

namespace demens::dem {
namespace {

template <bool with_wall>
DEMENS_MULTIVERSION bool geometry_stage(ContactBlock& b, double overlap_limit)
{
    // A wall is flat and cannot be moved: it adds neither curvature nor mass, and its point of contact is its
    // own.
    constexpr double partner = with_wall ? 0.0 : 1.0;
    double excess[ContactBlock::lanes]; // of the overlap over its limit [m]
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        double const distance = std::sqrt(b.dx[l] * b.dx[l] + b.dy[l] * b.dy[l] + b.dz[l] * b.dz[l]);
        double const inverse = 1 / distance;
        double const nx = b.dx[l] * inverse, ny = b.dy[l] * inverse, nz = b.dz[l] * inverse;
        double const ri = b.radius_i[l], rj = b.radius_j[l];
        double const depth = ri + partner * rj - distance;
        double const overlap = depth > 0 ? depth : 0.0;
        // Two spheres share the overlap, which keeps angular momentum; on a wall the arm is the radius, as in
        // the closed forms of rolling and oblique impact.
        double const arm_i = with_wall ? ri : ri - 0.5 * overlap;
        double const arm_j = partner * (rj - 0.5 * overlap);
        // Relative velocity of the two surfaces at the contact point.
        double const ax = arm_i * b.wix[l] + arm_j * b.wjx[l];
        double const ay = arm_i * b.wiy[l] + arm_j * b.wjy[l];
        double const az = arm_i * b.wiz[l] + arm_j * b.wjz[l];
        double const vx = b.vx[l] - (ay * nz - az * ny);
        double const vy = b.vy[l] - (az * nx - ax * nz);
        double const vz = b.vz[l] - (ax * ny - ay * nx);
        double const vn = vx * nx + vy * ny + vz * nz;
        double const mi = b.mass_i[l], mj = b.mass_j[l];
        double const radius_sum = ri + rj, mass_sum = mi + mj;
        double const per_sums = 1 / (radius_sum * mass_sum); // one division for both
        double const radius = with_wall ? ri : ri * rj * mass_sum * per_sums;
        double const mass = with_wall ? mi : mi * mj * radius_sum * per_sums;
        double const contact_radius = std::sqrt(radius * overlap);
        b.nx[l] = nx, b.ny[l] = ny, b.nz[l] = nz;
        b.overlap[l] = overlap;
        b.gap[l] = overlap - depth;
        b.arm_i[l] = arm_i, b.arm_j[l] = arm_j;
        b.normal_velocity[l] = vn;
        b.tx[l] = vx - vn * nx, b.ty[l] = vy - vn * ny, b.tz[l] = vz - vn * nz;
        b.effective_radius[l] = radius;
        b.contact_radius[l] = contact_radius;
        b.effective_mass[l] = mass;
        b.damping_scale[l] = std::sqrt(mass * contact_radius);
        b.mx[l] = b.my[l] = b.mz[l] = 0;
        excess[l] = overlap - overlap_limit * (ri < rj ? ri : rj);
    }
    double most = -1;
    for (int l = 0; l < padded; ++l)
        most = excess[l] > most ? excess[l] : most;
    return most > 0;
}

} // namespace

bool derive_geometry(ContactBlock& block, bool with_wall, double overlap_limit)
{
    return with_wall ? geometry_stage<true>(block, overlap_limit)
                     : geometry_stage<false>(block, overlap_limit);
}

} // namespace demens::dem
