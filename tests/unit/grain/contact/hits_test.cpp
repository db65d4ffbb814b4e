// Two hulls that hit each other without friction or damping: energy, momentum and angular momentum are kept.
#include "demens/grain/rounded_hull.hpp"
#include "tests/unit/grain/contact/numbers.hpp"
#include "tests/unit/grain/contact/posed.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace demens;
using namespace demens::grain;

//! A free rigid body of density 1 in its principal axes.
struct Body
{
    RoundedHull shape;
    MassProperties properties;
    Vector3 place, velocity, spin_momentum; //!< of space
    Quaternion orientation;

    Vector3 spin() const
    {
        Vector3 const l = orientation.inverse(spin_momentum), &i = properties.moments;
        return orientation({l.x / i.x, l.y / i.y, l.z / i.z});
    }
    double energy() const
    {
        return 0.5 * properties.volume * norm_squared(velocity) + 0.5 * dot(spin(), spin_momentum);
    }
};

Body body_of(RoundedHull const& hull)
{
    MassProperties const properties = mass_properties(hull);
    return {in_principal_axes(hull, properties), properties, {}, {}, {}, {}};
}

//! Potential of a contact: k overlap^(5/2) / (5/2), so that the force is Hertz' k overlap^(3/2).
struct Pair
{
    Body a, b;
    double stiffness;
    PairMemory memory = {};
    ContactSet set = {};
    int most_contacts = 0;
    bool cores_met = false;

    //! Half a kick, a drift of both, half a kick.
    void step(double dt)
    {
        kick(0.5 * dt);
        for (Body* body : {&a, &b}) {
            body->place += dt * body->velocity;
            // The spin at the middle of the step.
            Quaternion const middle = quaternion_about(0.5 * dt * body->spin()) * body->orientation;
            Quaternion const start = body->orientation;
            body->orientation = middle;
            body->orientation = (quaternion_about(dt * body->spin()) * start).normalized();
        }
        kick(0.5 * dt);
    }
    double energy() const { return a.energy() + b.energy(); }
    Vector3 angular_momentum() const
    {
        return a.spin_momentum + b.spin_momentum + cross(a.place, a.properties.volume * a.velocity) +
               cross(b.place, b.properties.volume * b.velocity);
    }
    bool is_apart() const { return set.count == 0; }

  private:
    void kick(double dt)
    {
        Rotation const axes = a.orientation.rotation();
        CorePair const pair(CoreView(a.shape.core), {a.place, axes}, CoreView(b.shape.core),
                            {b.place, b.orientation.rotation()});
        hull_contacts(pair, a.shape.rounding, b.shape.rounding, memory, set);
        most_contacts = std::max(most_contacts, set.count);
        cores_met = cores_met || set.state == CoreState::overlapping;
        for (int k = 0; k < set.count; ++k) {
            FeatureContact const& c = set.contacts[k];
            Vector3 const point = axes(c.point) + a.place;
            Vector3 const impulse = (dt * stiffness * c.share * std::pow(c.overlap, 1.5)) * axes(c.normal);
            a.velocity -= impulse / a.properties.volume;
            b.velocity += impulse / b.properties.volume;
            a.spin_momentum -= cross(point - a.place, impulse);
            b.spin_momentum += cross(point - b.place, impulse);
        }
    }
};

// 1,000 hits at random orientations, spins and offsets; the overlap stays below about a tenth of the
// rounding.
TEST(Hits, OfCubesAndTetrahedraKeepEnergyAndMomenta)
{
    Numbers number;
    RoundedHull const cube = rounded(cube_hull(1), 0.05, "cube"),
                      tetrahedron = rounded(tetrahedron_hull(1.6), 0.05, "t");
    int hits = 0, with_several = 0;
    double worst = 0;
    while (hits < 1000) {
        Pair pair{body_of(number() < 0.5 ? cube : tetrahedron), body_of(number() < 0.5 ? cube : tetrahedron),
                  3e4};
        for (Body* body : {&pair.a, &pair.b}) {
            body->orientation = quaternion_of(number.rotation());
            Vector3 const spin = number() * number.direction(), &i = body->properties.moments;
            body->spin_momentum = body->orientation(Vector3{i.x * spin.x, i.y * spin.y, i.z * spin.z});
        }
        Vector3 const way = number.direction();
        pair.b.place = 2.2 * way + 0.4 * number() * number.direction();
        pair.b.velocity = -1.0 * way;
        double const energy = pair.energy();
        Vector3 const momentum = pair.b.properties.volume * pair.b.velocity,
                      turning = pair.angular_momentum();
        double const size = norm(turning) + norm(momentum);
        bool touched = false;
        for (int step = 0; step < 20000; ++step) {
            pair.step(5e-4);
            touched = touched || !pair.is_apart();
            if (touched && pair.is_apart())
                break;
            if (!touched && norm(pair.b.place - pair.a.place) > 3)
                break;
        }
        if (!touched)
            continue;
        ASSERT_TRUE(pair.is_apart());
        ASSERT_FALSE(pair.cores_met);
        ++hits;
        with_several += pair.most_contacts > 1 ? 1 : 0;
        worst = std::max(worst, std::abs(pair.energy() / energy - 1));
        Vector3 const now =
            pair.a.properties.volume * pair.a.velocity + pair.b.properties.volume * pair.b.velocity;
        EXPECT_LT(norm(now - momentum), 1e-12 * size);
        EXPECT_LT(norm(pair.angular_momentum() - turning), 1e-10 * size);
    }
    EXPECT_GT(with_several, 100);
    EXPECT_LT(worst, 1e-4); // 5e-5: the error of the time step, a sixteenth of it for a fourth of the step
}

} // namespace
