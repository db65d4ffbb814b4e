#include "src/dem/cpu/law_stages.hpp"

#include "demens/base/contract.hpp"

namespace demens::dem {
namespace {

using contact::NoLaw;

static_assert(contact::most_state(true) <= ContactBlock::max_state &&
                  contact::most_state(false) <= ContactBlock::max_state,
              "a set of laws keeps more history than a lane of a block has room for");

//! The history of lane l.
struct LaneHistory
{
    ContactBlock& block;
    int l;

    DEMENS_INLINE double& operator[](int k) const { return block.state[k][l]; }
};

//! What the formulas read, from lane l.
DEMENS_INLINE contact::ContactKinematics kinematics(ContactBlock const& b, int l, double time_step)
{
    contact::ContactGeometry const geometry{.normal = {b.nx[l], b.ny[l], b.nz[l]},
                                            .overlap = b.overlap[l],
                                            .gap = b.gap[l],
                                            .arm_i = b.arm_i[l],
                                            .arm_j = b.arm_j[l],
                                            .effective_radius = b.effective_radius[l],
                                            .contact_radius = b.contact_radius[l],
                                            .effective_mass = b.effective_mass[l],
                                            .damping_scale = b.damping_scale[l],
                                            .normal_velocity = b.normal_velocity[l],
                                            .tangent_velocity = {b.tx[l], b.ty[l], b.tz[l]}};
    return contact::kinematics_of(meeting_of(b, l), geometry, time_step);
}

//! What the normal law has made of lane l, as the laws after it read it.
DEMENS_INLINE contact::NormalResponse load(ContactBlock const& b, int l)
{
    return {.limit = b.limit[l], .stiffness = b.stiffness[l]};
}

template <bool ledger, class Law>
DEMENS_MULTIVERSION void run(ContactBlock& b, contact::NormalStage<Law, ledger> const& given,
                             double time_step)
{
    auto const stage = given; // of its own, so that no lane is taken to change it
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        auto const result = stage(kinematics(b, l, time_step), LaneHistory{b, l});
        b.limit[l] = result.response.limit;
        b.stiffness[l] = result.response.stiffness;
        b.fx[l] = result.response.force * b.nx[l];
        b.fy[l] = result.response.force * b.ny[l];
        b.fz[l] = result.response.force * b.nz[l];
        if constexpr (ledger) {
            b.lost_to_damping[l] = result.lost;
            b.lost_to_friction[l] = b.lost_to_rolling[l] = b.lost_to_cohesion[l] = 0;
        }
    }
}

template <bool ledger, class Law>
DEMENS_MULTIVERSION void run(ContactBlock& b, contact::CohesionStage<Law, ledger> const& given,
                             double time_step)
{
    auto const stage = given; // of its own, so that no lane is taken to change it
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        auto const result = stage(kinematics(b, l, time_step), load(b, l), LaneHistory{b, l});
        b.limit[l] = result.limit;
        b.fx[l] += result.force * b.nx[l];
        b.fy[l] += result.force * b.ny[l];
        b.fz[l] += result.force * b.nz[l];
        if constexpr (ledger)
            b.lost_to_cohesion[l] += result.lost;
    }
}

template <bool ledger, class Law>
DEMENS_MULTIVERSION void run(ContactBlock& b, contact::TangentialStage<Law, ledger> const& given,
                             double time_step)
{
    auto const stage = given; // of its own, so that no lane is taken to change it
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        auto const result = stage(kinematics(b, l, time_step), load(b, l), LaneHistory{b, l});
        b.fx[l] += result.force.x;
        b.fy[l] += result.force.y;
        b.fz[l] += result.force.z;
        if constexpr (ledger) {
            b.lost_to_damping[l] += result.lost_in_dashpot;
            b.lost_to_friction[l] = result.lost_in_slip;
        }
    }
}

template <bool ledger, class Law>
DEMENS_MULTIVERSION void run(ContactBlock& b, contact::RollingStage<Law, ledger> const& given,
                             double time_step)
{
    auto const stage = given; // of its own, so that no lane is taken to change it
    int const padded = ContactBlock::padded(b.count);
#pragma GCC ivdep
    for (int l = 0; l < padded; ++l) {
        auto const result = stage(kinematics(b, l, time_step), load(b, l), LaneHistory{b, l});
        b.mx[l] = result.torque.x;
        b.my[l] = result.torque.y;
        b.mz[l] = result.torque.z;
        if constexpr (ledger)
            b.lost_to_rolling[l] = result.lost;
    }
}

template <bool ledger>
void evaluate(ContactBlock& b, contact::LawSet const& laws, contact::StateLayout const& at, double time_step)
{
    laws.normal.visit([&]<class Law>(Law const& law) {
        run(b, contact::NormalStage<Law, ledger>{law, at.normal}, time_step);
    });
    laws.cohesion.visit([&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, NoLaw>)
            run(b, contact::CohesionStage<Law, ledger>{law, at.cohesion, laws.share_in_limit()}, time_step);
    });
    laws.added.visit([&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, NoLaw>)
            run(b, contact::CohesionStage<Law, ledger>{law, at.added, laws.share_in_limit()}, time_step);
    });
    laws.tangential.visit([&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, NoLaw>)
            run(b, contact::TangentialStage<Law, ledger>{law, at.tangential, at.tangential_vector},
                time_step);
    });
    laws.rolling.visit([&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, NoLaw>)
            run(b, contact::RollingStage<Law, ledger>{law, at.rolling, at.rolling_vector}, time_step);
    });
}

} // namespace

void evaluate_laws(ContactBlock& block, contact::LawSet const& laws, contact::StateLayout const& layout,
                   double time_step)
{
    DEMENS_EXPECT(block.count >= 0 && block.count <= ContactBlock::lanes, "a block's contacts fit its lanes");
    DEMENS_EXPECT(layout.size <= ContactBlock::max_state, "a history fits a lane");
    if (layout.ledger)
        evaluate<true>(block, laws, layout, time_step);
    else
        evaluate<false>(block, laws, layout, time_step);
}

} // namespace demens::dem
