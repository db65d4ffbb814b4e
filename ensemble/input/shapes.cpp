#include "ensemble/input/shapes.hpp"

#include "demens/grain/words.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/shape_source.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

using grain::ShareOf;
using grain::SizeMeasure;

constexpr char const* sphere = "sphere"; // a shape that there always is

} // namespace

std::vector<std::string> names_of(std::vector<ShapeTable> const& shapes)
{
    std::vector<std::string> names = {sphere};
    for (auto const& shape : shapes)
        names.push_back(shape.name);
    return names;
}

std::vector<ShapeTable> read_shapes(InputTable const& section, FileSource const& files, rig::Files& kept)
{
    std::vector<ShapeTable> shapes;
    for (auto const& name : section.keys()) {
        check_name(section, name, name);
        if (name == sphere)
            throw section.error(
                name, "is the name of the sphere, which there is without a table; give another one");
        auto const table = section.table(name);
        auto const values = table.read(shape_options(), keys_of(shape_lists()));
        ShapeTable shape{.name = name, .measure = *find_word<SizeMeasure>(values.text("size"))};
        read_source(shape, table, values, {files, kept});
        shapes.push_back(std::move(shape));
    }
    return shapes;
}

std::vector<ShapeShare> read_shape_shares(InputTable const& table, std::vector<ShapeTable> const& shapes)
{
    auto const names = table.words("shapes");
    auto const given = table.numbers("shape_fraction");
    auto const known = names_of(shapes);
    for (auto const& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw table.error("shapes",
                              fmt::format("there is no [shape.{}]; {}", name, suggestion(name, known)));
    for (char const* key : {"shape_fraction", "shape_fraction_of"}) {
        if (names.empty() && table.has(key))
            throw table.error(key, "is about `shapes`, which is missing");
        if (names.size() > 1 && !table.has(key))
            throw table.error(fmt::format("the key \"{}\" is missing; {} shapes need it", key, names.size()));
    }
    if (!given.empty() && given.size() != names.size())
        throw table.error(
            "shape_fraction",
            fmt::format("has {} values where shapes has {}; give one for each", given.size(), names.size()));
    std::vector<ShapeShare> shares;
    for (std::size_t k = 0; k < names.size(); ++k)
        shares.push_back({names[k], given.empty() ? 1.0 : given[k]});
    return shares;
}

grain::ShareOf read_share_of(InputTable const& table)
{
    if (!table.has("shape_fraction_of"))
        return ShareOf::mass;
    return *find_word<ShareOf>(
        std::get<std::string>(table.read_option(spec_of(size_distribution_options(), "shape_fraction_of"))));
}

grain::ShapeMixture make_mixture(SizeTable const& table, std::vector<ShapeTable> const& shapes)
{
    grain::ShapeMixture mixture{{}, {}, table.share_of};
    for (auto const& part : table.shapes) {
        std::string const& name = part.name;
        auto const found =
            std::find_if(shapes.begin(), shapes.end(), [&](auto const& s) { return s.name == name; });
        mixture.shapes.push_back(found == shapes.end() ? grain::GrainShape{name, nullptr, 1} : found->shape);
        mixture.shares.push_back(part.share);
    }
    return mixture;
}

} // namespace demens::ensemble::input
