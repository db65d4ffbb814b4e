#include "ensemble/input/resolved_text.hpp"

#include "demens/grain/words.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/section.hpp"
#include "ensemble/input/toml_text.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

template <class Values, class Text>
std::string list(Values const& values, Text const& text)
{
    std::string joined;
    for (auto const& value : values)
        joined += (joined.empty() ? "" : ", ") + text(value);
    return "[" + joined + "]";
}

//! Writes sections one after the other.
class Writer
{
  public:
    void heading(std::string const& heading) { text_ += "\n" + heading + "\n"; }
    void line(std::string const& key, std::string const& value, std::string const& doc)
    {
        text_ += fmt::format("{} = {} # {}\n", key, value, doc);
    }
    void options(std::vector<OptionSpec> const& specs, OptionValues const& values)
    {
        for (auto const& spec : specs)
            if (auto const& value = values.all().at(spec.key); !is_absent(value))
                line(spec.key, option_text(value), spec.doc);
    }
    void lists(std::vector<ListSpec> const& specs, std::map<std::string, std::string> const& values)
    {
        for (auto const& spec : specs)
            if (auto const found = values.find(spec.key); found != values.end())
                line(spec.key, found->second, spec.doc);
    }
    void tables(std::string const& above, std::vector<TableSpec> const& specs, OptionValues const& values)
    {
        for (auto const& spec : specs)
            for (auto const& entry : values.tables(spec.key)) {
                auto const name = above + "." + spec.key;
                heading("[[" + name + "]]");
                options(options_of(spec, entry), entry);
                tables(name, spec.tables, entry);
            }
    }
    template <class Section>
    void section(std::string const& name, Section const& section)
    {
        heading("[" + name + "]");
        options(specs_of<Section>(), values_of(section));
    }
    void plain(std::string const& text) { text_ += text; }
    std::string const& text() const { return text_; }

  private:
    std::string text_ = "# Every key of this campaign with its value.\n";
};

void write_base(Writer& out, BaseInput const& base)
{
    for (auto const& material : base.materials) {
        out.heading("[material." + material.name + "]");
        out.options(contact::material_options(), material.values);
    }
    for (auto const& pair : base.pairs) {
        out.heading("[contact." + pair.name() + "]");
        out.options(contact::pair_options(), pair.values);
    }
    for (auto const& shape : base.shapes) {
        out.heading("[shape." + shape.name + "]");
        OptionValues values;
        values.set("size", std::string(word_for(shape.measure)));
        std::vector<OptionSpec> specs = {spec_of(shape_options(), "size")};
        if (shape.spheres.empty()) {
            values.set("rounding", shape.rounding);
            specs.push_back(spec_of(shape_options(), "rounding"));
        }
        out.options(specs, values);
        auto const ball = [](grain::Ball const& b) {
            return list(std::vector{b.place.x, b.place.y, b.place.z, b.radius}, number_text);
        };
        auto const vertex = [](Vector3 const& v) { return list(std::vector{v.x, v.y, v.z}, number_text); };
        out.lists(shape_lists(), {shape.spheres.empty() ? std::pair("vertices", list(shape.vertices, vertex))
                                                        : std::pair("spheres", list(shape.spheres, ball))});
    }
    for (auto const& sizes : base.size_distributions) {
        out.heading("[size_distribution." + sizes.name + "]");
        std::map<std::string, std::string> lists = {
            {sizes.classes ? "classes_mm" : "diameters_mm", list(sizes.diameters, number_text)},
            {sizes.classes ? "mass_fraction" : "cumulative_mass_fraction",
             list(sizes.fractions, number_text)}};
        if (!sizes.shapes.empty()) {
            lists["shapes"] = list(sizes.shapes, [](ShapeShare const& s) { return quoted(s.name); });
            lists["shape_fraction"] =
                list(sizes.shapes, [](ShapeShare const& s) { return number_text(s.share); });
            OptionValues values;
            values.set("shape_fraction_of", std::string(word_for(sizes.share_of)));
            out.options(size_distribution_options(), values);
        }
        out.lists(size_distribution_lists(), lists);
    }
}

//! Keys and values in one line: `{ value = 1, scale = 0.1 }`; tables `window` with them.
std::string in_line(std::vector<OptionSpec> const& specs, OptionValues const& values)
{
    std::string members;
    auto const add = [&](std::string const& key, std::string const& value) {
        members += fmt::format("{}{} = {}", members.empty() ? "" : ", ", key, value);
    };
    for (auto const& spec : specs)
        if (auto const& value = values.all().at(spec.key); !is_absent(value))
            add(spec.key, option_text(value));
    if (auto const& windows = values.tables("window"); !windows.empty())
        add("window", list(windows, [](OptionValues const& window) {
                return in_line(curve_window_options(), window);
            }));
    return "{ " + members + " }";
}

std::string in_line(PictureTarget const& picture)
{
    auto specs = picture_options();
    std::erase_if(specs, [](OptionSpec const& spec) { return spec.key == "file"; });
    auto members = in_line(specs, picture.given).substr(2);
    if (!picture.circle.empty())
        members = "circle_px = " + list(picture.circle, number_text) + ", " + members;
    return "{ files = " + list(picture.files, quoted) + ", " + members;
}

//! Keys of a curve that can be read again.
std::vector<OptionSpec> curve_specs(CurveTarget const& curve)
{
    auto specs = curve_options();
    std::erase_if(specs, [&](OptionSpec const& spec) {
        return spec.key == (curve.is_profile ? "time" : "axis") ||
               (spec.key == "windows" && !curve.given.tables("window").empty());
    });
    return specs;
}

void write_experiment(Writer& out, Experiment const& experiment, OptionValues const& rig_values)
{
    out.heading("[[experiment]]");
    OptionValues header;
    header.set("name", experiment.name);
    header.set("rig", experiment.rig->name);
    header.set("replicates", std::int64_t{experiment.replicates});
    out.options(experiment_options(), header);
    out.options(experiment.rig->options, rig_values);
    bool const is_fitted = experiment.role == ExperimentRole::calibrate;
    for (auto const& target : is_fitted ? experiment.targets : experiment.held_out) {
        if (target.comes_of != TargetSource::value)
            continue; // stands with its curve or picture
        OptionValues values;
        values.set("value", target.value);
        values.set("scale", target.scale);
        values.set("sd", target.sd);
        values.set("tolerance", target.tolerance);
        values.set("transform", std::string(word_for(target.transform)));
        values.set("lower", target.lower);
        values.set("upper", target.upper);
        auto const& response = experiment.responses[static_cast<std::size_t>(target.response_index)];
        out.line("target." + target.response, in_line(target_options(), values), response.doc);
    }
    for (auto const& curve : experiment.curves)
        out.line("target." + curve.name, in_line(curve_specs(curve), curve.given), "a measured curve");
    if (experiment.picture)
        out.line("target.picture", in_line(*experiment.picture), "a photograph");
    out.tables("experiment", experiment.rig->tables, rig_values);
}

void write_factor(Writer& out, Factor const& factor)
{
    out.heading("[[factor]]");
    OptionValues values;
    values.set("path", factor.path);
    values.set("name", factor.name);
    values.set("lower", factor.lower);
    values.set("upper", factor.upper);
    values.set("scale", std::string(word_for(factor.log_scale ? FactorScale::log : FactorScale::linear)));
    values.set("inactive_value", factor.inactive_value);
    out.options(factor_options(), values);
    if (!factor.levels.empty())
        out.lists(factor_lists(), {{"levels", list(factor.levels, number_text)}});
}

void write_design(Writer& out, DesignOptions const& design)
{
    out.heading("[design]");
    // Keys that this kind does not use would be refused when read.
    auto const unused = [&](OptionSpec const& spec) {
        auto const kinds = design_kinds_using(spec.key);
        return !kinds.empty() && std::find(kinds.begin(), kinds.end(), design.kind) == kinds.end();
    };
    auto specs = specs_of<DesignOptions>();
    std::erase_if(specs, unused);
    std::erase_if(specs, [](OptionSpec const& spec) { return spec.names_file; }); // its rows stand below
    out.options(specs, values_of(design));
    std::map<std::string, std::string> lists;
    if (!design.generators.empty())
        lists["generators"] = list(design.generators, quoted);
    if (!design.table.empty())
        lists["table"] = list(design.table, [](auto const& row) { return list(row, number_text); });
    out.lists(design_lists(), lists);
}

void write_screening(Writer& out, ScreeningOptions const& screening)
{
    out.section("screening", screening);
    if (!screening.generators.empty())
        out.lists(screening_lists(), {{"generators", list(screening.generators, quoted)}});
}

void write_objective(Writer& out, ObjectiveOptions const& objective)
{
    out.section("objective", objective);
    auto const text = [](TargetCombination const& combination) { return quoted(combination.text); };
    if (!objective.combinations.empty())
        out.lists(objective_lists(), {{"combinations", list(objective.combinations, text)}});
}

void write_gap(Writer& out, GapOptions const& gap)
{
    out.section("gap", gap);
    std::map<std::string, std::string> lists;
    if (!gap.held_out.empty())
        lists["held_out"] = list(gap.held_out, quoted);
    if (!gap.candidates.empty())
        lists["candidates"] = list(gap.candidates, quoted);
    if (!gap.effects.empty())
        lists["effects"] = list(gap.effects, quoted);
    if (!gap.typical.empty()) {
        std::vector<std::string> amplitudes;
        for (auto const& [effect, amplitude] : gap.typical)
            amplitudes.push_back(fmt::format("{} = {}", effect, number_text(amplitude)));
        lists["typical"] = fmt::format("{{ {} }}", fmt::join(amplitudes, ", "));
    }
    out.lists(gap_lists(), lists);
}

} // namespace

std::string resolved_text(CampaignInput const& input, BaseInput const& base)
{
    Writer out;
    OptionValues campaign;
    campaign.set("name", input.name);
    campaign.set("seed", static_cast<std::int64_t>(input.seed));
    out.heading("[campaign]");
    out.options(campaign_options(), campaign);
    write_base(out, base);
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        write_experiment(out, input.experiments[e], base.experiments[e]);
    for (auto const& factor : input.factors)
        write_factor(out, factor);
    for (auto const& constraint : input.constraints) {
        out.heading("[[constraint]]");
        OptionValues values;
        values.set("expression", constraint.text);
        out.options(constraint_options(), values);
    }
    write_screening(out, input.screening);
    write_design(out, input.design);
    write_objective(out, input.objective);
    out.section("surrogate", input.surrogate);
    out.section("search", input.search);
    out.section("solver", input.solver);
    out.section("stop", input.stop);
    out.section("run", input.run);
    if (input.gap)
        write_gap(out, *input.gap);
    out.plain(toml_text(input.effects));
    return out.text();
}

} // namespace demens::ensemble::input
