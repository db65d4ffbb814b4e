#include "demens/dem/contact_block.hpp"

namespace demens::dem {
namespace {

using contact::ContactKinematics;
using contact::NoLaw;
using contact::NormalResponse;
constexpr int lanes = ContactBlock::lanes;

//! What the formulas read, from lane l.
DEMENS_INLINE ContactKinematics kinematics(ContactBlock const& b, int l, double time_step)
{
    return {.normal = {b.nx[l], b.ny[l], b.nz[l]},
            .overlap = b.overlap[l],
            .radius_i = b.radius_i[l],
            .radius_j = b.radius_j[l],
            .effective_radius = b.effective_radius[l],
            .effective_mass = b.effective_mass[l],
            .rolling_inertia = b.rolling_inertia[l],
            .normal_velocity = b.normal_velocity[l],
            .tangent_velocity = {b.tx[l], b.ty[l], b.tz[l]},
            .relative_spin = {b.wix[l] - b.wjx[l], b.wiy[l] - b.wjy[l], b.wiz[l] - b.wjz[l]},
            .time_step = time_step};
}

template <int n>
DEMENS_INLINE void load_scalars(ContactBlock const& b, int first, int l, double (&scalars)[n + 1])
{
    for (int k = 0; k < n; ++k)
        scalars[k] = b.state[first + k][l];
}

template <int n>
DEMENS_INLINE void store_scalars(ContactBlock& b, int first, int l, double const (&scalars)[n + 1])
{
    for (int k = 0; k < n; ++k)
        b.state[first + k][l] = scalars[k];
}

template <class Law>
DEMENS_MULTIVERSION void normal_stage(ContactBlock& b, Law const law, double time_step)
{
    constexpr int n = Law::state_scalars;
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        double scalars[n + 1];
        load_scalars<n>(b, 0, l, scalars);
        NormalResponse const response = law(kinematics(b, l, time_step), scalars);
        store_scalars<n>(b, 0, l, scalars);
        b.normal_force[l] = response.force;
        b.limit[l] = response.limit;
        b.stiffness[l] = response.stiffness;
        b.fx[l] = response.force * b.nx[l];
        b.fy[l] = response.force * b.ny[l];
        b.fz[l] = response.force * b.nz[l];
    }
}

template <class Law>
DEMENS_MULTIVERSION void tangential_stage(ContactBlock& b, Law const law, double time_step, int scalars_at,
                                          int vector_at)
{
    constexpr int n = Law::state_scalars;
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        double scalars[n + 1];
        load_scalars<n>(b, scalars_at, l, scalars);
        Vector3 stored{b.state[vector_at][l], b.state[vector_at + 1][l], b.state[vector_at + 2][l]};
        Vector3 const force = law(kinematics(b, l, time_step),
                                  {b.normal_force[l], b.limit[l], b.stiffness[l]}, scalars, &stored);
        store_scalars<n>(b, scalars_at, l, scalars);
        b.state[vector_at][l] = stored.x;
        b.state[vector_at + 1][l] = stored.y;
        b.state[vector_at + 2][l] = stored.z;
        b.fx[l] += force.x;
        b.fy[l] += force.y;
        b.fz[l] += force.z;
    }
}

template <class Law>
DEMENS_MULTIVERSION void rolling_stage(ContactBlock& b, Law const law, double time_step, int vector_at)
{
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        Vector3 stored;
        if constexpr (Law::state_vectors > 0)
            stored = {b.state[vector_at][l], b.state[vector_at + 1][l], b.state[vector_at + 2][l]};
        Vector3 const torque =
            law(kinematics(b, l, time_step), {b.normal_force[l], b.limit[l], b.stiffness[l]}, &stored);
        if constexpr (Law::state_vectors > 0) {
            b.state[vector_at][l] = stored.x;
            b.state[vector_at + 1][l] = stored.y;
            b.state[vector_at + 2][l] = stored.z;
        }
        b.mx[l] = torque.x;
        b.my[l] = torque.y;
        b.mz[l] = torque.z;
    }
}

template <class Law>
constexpr int scalars_of()
{
    if constexpr (requires { Law::state_scalars; })
        return Law::state_scalars;
    else
        return 0;
}

template <class Law>
constexpr int vectors_of()
{
    if constexpr (requires { Law::state_vectors; })
        return Law::state_vectors;
    else
        return 0;
}

template <class Any>
int scalars_of_any(Any const& any)
{
    return std::visit([]<class Law>(Law const&) { return scalars_of<Law>(); }, any);
}

template <class Any>
int vectors_of_any(Any const& any)
{
    return std::visit([]<class Law>(Law const&) { return vectors_of<Law>(); }, any);
}

//! Torques: the force acts at the contact point, -arm_i n from i and arm_j n from j.
DEMENS_MULTIVERSION void torque_stage(ContactBlock& b)
{
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        Vector3 const turning = cross({b.nx[l], b.ny[l], b.nz[l]}, {b.fx[l], b.fy[l], b.fz[l]});
        double const ai = b.arm_i[l], aj = b.arm_j[l];
        b.tix[l] = b.mx[l] - ai * turning.x;
        b.tiy[l] = b.my[l] - ai * turning.y;
        b.tiz[l] = b.mz[l] - ai * turning.z;
        b.tjx[l] = -(b.mx[l] + aj * turning.x);
        b.tjy[l] = -(b.my[l] + aj * turning.y);
        b.tjz[l] = -(b.mz[l] + aj * turning.z);
    }
}

} // namespace

StateLayout state_layout(contact::LawSet const& laws)
{
    int const scalars = scalars_of_any(laws.normal) + scalars_of_any(laws.tangential);
    int const size = scalars + 3 * (vectors_of_any(laws.tangential) + vectors_of_any(laws.rolling));
    return {scalars, (size + 3) / 4 * 4};
}

namespace {

template <bool with_wall>
DEMENS_MULTIVERSION double geometry_stage(ContactBlock& b)
{
    // A wall is flat and cannot be moved: it adds neither curvature nor mass, and its point of contact is its
    // own.
    constexpr double partner = with_wall ? 0.0 : 1.0;
    double largest[lanes];
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        double const distance = std::sqrt(b.dx[l] * b.dx[l] + b.dy[l] * b.dy[l] + b.dz[l] * b.dz[l]);
        double const inverse = 1 / distance;
        double const nx = b.dx[l] * inverse, ny = b.dy[l] * inverse, nz = b.dz[l] * inverse;
        double const ri = b.radius_i[l], rj = b.radius_j[l];
        double const overlap = ri + partner * rj - distance;
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
        double const roll_i = 1 / (1.4 * mi * ri * ri);
        double const roll_j = partner / (1.4 * mj * rj * rj);
        b.nx[l] = nx, b.ny[l] = ny, b.nz[l] = nz;
        b.overlap[l] = overlap;
        b.arm_i[l] = arm_i, b.arm_j[l] = arm_j;
        b.normal_velocity[l] = vn;
        b.tx[l] = vx - vn * nx, b.ty[l] = vy - vn * ny, b.tz[l] = vz - vn * nz;
        b.effective_radius[l] = with_wall ? ri : ri * rj / (ri + rj);
        b.effective_mass[l] = with_wall ? mi : mi * mj / (mi + mj);
        b.rolling_inertia[l] = 1 / (roll_i + roll_j);
        b.mx[l] = b.my[l] = b.mz[l] = 0;
        largest[l] = overlap / (ri < rj ? ri : rj);
    }
    double result = 0;
    for (int l = 0; l < padded; ++l)
        result = largest[l] > result ? largest[l] : result;
    return result;
}

} // namespace

double derive_geometry(ContactBlock& block, bool with_wall)
{
    return with_wall ? geometry_stage<true>(block) : geometry_stage<false>(block);
}

void evaluate_laws(ContactBlock& block, contact::LawSet const& laws, double time_step)
{
    int const tangential_scalars_at = scalars_of_any(laws.normal);
    int const tangential_vector_at = tangential_scalars_at + scalars_of_any(laws.tangential);
    int const rolling_vector_at = tangential_vector_at + 3 * vectors_of_any(laws.tangential);

    std::visit([&](auto const& law) { normal_stage(block, law, time_step); }, laws.normal);
    std::visit(
        [&]<class Law>(Law const& law) {
            if constexpr (!std::is_same_v<Law, NoLaw>)
                tangential_stage(block, law, time_step, tangential_scalars_at, tangential_vector_at);
        },
        laws.tangential);
    std::visit(
        [&]<class Law>(Law const& law) {
            if constexpr (!std::is_same_v<Law, NoLaw>)
                rolling_stage(block, law, time_step, rolling_vector_at);
        },
        laws.rolling);
    torque_stage(block);
}

} // namespace demens::dem
