#pragma once

#include "demens/base/random.hpp"
#include "demens/contact/laws.hpp"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace demens::parity {

//! What a law reads at one moment of a contact.
struct Moment
{
    contact::ContactKinematics contact;
    contact::NormalResponse normal;
};

constexpr int numbers_per_moment = 7;

//! One contact through all its moments, with its history, as a thread of a device would take it; writes
//! `numbers_per_moment` results a moment.
template <class Law>
DEMENS_FUNCTION void evaluate_law(Law const& law, Moment const* moments, int count, double* results)
{
    double scalars[4] = {};
    Vector3 vectors[1] = {};
    for (int k = 0; k < count; ++k, results += numbers_per_moment) {
        auto const& [contact, normal] = moments[k];
        if constexpr (
            requires { law(contact, normal, scalars, vectors); } ||
            requires { law(contact, normal, vectors); }) {
            contact::Resistance resistance{};
            if constexpr (requires { law(contact, normal, scalars, vectors); })
                resistance = law(contact, normal, scalars, vectors);
            else
                resistance = law(contact, normal, vectors);
            auto const& [spring, viscous, stored] = resistance;
            results[0] = spring.x, results[1] = spring.y, results[2] = spring.z;
            results[3] = viscous.x, results[4] = viscous.y, results[5] = viscous.z;
            results[6] = stored;
        } else {
            auto const response = law(contact, scalars);
            results[0] = response.force, results[1] = response.stored;
            for (int c = 2; c < numbers_per_moment; ++c)
                results[c] = 0;
            if constexpr (requires { response.stiffness; })
                results[2] = response.limit, results[3] = response.stiffness, results[4] = response.inelastic;
            else
                results[2] = response.lost;
        }
    }
}

//! Collisions that load, slide, roll, part to a gap and touch again: `contacts` times `moments`.
inline std::vector<Moment> collisions(int contacts, int moments)
{
    RandomStream random(7);
    std::vector<Moment> result;
    for (int i = 0; i < contacts; ++i) {
        double const deepest = random.uniform(1e-7, 2e-5), phase = random.uniform(0, 3);
        double const radius_i = random.uniform(5e-4, 2e-3), radius_j = random.uniform(5e-4, 2e-3);
        double const mass = random.uniform(1e-6, 1e-5);
        for (int k = 0; k < moments; ++k) {
            double const depth = deepest * std::sin(phase + 12.0 * k / moments);
            double const angle = 0.02 * k;
            Vector3 const normal{std::cos(angle), std::sin(angle), 0};
            Vector3 const along{-std::sin(angle), std::cos(angle), 0};
            double const overlap = depth > 0 ? depth : 0;
            double const limit = 1e3 * overlap;
            double const radius = radius_i * radius_j / (radius_i + radius_j);
            double const contact_radius = std::sqrt(radius * overlap);
            result.push_back({{normal,
                               overlap,
                               depth < 0 ? -depth : 0,
                               radius_i,
                               radius_j,
                               radius,
                               contact_radius,
                               mass,
                               std::sqrt(mass * contact_radius),
                               1.4 * mass * radius_i * radius_i,
                               random.uniform(-0.1, 0.1),
                               random.uniform(-0.1, 0.1) * along + Vector3{0, 0, 0.05},
                               {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)},
                               1e-6},
                              {limit, limit, 1.5e3, 0.0, 0.0}});
        }
    }
    return result;
}

//! Calls `visit(name, law)` for every law of every kind, in the order of the list of laws.
template <class Visitor>
void for_each_law(Visitor&& visit)
{
    for (auto const& spec : contact::pair_options())
        for (auto const& choice : spec.choices) {
            auto values = defaults_of(contact::pair_options());
            for (auto const& [key, value] : {std::pair{"restitution", 0.4},
                                             {"static_friction", 0.5},
                                             {"kinetic_friction", 0.4},
                                             {"rolling_friction", 0.1},
                                             {"rolling_viscosity", 1e-3},
                                             {"rolling_damping", 0.3},
                                             {"surface_energy", 0.05},
                                             {"cohesion_energy_density", 1e4},
                                             {"surface_tension", 0.07},
                                             {"bridge_volume", 1e-14}})
                values.set(key, value);
            values.set(spec.key, choice);
            contact::Material const grain{"grain", 2500, 5e6, 0.3};
            contact::LawSet const laws(grain, grain, contact::make_pair("grain", "grain", values));
            auto const visit_any = [&](auto const& any) {
                std::visit(
                    [&]<class Law>(Law const& law) {
                        if constexpr (!std::is_same_v<Law, contact::NoLaw>)
                            visit(spec.key + " " + choice, law);
                    },
                    any);
            };
            if (spec.key == "normal")
                visit_any(laws.normal);
            else if (spec.key == "tangential")
                visit_any(laws.tangential);
            else if (spec.key == "rolling")
                visit_any(laws.rolling);
            else if (spec.key == "cohesion")
                visit_any(laws.cohesion);
        }
}

//! Results of all laws for all contacts, compiled by the device's compiler. \throws std::runtime_error
std::vector<double> evaluated_on_device(std::vector<Moment> const& moments, int contacts);
//! The same functions, compiled by that compiler for the host.
std::vector<double> evaluated_by_device_compiler(std::vector<Moment> const& moments, int contacts);
//! Whether this machine has a device that runs them.
bool device_is_there();

} // namespace demens::parity
