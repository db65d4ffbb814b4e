#include "src/dem/cpu/law_stages.hpp"

#include <type_traits>

namespace demens::dem {
namespace {

using contact::ContactKinematics;
using contact::NoLaw;
using contact::NormalResponse;

// How much history a law needs, and how much the ledger adds: it compares forces and stored energies with
// those of the step before. A law whose history is its own load need not keep that twice.

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

template <class Law>
constexpr bool history_is_load()
{
    if constexpr (requires { Law::history_is_load; })
        return Law::history_is_load;
    else
        return false;
}

template <class Law>
constexpr bool has_dashpot()
{
    if constexpr (requires { Law::has_dashpot; })
        return Law::has_dashpot;
    else
        return false;
}

template <class Law>
constexpr int ledger_vectors_of_tangential()
{
    return (history_is_load<Law>() ? 0 : 1) + (has_dashpot<Law>() ? 1 : 0);
}
template <class Law>
constexpr int ledger_vectors_of_rolling()
{
    return history_is_load<Law>() && !has_dashpot<Law>() ? 0 : 1;
}

//! Of two bodies that roll on each other, about the contact point [kg m^2].
DEMENS_INLINE double rolling_inertia(ContactBlock const& b, int l)
{
    double const i = 1.4 * b.mass_i[l] * b.radius_i[l] * b.radius_i[l];
    double const j = 1.4 * b.mass_j[l] * b.radius_j[l] * b.radius_j[l];
    return i / (1 + i / j); // a wall's mass is beyond any other
}

//! What the formulas read, from lane l.
DEMENS_INLINE ContactKinematics kinematics(ContactBlock const& b, int l, double time_step)
{
    return {.normal = {b.nx[l], b.ny[l], b.nz[l]},
            .overlap = b.overlap[l],
            .gap = b.gap[l],
            .radius_i = b.radius_i[l],
            .radius_j = b.radius_j[l],
            .effective_radius = b.effective_radius[l],
            .contact_radius = b.contact_radius[l],
            .effective_mass = b.effective_mass[l],
            .damping_scale = b.damping_scale[l],
            .rolling_inertia = rolling_inertia(b, l),
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

DEMENS_INLINE Vector3 load_vector(ContactBlock const& b, int first, int l)
{
    return {b.state[first][l], b.state[first + 1][l], b.state[first + 2][l]};
}

DEMENS_INLINE void store_vector(ContactBlock& b, int first, int l, Vector3 const& v)
{
    b.state[first][l] = v.x;
    b.state[first + 1][l] = v.y;
    b.state[first + 2][l] = v.z;
}

//! The old value of a history entry, which becomes the new one.
DEMENS_INLINE double exchange(ContactBlock& b, int at, int l, double value)
{
    double const old = b.state[at][l];
    b.state[at][l] = value;
    return old;
}
DEMENS_INLINE Vector3 exchange(ContactBlock& b, int first, int l, Vector3 const& value)
{
    Vector3 const old = load_vector(b, first, l);
    store_vector(b, first, l, value);
    return old;
}

// Work since the step before: the bodies have moved with the gathered velocities, which are those of the
// middle of the step, under the mean of the old and the new force. That is exactly the change of kinetic
// energy.

template <bool ledger, class Law>
DEMENS_MULTIVERSION void normal_stage(ContactBlock& b, Law const law, double time_step, int scalars_at)
{
    constexpr int n = Law::state_scalars;
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        double scalars[n + 1];
        load_scalars<n>(b, scalars_at, l, scalars);
        NormalResponse const response = law(kinematics(b, l, time_step), scalars);
        store_scalars<n>(b, scalars_at, l, scalars);
        b.limit[l] = response.limit;
        b.stiffness[l] = response.stiffness;
        b.fx[l] = response.force * b.nx[l];
        b.fy[l] = response.force * b.ny[l];
        b.fz[l] = response.force * b.nz[l];
        if constexpr (ledger) {
            double const old_force = exchange(b, scalars_at + n, l, response.inelastic);
            double const old_stored = exchange(b, scalars_at + n + 1, l, response.stored);
            double const given_back = Law::has_potential ? 0.0 : old_stored - response.stored;
            b.lost_to_damping[l] =
                given_back - 0.5 * time_step * b.normal_velocity[l] * (old_force + response.inelastic);
            b.lost_to_friction[l] = b.lost_to_rolling[l] = b.lost_to_cohesion[l] = 0;
        }
    }
}

template <bool ledger, class Law>
DEMENS_MULTIVERSION void cohesion_stage(ContactBlock& b, Law const law, bool in_limit, int scalars_at)
{
    constexpr int n = Law::state_scalars;
    double const share = in_limit ? 1.0 : 0.0;
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        double scalars[n + 1];
        load_scalars<n>(b, scalars_at, l, scalars);
        contact::CohesionResponse const response = law(kinematics(b, l, 0), scalars);
        store_scalars<n>(b, scalars_at, l, scalars);
        double const limit = b.limit[l] + share * response.force;
        b.limit[l] = limit > 0 ? limit : 0.0;
        b.fx[l] += response.force * b.nx[l];
        b.fy[l] += response.force * b.ny[l];
        b.fz[l] += response.force * b.nz[l];
        if constexpr (ledger) {
            b.state[scalars_at + n][l] = response.stored;
            b.lost_to_cohesion[l] = response.lost;
        }
    }
}

template <bool ledger, class Law>
DEMENS_MULTIVERSION void tangential_stage(ContactBlock& b, Law const law, double time_step, int scalars_at,
                                          int vector_at)
{
    constexpr int n = Law::state_scalars;
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        double scalars[n + 1];
        load_scalars<n>(b, scalars_at, l, scalars);
        Vector3 const old_history = load_vector(b, vector_at, l);
        Vector3 history = old_history;
        contact::Resistance const response =
            law(kinematics(b, l, time_step), {.limit = b.limit[l], .stiffness = b.stiffness[l]}, scalars,
                &history);
        store_scalars<n>(b, scalars_at, l, scalars);
        store_vector(b, vector_at, l, history);
        Vector3 const force = response.spring + response.viscous;
        b.fx[l] += force.x;
        b.fy[l] += force.y;
        b.fz[l] += force.z;
        if constexpr (ledger) {
            Vector3 const path = 0.5 * time_step * Vector3{b.tx[l], b.ty[l], b.tz[l]};
            int extra = vector_at + 3;
            if constexpr (has_dashpot<Law>()) {
                b.lost_to_damping[l] -= dot(exchange(b, extra, l, response.viscous) + response.viscous, path);
                extra += 3;
            }
            Vector3 old_spring = old_history;
            if constexpr (!history_is_load<Law>())
                old_spring = exchange(b, extra, l, response.spring);
            double const old_stored = exchange(b, scalars_at + n, l, response.stored);
            b.lost_to_friction[l] = old_stored - response.stored - dot(old_spring + response.spring, path);
        }
    }
}

template <bool ledger, class Law>
DEMENS_MULTIVERSION void rolling_stage(ContactBlock& b, Law const law, double time_step, int scalar_at,
                                       int vector_at)
{
    constexpr int vectors = Law::state_vectors;
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        Vector3 old_history;
        if constexpr (vectors > 0)
            old_history = load_vector(b, vector_at, l);
        Vector3 history = old_history;
        contact::Resistance const response =
            law(kinematics(b, l, time_step), {.limit = b.limit[l], .stiffness = b.stiffness[l]}, &history);
        if constexpr (vectors > 0)
            store_vector(b, vector_at, l, history);
        Vector3 const torque = response.spring + response.viscous;
        b.mx[l] = torque.x;
        b.my[l] = torque.y;
        b.mz[l] = torque.z;
        if constexpr (ledger) {
            Vector3 const turn = 0.5 * time_step * kinematics(b, l, time_step).relative_spin;
            Vector3 old_torque = old_history;
            if constexpr (ledger_vectors_of_rolling<Law>() > 0)
                old_torque = exchange(b, vector_at + 3 * vectors, l, torque);
            double const old_stored = exchange(b, scalar_at, l, response.stored);
            b.lost_to_rolling[l] = old_stored - response.stored - dot(old_torque + torque, turn);
        }
    }
}

template <bool ledger>
void evaluate(ContactBlock& b, contact::LawSet const& laws, StateLayout const& at, double time_step)
{
    std::visit([&](auto const& law) { normal_stage<ledger>(b, law, time_step, at.normal); }, laws.normal);
    std::visit(
        [&]<class Law>(Law const& law) {
            if constexpr (!std::is_same_v<Law, NoLaw>)
                cohesion_stage<ledger>(b, law, laws.cohesion_in_limit, at.cohesion);
        },
        laws.cohesion);
    std::visit(
        [&]<class Law>(Law const& law) {
            if constexpr (!std::is_same_v<Law, NoLaw>)
                tangential_stage<ledger>(b, law, time_step, at.tangential, at.tangential_vector);
        },
        laws.tangential);
    std::visit(
        [&]<class Law>(Law const& law) {
            if constexpr (!std::is_same_v<Law, NoLaw>)
                rolling_stage<ledger>(b, law, time_step, at.rolling, at.rolling_vector);
        },
        laws.rolling);
}

} // namespace

StateLayout state_layout(contact::LawSet const& laws, bool ledger)
{
    StateLayout layout{.ledger = ledger};
    int next = 0;
    auto const place = [&](int& at, int size) {
        at = next;
        next += size;
    };
    std::visit([&]<class Law>(Law const&) { place(layout.normal, scalars_of<Law>() + (ledger ? 2 : 0)); },
               laws.normal);
    auto const place_scalars = [&](int& at, auto const& any) {
        std::visit(
            [&]<class Law>(Law const&) {
                if constexpr (!std::is_same_v<Law, NoLaw>)
                    place(at, scalars_of<Law>() + (ledger ? 1 : 0));
            },
            any);
    };
    place_scalars(layout.cohesion, laws.cohesion);
    place_scalars(layout.tangential, laws.tangential);
    place_scalars(layout.rolling, laws.rolling);
    layout.scalars = next;
    std::visit(
        [&]<class Law>(Law const&) {
            if constexpr (!std::is_same_v<Law, NoLaw>)
                place(layout.tangential_vector,
                      3 * (vectors_of<Law>() + (ledger ? ledger_vectors_of_tangential<Law>() : 0)));
        },
        laws.tangential);
    std::visit(
        [&]<class Law>(Law const&) {
            if constexpr (!std::is_same_v<Law, NoLaw>)
                place(layout.rolling_vector,
                      3 * (vectors_of<Law>() + (ledger ? ledger_vectors_of_rolling<Law>() : 0)));
        },
        laws.rolling);
    layout.size = (next + 3) / 4 * 4;
    return layout;
}

void evaluate_laws(ContactBlock& block, contact::LawSet const& laws, StateLayout const& layout,
                   double time_step)
{
    if (layout.ledger)
        evaluate<true>(block, laws, layout, time_step);
    else
        evaluate<false>(block, laws, layout, time_step);
}

StoredEnergy stored_energy(contact::LawSet const& laws, StateLayout const& layout, double const* state)
{
    auto const after = [&](int at, auto const& any) {
        return std::visit(
            [&]<class Law>(Law const&) {
                if constexpr (std::is_same_v<Law, NoLaw>)
                    return 0.0;
                else
                    return state[at + scalars_of<Law>()];
            },
            any);
    };
    return {.normal = after(layout.normal + 1, laws.normal),
            .tangential = after(layout.tangential, laws.tangential),
            .rolling = after(layout.rolling, laws.rolling),
            .cohesive = after(layout.cohesion, laws.cohesion)};
}

} // namespace demens::dem
