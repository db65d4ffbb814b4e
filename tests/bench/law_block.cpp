#include "tests/bench/law_block.hpp"

#include "demens/contact/laws.hpp"
#include "src/dem/cpu/law_stages.hpp"
#include "tests/bench/interleaved.hpp"
#include "tests/bench/replica.hpp"

#include <algorithm>
#include <limits>
#include <memory>

namespace demens::bench {

contact::Model powder_with(LawChoice const& choice)
{
    auto values = defaults_of(contact::pair_options());
    values.set("tangential", std::string("mindlin"));
    for (auto const& [key, value] : {std::pair{"restitution", 0.7},
                                     {"static_friction", 0.5},
                                     {"rolling_friction", 0.1},
                                     {"rolling_viscosity", 1e-4},
                                     {"rolling_damping", 0.3},
                                     {"cohesion_energy_density", 1e4},
                                     {"surface_energy", 0.01},
                                     {"surface_tension", 0.02},
                                     {"bridge_volume", 1e-13}})
        values.set(key, value);
    contact::Model model = powder("none");
    for (auto const& [kind, law] : choice) {
        values.set(kind, law);
        if (law == "hysteretic_spring")
            model.materials[0].youngs_modulus *= 0.1; // for its unloading the time step is too long otherwise
    }
    model.pairs = {contact::make_pair(model.materials[0].name, model.materials[0].name, values)};
    return model;
}

std::vector<LawChoice> single_laws()
{
    std::vector<LawChoice> result;
    for (auto const& spec : contact::pair_options())
        for (auto const& law : spec.choices)
            result.push_back({{spec.key, law}});
    return result;
}

void fill(dem::ContactBlock& b)
{
    b.count = dem::ContactBlock::lanes;
    for (int l = 0; l < b.count; ++l) {
        b.slot[l] = static_cast<std::uint32_t>(l);
        b.dx[l] = 1.99e-3, b.dy[l] = 1e-5 * l, b.dz[l] = -1e-5 * l;
        b.radius_i[l] = b.radius_j[l] = 1e-3;
        b.mass_i[l] = b.mass_j[l] = 1e-5;
        b.vx[l] = -1e-2, b.vy[l] = 1e-3 * l, b.vz[l] = 1e-3;
        b.wix[l] = 1, b.wiy[l] = 2, b.wiz[l] = 3;
        b.wjx[l] = -1, b.wjy[l] = 0.1 * l, b.wjz[l] = 0.5;
        for (auto& lane : b.state)
            lane[l] = 0;
    }
}

double arithmetic_nanoseconds(contact::Model const& model)
{
    constexpr int measurements = 20, blocks = 500;
    auto const block = std::make_unique<dem::ContactBlock>();
    contact::LawSet const laws(model.materials[0], model.materials[0], model.pairs[0]);
    auto const layout = contact::state_layout(laws, false);
    fill(*block);
    double least = std::numeric_limits<double>::infinity();
    for (int m = 0; m < measurements; ++m) {
        double const start = processor_seconds();
        for (int k = 0; k < blocks; ++k) {
            dem::derive_geometry(*block, false, 0.5);
            dem::evaluate_laws(*block, laws, layout, 1e-6);
        }
        double const taken = processor_seconds() - start;
        least = std::min(least, 1e9 * taken / (blocks * dem::ContactBlock::lanes));
    }
    return least;
}

} // namespace demens::bench
