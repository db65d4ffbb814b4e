#include "ensemble/input/campaign_input.hpp"

#include "ensemble/input/all_faults.hpp"
#include "ensemble/input/base_input.hpp"
#include "ensemble/input/design_table.hpp"
#include "ensemble/input/effects.hpp"
#include "ensemble/input/gap_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/objective_input.hpp"
#include "ensemble/input/old_words.hpp"
#include "ensemble/input/option_range.hpp"
#include "ensemble/input/resolved_text.hpp"
#include "ensemble/input/section.hpp"
#include "ensemble/input/toml_file.hpp"
#include "ensemble/input/whole_checks.hpp"

#include <fmt/format.h>

namespace demens::ensemble {
namespace {

template <class Section>
void read_section(input::InputTable const& table, std::vector<std::string> const& lists, Section& section)
{
    input::assign(section, table.read(input::specs_of<Section>(), lists));
}

} // namespace

CampaignInput CampaignInput::from_file(std::filesystem::path const& file,
                                       std::vector<rig::RigInfo> const& rigs)
{
    auto const text = input::read_text(file, "a campaign's TOML file");
    try {
        return from_text(text, file.string(), rigs, input::files_beside(file));
    } catch (InputError const& error) {
        throw InputError(input::with_all_faults(error.what(), text, file.string(), rigs));
    }
}

CampaignInput CampaignInput::from_text(std::string const& toml, std::string const& origin,
                                       std::vector<rig::RigInfo> const& rigs, input::FileSource const& files,
                                       input::OldWords old_words)
{
    auto parsed = input::parse_toml(toml, origin);
    if (old_words == input::OldWords::understood)
        input::understand_old_words(parsed);
    input::InputTable const file(parsed, "", origin);
    if (parsed.contains("fit") && !parsed.contains("campaign") && !parsed.contains("experiment"))
        throw InputError(fmt::format(
            "{}: this is the file of a fit: `demens fit {}` reads it. A campaign has [campaign] and "
            "[[experiment]]; its keys: demens keys",
            origin, origin));
    file.allow_only({"campaign", "material", "contact", "shape", "size_distribution", "experiment", "factor",
                     "constraint", "screening", "design", "objective", "surrogate", "search", "solver",
                     "stop", "run", "gap", "effect"});

    CampaignInput campaign;
    auto const header = file.table("campaign").read(input::campaign_options());
    campaign.name = header.text("name");
    campaign.seed = static_cast<std::uint64_t>(header.integer("seed"));

    auto tree = std::make_shared<Tree>(Tree{input::read_base_model(file, files)});
    auto [experiments, experiment_tables, notes] = input::read_experiments(file, *tree, rigs, files);
    campaign.experiments = std::move(experiments);
    for (auto const& shape : tree->shapes)
        if (!shape.note.empty())
            campaign.notes_.push_back(shape.note);
    campaign.notes_.insert(campaign.notes_.end(), notes.begin(), notes.end());
    campaign.gap = input::read_gap(file, campaign.experiments); // gives roles, on which all below rests
    campaign.effects = input::read_effects(file, *tree, campaign.experiments);
    campaign.factors = input::read_factors(file, *tree, campaign.experiments);
    campaign.constraints = input::read_constraints(file, *tree, campaign.experiments, campaign.factors);

    auto const screening = file.table("screening");
    read_section(screening, input::keys_of(input::screening_lists()), campaign.screening);
    campaign.screening.generators = screening.words("generators");
    auto const objective = file.table("objective");
    read_section(objective, input::keys_of(input::objective_lists()), campaign.objective);
    campaign.objective.combinations = input::read_combinations(objective, campaign.experiments);
    auto const design = file.table("design");
    read_section(design, input::keys_of(input::design_lists()), campaign.design);
    campaign.design.generators = design.words("generators");
    campaign.warnings_ = input::read_design_table(design, files, campaign, tree->files);
    read_section(file.table("surrogate"), {}, campaign.surrogate);
    read_section(file.table("search"), {}, campaign.search);
    input::refuse_old_words(file.table("solver"));
    read_section(file.table("solver"), {}, campaign.solver);
    read_section(file.table("stop"), {}, campaign.stop);
    read_section(file.table("run"), {}, campaign.run);
    tree->engine = campaign.run.engine;

    if (campaign.run.ranks_per_group == 0)
        campaign.run.ranks_per_group = input::ranks_that_pay(campaign, *tree);
    input::check_sections(file, campaign);
    input::check_rigs(campaign, *tree, experiment_tables);

    campaign.text_ = toml;
    campaign.resolved_text_ = input::resolved_text(campaign, *tree);
    campaign.tree_ = std::move(tree);
    return campaign;
}

void CampaignInput::set(std::string const& path, double value)
{
    auto tree = std::make_shared<Tree>(*tree_);
    auto const resolved = input::resolve_path(path, *tree, experiments);
    if (resolved.places.empty())
        throw InputError(fmt::format("{} names nothing in this input; {}", path,
                                     input::suggestion(path, input::all_paths(*tree, experiments))));
    if (!std::holds_alternative<double>(resolved.spec.default_value))
        throw InputError(
            fmt::format("{} is not a number that can be varied continuously ({})", path, resolved.spec.doc));
    if (auto const complaint = input::range_complaint(resolved.spec, value); !complaint.empty())
        throw InputError(fmt::format("{} = {}: {} ({})", path, value, complaint, resolved.spec.doc));
    for (auto const& place : resolved.places)
        tree->set(place, value);
    tree_ = std::move(tree);
}

std::string CampaignInput::resolved_text_at(std::vector<double> const& factor_values) const
{
    input::BaseInput base = *tree_;
    input::set_factors(base, factor_values);
    return input::resolved_text(*this, base);
}

std::vector<std::string> CampaignInput::warnings() const
{
    std::vector<std::string> all = warnings_;
    for (std::size_t e = 0; e < experiments.size(); ++e)
        if (auto const& warnings = experiments[e].rig->warnings)
            for (auto const& warning : warnings(input::make_run_input(*tree_, {}, static_cast<int>(e), seed)))
                all.push_back(fmt::format("experiment.{}: {}", experiments[e].name, warning));
    return all;
}

rig::Files const& CampaignInput::files() const
{
    static rig::Files const none;
    return tree_ ? tree_->files : none;
}

rig::RunInput CampaignInput::run_input(std::vector<double> const& factor_values, int point, int experiment,
                                       int replicate, std::vector<Override> const& overrides) const
{
    input::BaseInput base = *tree_;
    input::set_factors(base, factor_values);
    input::apply(overrides, base, experiments);
    auto run = input::make_run_input(base, experiment, run_seed(point, experiment, replicate));
    input::check_run(*experiments.at(static_cast<std::size_t>(experiment)).rig, run,
                     this->run.ranks_per_group);
    return run;
}

std::optional<OptionValue> CampaignInput::base_value(std::string const& path) const
{
    auto const resolved = input::resolve_path(path, *tree_, experiments);
    if (resolved.places.empty())
        return std::nullopt;
    return tree_->value(resolved.places.front());
}

std::vector<ModelValue> CampaignInput::model_values(int experiment,
                                                    std::vector<Override> const& overrides) const
{
    input::BaseInput base = *tree_;
    input::apply(overrides, base, experiments);
    return input::model_values(base, experiments, static_cast<std::size_t>(experiment));
}

std::vector<NamedMaterial> CampaignInput::named_materials() const
{
    return input::named_materials(*tree_, experiments);
}

std::vector<std::pair<std::string, std::string>> CampaignInput::pairs() const
{
    std::vector<std::pair<std::string, std::string>> names;
    for (auto const& pair : tree_->pairs)
        names.emplace_back(pair.first, pair.second);
    return names;
}

std::vector<Effect> CampaignInput::effects_of(std::string const& text, std::string const& origin) const
{
    auto const parsed = input::parse_toml(text, origin);
    return input::read_effects(input::InputTable(parsed, "", origin), *tree_, experiments);
}

std::uint64_t CampaignInput::run_seed(int point, int experiment, int replicate) const
{
    std::uint64_t derived = seed;
    for (int key : {point, experiment, replicate})
        derived = derive_seed(derived, static_cast<std::uint64_t>(key));
    return derived;
}

} // namespace demens::ensemble
