#include "ensemble/input/base_input.hpp"

#include "ensemble/input/shapes.hpp"

namespace demens::ensemble::input {

namespace {

template <class Base> // const or not
auto& table_of(Base& base, ScalarPlace const& place)
{
    switch (place.table) {
    case ScalarPlace::Table::material:
        return base.materials.at(place.index).values;
    case ScalarPlace::Table::pair:
        return base.pairs.at(place.index).values;
    case ScalarPlace::Table::experiment:
        break;
    }
    auto* table = &base.experiments.at(place.index);
    for (auto const& [key, number] : place.inside)
        table = &table->table(key, number);
    return *table;
}

} // namespace

OptionValue BaseInput::value(ScalarPlace const& place) const
{
    auto const& table = table_of(*this, place);
    if (place.component < 0)
        return table.all().at(place.key);
    auto const& vector = table.vector(place.key);
    return place.component == 0 ? vector.x : place.component == 1 ? vector.y : vector.z;
}

void BaseInput::set(ScalarPlace const& place, OptionValue const& value)
{
    auto& table = table_of(*this, place);
    if (place.component < 0) {
        table.set(place.key, value);
        return;
    }
    auto vector = table.vector(place.key);
    (place.component == 0 ? vector.x : place.component == 1 ? vector.y : vector.z) = std::get<double>(value);
    table.set(place.key, vector);
}

std::vector<std::string> BaseInput::material_names() const
{
    std::vector<std::string> names;
    for (auto const& material : materials)
        names.push_back(material.name);
    return names;
}

std::vector<std::string> BaseInput::size_distribution_names() const
{
    std::vector<std::string> names;
    for (auto const& sizes : size_distributions)
        names.push_back(sizes.name);
    return names;
}

void set_factors(BaseInput& base, std::vector<double> const& factor_values)
{
    for (std::size_t f = 0; f < factor_values.size(); ++f)
        for (auto const& place : base.factor_places.at(f))
            base.set(place, factor_values[f]);
}

rig::RunInput make_run_input(BaseInput base, std::vector<double> const& factor_values, int experiment,
                             std::uint64_t seed)
{
    set_factors(base, factor_values);
    return make_run_input(base, experiment, seed);
}

rig::RunInput make_run_input(BaseInput const& base, int experiment, std::uint64_t seed)
{
    rig::RunInput input;
    for (auto const& material : base.materials)
        input.model.materials.push_back(contact::make_material(material.name, material.values));
    for (auto const& pair : base.pairs)
        input.model.pairs.push_back(contact::make_pair(pair.first, pair.second, pair.values));
    for (auto const& sizes : base.size_distributions) {
        input.size_distributions.emplace(sizes.name, make_size_distribution(sizes));
        if (!sizes.shapes.empty())
            input.shapes_of_sizes.emplace(sizes.name, make_mixture(sizes, base.shapes));
    }
    for (auto const& shape : base.shapes)
        input.shapes.emplace(shape.name, shape.shape);
    input.experiment = base.experiments.at(static_cast<std::size_t>(experiment));
    input.seed = seed;
    input.files = base.files;
    input.engine = base.engine;
    return input;
}

} // namespace demens::ensemble::input
