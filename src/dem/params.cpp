#include "src/dem/params.hpp"

#include "demens/base/error.hpp"

#include <algorithm>

namespace demens::dem {
namespace {

std::size_t index_of(contact::Model const& model, std::string const& name)
{
    auto const found = std::find_if(model.materials.begin(), model.materials.end(),
                                    [&](contact::Material const& m) { return m.name == name; });
    if (found == model.materials.end())
        throw InputError("a contact names the material \"" + name + "\", which is not among the materials");
    return static_cast<std::size_t>(found - model.materials.begin());
}

void add_law_set(Params& params, std::size_t a, std::size_t b, contact::PairProperties const& pair)
{
    auto const& materials = params.materials;
    params.interaction[a * materials.size() + b] = static_cast<std::uint32_t>(params.laws.size());
    params.laws.emplace_back(materials[a], materials[b], pair);
    params.places.emplace_back(pair);
    params.layouts.push_back(state_layout(params.laws.back(), params.options.energy_ledger));
}

} // namespace

void require_laws(Params const& params, MaterialId a, MaterialId b)
{
    if (params.interaction[a.value * params.materials.size() + b.value] != Params::no_laws)
        return;
    std::string const& first = params.materials[a.value].name;
    std::string const& second = params.materials[b.value].name;
    throw InputError(first + " meets " + second +
                     ", but no pair of the model says how they touch: give [contact." + first + "_" + second +
                     "]");
}

std::shared_ptr<Params const> make_params(contact::Model const& model, SimulationOptions const& options)
{
    Params params{options, model.materials, {}, {}, {}, {}};
    params.interaction.assign(model.materials.size() * model.materials.size(), Params::no_laws);
    // A law may treat its two bodies differently (each has its own modulus), so unlike materials get a law
    // set for either order.
    for (auto const& pair : model.pairs) {
        std::size_t const a = index_of(model, pair.first), b = index_of(model, pair.second);
        add_law_set(params, a, b, pair);
        if (a != b)
            add_law_set(params, b, a, pair);
    }
    return std::make_shared<Params const>(std::move(params));
}

} // namespace demens::dem
