#include "src/rig/custom/setup.hpp"

#include "demens/base/error.hpp"
#include "demens/shape/stl.hpp"
#include "src/rig/kinds.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

bool lists(std::vector<std::string> const& names, std::string const& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

//! All pairs of materials that may meet have coefficients.
void check_pairs(Setup const& setup)
{
    std::map<std::string, double> particles;
    for (auto const& group : setup.groups)
        particles[group.material] += setup.expected_count(group);
    for (auto const& [material, count] : particles) {
        for (auto const& [other, other_count] : particles)
            if (material < other || (material == other && count > 1))
                require_pair(setup.model, material, other);
        for (auto const& wall : setup.walls)
            require_pair(setup.model, material, wall.material);
    }
}

//! Time step for the particles that need the smallest.
double time_step_of(Setup const& setup, OptionValues const& options)
{
    TimeStepLimit limit{std::numeric_limits<double>::infinity(), {}};
    for (auto const& group : setup.groups) {
        auto const own = time_step_limit(setup.model, group.material, group.smallest(),
                                         options.number("rayleigh_fraction"));
        if (own.time_step < limit.time_step)
            limit = own;
    }
    return chosen_time_step(options, limit);
}

//! What the options say or, without them, all that has a place at first with a metre and its size around it.
shape::BoxRegion domain_of(Setup const& setup, OptionValues const& options)
{
    auto box = setup.groups.front().bounds();
    for (auto const& group : setup.groups)
        box = hull(box, group.bounds());
    box = hull(box, bounds(setup.walls, box));
    double const around = 1 + norm(box.upper - box.lower);
    box = {box.lower - Vector3{around, around, around}, box.upper + Vector3{around, around, around}};
    if (auto const& lower = options.vector("domain_lower_mm"); !is_absent(lower))
        box.lower = 1e-3 * lower;
    if (auto const& upper = options.vector("domain_upper_mm"); !is_absent(upper))
        box.upper = 1e-3 * upper;
    if (!(shape::volume(box) > 0))
        throw InputError(
            "the domain has no volume: domain_upper_mm must be greater than domain_lower_mm in x, y "
            "and z");
    return box;
}

//! The periodic directions, which are as wide as the domain. \throws InputError where they cannot be
dem::Periods periods_of(Setup const& setup, OptionValues const& options, shape::BoxRegion const& domain)
{
    double largest = 0;
    for (auto const& group : setup.groups)
        largest = std::max(largest, group.largest());
    double const least = 2.2 * (largest + setup.options.skin);
    auto const period = [&](char const* key, double lower, double upper) {
        if (!options.flag(key))
            return dem::Period{};
        if (is_absent(options.vector("domain_lower_mm")) || is_absent(options.vector("domain_upper_mm")))
            throw InputError(fmt::format("{} = true needs domain_lower_mm and domain_upper_mm, between which "
                                         "everything repeats itself",
                                         key));
        if (upper - lower < least)
            throw InputError(
                fmt::format("{} = true: the domain is {:.4g} mm wide, and a particle of {:.4g} mm "
                            "would meet the same neighbour on both sides; at least {:.4g}",
                            key, 1e3 * (upper - lower), 1e3 * largest, 1e3 * least));
        return dem::Period{lower, upper};
    };
    return {period("periodic_x", domain.lower.x, domain.upper.x),
            period("periodic_y", domain.lower.y, domain.upper.y)};
}

//! No mesh lies outside the domain, e.g. for a wrong unit.
void check_meshes(Setup const& setup)
{
    for (auto const& wall : setup.walls)
        if (auto const* mesh = std::get_if<dem::Mesh>(&wall.parts.front().shape))
            in_place("wall." + wall.name, [&] {
                shape::check_within(*mesh->mesh, setup.options.domain_lower, setup.options.domain_upper);
            });
}

} // namespace

OptionSpecs experiment_options()
{
    Vector3 const none{not_given, not_given, not_given};
    auto const domain_doc =
        "a particle beyond has escaped; none: a metre and more around all that is there at first [mm]";
    return joined(
        {{number("series_interval_s", 0.01, "between two looks at conditions and responses [s]", 1e-7),
          vector("domain_lower_mm", none, domain_doc), vector("domain_upper_mm", none, domain_doc),
          flag("periodic_x", false,
               "what leaves the domain along x comes back on its other side; needs domain_lower_mm and "
               "domain_upper_mm"),
          flag("periodic_y", false, "the same along y"),
          number("initial_overlap", 0.05,
                 "largest overlap of particles as given, and with walls that appear, over the smaller "
                 "radius [-]",
                 0),
          number("skin", 0.5, "reach of the neighbour lists beyond contact over the smallest radius [-]",
                 1e-3)},
         run_options()});
}

Setup::Setup(RunInput const& input)
    : model(input.model), seed(input.seed), walls(read_walls(input)),
      upright(input.experiment.vector("gravity_m_s2")),
      interval(input.experiment.number("series_interval_s")),
      overlap_limit(input.experiment.number("initial_overlap"))
{
    auto const regions = read_regions(input.experiment);
    groups = read_particles(input, regions);
    stages = read_stages(input.experiment, regions);
    outlets = read_outlets(input.experiment, regions);
    responses = read_responses(input.experiment, regions, groups);
    check_pairs(*this);
    options = simulation_options(input.experiment, time_step_of(*this, input.experiment));
    options.energy_ledger |= std::any_of(responses.begin(), responses.end(),
                                         [](auto const& response) { return response.term != nullptr; });
    double smallest = std::numeric_limits<double>::infinity();
    for (auto const& group : groups)
        smallest = std::min(smallest, group.smallest());
    options.skin = input.experiment.number("skin") * 0.5 * smallest;
    auto const box = domain_of(*this, input.experiment);
    options.domain_lower = box.lower, options.domain_upper = box.upper;
    options.periodic = periods_of(*this, input.experiment, box);
    span_planes(walls, box);
    check_meshes(*this);
    for (auto const& stage : stages)
        for (auto const& wall : stage.walls_on)
            if (lists(stage.walls_off, wall))
                throw InputError(fmt::format("stage.{} has the wall {} both in walls_on and in walls_off",
                                             stage.name, wall));
}

double Setup::density(ParticleGroup const& group) const
{
    return material_named(model, group.material).density;
}

bool Setup::is_on(WallPlan const& wall, std::size_t stage) const
{
    bool on = wall.active();
    for (std::size_t k = 0; k <= stage; ++k)
        on = lists(stages[k].walls_on, wall.name) || (on && !lists(stages[k].walls_off, wall.name));
    return on;
}

double Setup::longest_duration() const
{
    double sum = 0;
    for (auto const& stage : stages)
        sum += stage.duration;
    return sum;
}

bool Setup::has_rigid_bodies() const
{
    return !std::all_of(groups.begin(), groups.end(), [](auto const& group) { return group.are_spheres(); });
}

double Setup::expected_particles() const
{
    double sum = 0;
    for (auto const& group : groups)
        sum += expected_count(group);
    return sum;
}

double Setup::work_per_particle() const
{
    double work = 0;
    for (auto const& group : groups)
        work += expected_count(group) * group.work_per_grain();
    return work / expected_particles();
}

double Setup::expected_count(ParticleGroup const& group) const
{
    return group.expected_count(density(group), stages[group.stage].duration);
}

} // namespace demens::rig::custom
