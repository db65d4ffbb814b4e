// What a run of an experiment is made from, value by value.
#include "demens/grain/words.hpp"
#include "ensemble/input/base_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/toml_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <set>

namespace demens::ensemble::input {
namespace {

using Table = ScalarPlace::Table;

//! Values in the order in which they are added.
class ValueList
{
  public:
    explicit ValueList(BaseInput const& base) : base_(base) {}

    void add(std::string path, ScalarPlace const& place)
    {
        int factor = -1;
        for (std::size_t f = 0; f < base_.factor_places.size(); ++f)
            if (auto const& places = base_.factor_places[f];
                std::find(places.begin(), places.end(), place) != places.end())
                factor = static_cast<int>(f);
        auto const value = base_.value(place);
        values_.push_back({std::move(path), is_absent(value) ? "not given" : option_text(value), factor});
    }
    void add(std::string const& above, Table table, std::size_t index, std::vector<OptionSpec> const& specs)
    {
        for (auto const& spec : specs)
            add(above + spec.key, {table, index, {}, spec.key});
    }
    void add_text(std::string path, std::string text)
    {
        values_.push_back({std::move(path), std::move(text), -1});
    }
    std::vector<ModelValue> const& values() const { return values_; }

  private:
    BaseInput const& base_;
    std::vector<ModelValue> values_;
};

std::string text_of(SizeTable const& sizes)
{
    auto text =
        fmt::format("{} of mass at {} mm, {}", fmt::join(sizes.fractions, ", "),
                    fmt::join(sizes.diameters, ", "), sizes.classes ? "classes" : "a cumulative curve");
    for (auto const& shape : sizes.shapes)
        text += fmt::format(", {} of {} {}", number_text(shape.share), word_for(sizes.share_of), shape.name);
    return text;
}

std::string text_of(ShapeTable const& shape)
{
    auto text = fmt::format("size {}", word_for(shape.measure));
    for (auto const& ball : shape.spheres)
        text += fmt::format(", [{}, {}, {}, {}]", number_text(ball.place.x), number_text(ball.place.y),
                            number_text(ball.place.z), number_text(ball.radius));
    if (shape.spheres.empty())
        text += fmt::format(", a polyhedron, rounding {}", number_text(shape.rounding));
    for (Vector3 const& v : shape.vertices)
        text += fmt::format(", [{}, {}, {}]", number_text(v.x), number_text(v.y), number_text(v.z));
    return text;
}

//! The same for either order of its materials.
std::string name_of(PairTable const& pair)
{
    return fmt::format("contact.{}_{}", std::min(pair.first, pair.second), std::max(pair.first, pair.second));
}

} // namespace

std::vector<ModelValue> model_values(BaseInput const& base, std::vector<Experiment> const& experiments,
                                     std::size_t experiment)
{
    ValueList values(base);
    std::set<std::string> materials, sizes, shapes;
    auto const above = "experiment." + experiments[experiment].name + ".";
    values.add_text(above + "rig", experiments[experiment].rig->name);
    for_each_value(base, experiments, experiment,
                   [&](std::string const& inside, ScalarPlace const& place, OptionSpec const& spec) {
                       values.add(above + inside, place);
                       if (spec.names_entry_of == "material")
                           materials.insert(std::get<std::string>(base.value(place)));
                       if (spec.names_entry_of == "size_distribution")
                           sizes.insert(std::get<std::string>(base.value(place)));
                       if (spec.names_entry_of == "shape")
                           shapes.insert(std::get<std::string>(base.value(place)));
                       if (!spec.names_file)
                           return;
                       if (auto const file = base.files.find(std::get<std::string>(base.value(place)));
                           file != base.files.end())
                           values.add_text(above + inside + " (content)",
                                           fmt::format("{:x}", std::hash<std::string>()(*file->second)));
                   });
    for (std::size_t m = 0; m < base.materials.size(); ++m)
        if (auto const& name = base.materials[m].name; materials.count(name))
            values.add("material." + name + ".", Table::material, m, contact::material_options());
    for (std::size_t p = 0; p < base.pairs.size(); ++p)
        if (auto const& pair = base.pairs[p]; materials.count(pair.first) && materials.count(pair.second))
            values.add(name_of(pair) + ".", Table::pair, p, contact::pair_options());
    for (auto const& one : base.size_distributions)
        if (sizes.count(one.name)) {
            values.add_text("size_distribution." + one.name, text_of(one));
            for (auto const& shape : one.shapes)
                shapes.insert(shape.name);
        }
    for (auto const& one : base.shapes)
        if (shapes.count(one.name))
            values.add_text("shape." + one.name, text_of(one));
    return values.values();
}

} // namespace demens::ensemble::input
