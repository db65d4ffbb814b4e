#include "src/dem/cpu/contact_block.hpp"

namespace demens::dem {
namespace {

template <contact::Partner partner>
DEMENS_MULTIVERSION bool geometry_stage(ContactBlock& b, double overlap_limit)
{
    double excess[ContactBlock::lanes]; // of the overlap over its limit [m]
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        contact::Meeting const meeting = meeting_of(b, l);
        contact::ContactGeometry const g = contact::geometry_of<partner>(meeting);
        b.nx[l] = g.normal.x, b.ny[l] = g.normal.y, b.nz[l] = g.normal.z;
        b.overlap[l] = g.overlap;
        b.gap[l] = g.gap;
        b.arm_i[l] = g.arm_i, b.arm_j[l] = g.arm_j;
        b.normal_velocity[l] = g.normal_velocity;
        b.tx[l] = g.tangent_velocity.x, b.ty[l] = g.tangent_velocity.y, b.tz[l] = g.tangent_velocity.z;
        b.effective_radius[l] = g.effective_radius;
        b.contact_radius[l] = g.contact_radius;
        b.effective_mass[l] = g.effective_mass;
        b.damping_scale[l] = g.damping_scale;
        b.mx[l] = b.my[l] = b.mz[l] = 0;
        excess[l] = contact::overlap_excess(meeting, g.overlap, overlap_limit);
    }
    double most = -1;
    for (int l = 0; l < padded; ++l)
        most = excess[l] > most ? excess[l] : most;
    return most > 0;
}

} // namespace

bool derive_geometry(ContactBlock& block, bool with_wall, double overlap_limit)
{
    return with_wall ? geometry_stage<contact::Partner::wall>(block, overlap_limit)
                     : geometry_stage<contact::Partner::sphere>(block, overlap_limit);
}

} // namespace demens::dem
