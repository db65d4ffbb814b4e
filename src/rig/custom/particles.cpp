#include "src/rig/custom/particles.hpp"

#include "demens/base/error.hpp"
#include "demens/shape/sample_check.hpp"
#include "src/rig/custom/selection.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::rig::custom {
namespace {

enum class Source
{
    body,
    csv,
    packing
};
constexpr std::array<Word<Source>, 3> sources = {
    {{Source::body, "body"}, {Source::csv, "csv"}, {Source::packing, "packing"}}};

double sphere_mass(double diameter, double density)
{
    return density * std::numbers::pi / 6 * diameter * diameter * diameter;
}

Packing read_packing(OptionValues const& o, RunInput const& input, Regions const& regions,
                     std::string const& where)
{
    Packing packing{.region = regions.at(o.text("region"))};
    if (!o.text("within").empty())
        packing.within = regions.at(o.text("within"));
    packing.velocity = o.vector("velocity_m_s");
    packing.where = where;
    auto const& sizes = o.text("size_distribution");
    bool const one_size = o.number("diameter_mm") > 0;
    if (one_size == !sizes.empty())
        throw InputError(where + " needs either size_distribution or diameter_mm");
    if (one_size)
        packing.diameter = 1e-3 * o.number("diameter_mm");
    else
        packing.sizes = input.size_distributions.at(sizes);
    packing.count = o.integer("count");
    packing.mass = o.number("mass_kg");
    if ((packing.count > 0) == (packing.mass > 0))
        throw InputError(where + " needs either count or mass_kg");
    return packing;
}

ParticleTable read_csv(OptionValues const& o, RunInput const& input)
{
    auto table = read_particle_csv(*input.files.at(o.text("file")), o.text("file"));
    for (auto& body : table.bodies)
        body.place += 1e-3 * o.vector("shift_mm");
    return table;
}

//! Spheres of one diameter that come closest to the mass; at least one.
std::size_t count_of_mass(Packing const& packing, double density)
{
    return static_cast<std::size_t>(
        std::llround(std::max(1.0, packing.mass / sphere_mass(packing.diameter, density))));
}

Body read_body(OptionValues const& o, std::string const& where)
{
    return {1e-3 * o.vector("place_mm"), 0.5e-3 * o.number("diameter_mm"), o.vector("velocity_m_s"),
            o.vector("spin_rad_s"), where};
}

} // namespace

TableSpec particles_table()
{
    auto const velocity = vector("velocity_m_s", {}, "velocity at first [m/s]");
    return {.key = "particles",
            .doc = "a group of particles that enter together",
            .options = {required_word("name", "its name"),
                        required(entry("material", "material", "material of the particles")),
                        entry("stage", "stage", "enters when this stage begins; empty: the first one")},
            .kind_key = "source",
            .kinds = {{"body",
                       "one sphere",
                       {required(number("diameter_mm", 0, "diameter [mm]", positive)),
                        required_vector("place_mm", "centre [mm]"), velocity,
                        vector("spin_rad_s", {}, "angular velocity at first [rad/s]"),
                        number("clearance_mm", not_given,
                               "its lowest point enters so high above the mean surface of the particles then "
                               "there; how high place_mm is is not used [mm]",
                               0)}},
                      {"csv",
                       "spheres from a table",
                       {{.key = "file",
                         .default_value = std::string(),
                         .doc = "CSV with the header x,y,z,radius or x,y,z,radius,vx,vy,vz in m and m/s",
                         .required = true,
                         .names_file = true},
                        vector("shift_mm", {}, "added to all places [mm]")}},
                      {"packing",
                       "spheres at random places, which depend on the run's seed",
                       {required(entry("region", "region", "where; whole spheres lie in it")),
                        entry("within", "region", "lie whole in this one too; empty: none"),
                        entry("size_distribution", "size_distribution", "sizes of the spheres"),
                        number("diameter_mm", 0, "diameter of all, instead of size_distribution [mm]", 0),
                        {.key = "count",
                         .default_value = std::int64_t{0},
                         .doc = "number of spheres",
                         .lower = 0,
                         .upper = 1e8},
                        number("mass_kg", 0, "mass of all together, instead of count [kg]", 0),
                        velocity}}}};
}

bool ParticleGroup::is_one_body() const
{
    auto const* bodies = std::get_if<std::vector<Body>>(&source);
    auto const* packing = std::get_if<Packing>(&source);
    return packing ? packing->count == 1 : !bodies || bodies->size() == 1;
}

double ParticleGroup::smallest() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return packing->smallest();
    if (auto const* above = std::get_if<AboveOthers>(&source))
        return 2 * above->body.radius;
    auto const& bodies = std::get<std::vector<Body>>(source);
    return 2 * std::min_element(bodies.begin(), bodies.end(), [](auto const& a, auto const& b) {
                   return a.radius < b.radius;
               })->radius;
}

double ParticleGroup::largest() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return packing->largest();
    if (auto const* above = std::get_if<AboveOthers>(&source))
        return 2 * above->body.radius;
    auto const& bodies = std::get<std::vector<Body>>(source);
    return 2 * std::max_element(bodies.begin(), bodies.end(), [](auto const& a, auto const& b) {
                   return a.radius < b.radius;
               })->radius;
}

double ParticleGroup::expected_count(double density) const
{
    if (auto const* packing = std::get_if<Packing>(&source)) {
        if (packing->count > 0)
            return static_cast<double>(packing->count);
        double per_mass = 0; // mean of 1/m over the mass
        constexpr int samples = 100;
        for (int k = 0; k < samples; ++k) {
            double const d =
                packing->sizes ? packing->sizes->quantile((k + 0.5) / samples) : packing->diameter;
            per_mass += 1 / sphere_mass(d, density) / samples;
        }
        return packing->mass * per_mass;
    }
    auto const* bodies = std::get_if<std::vector<Body>>(&source);
    return bodies ? static_cast<double>(bodies->size()) : 1;
}

shape::BoxRegion ParticleGroup::bounds() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return shape::bounds(packing->region);
    auto const* above = std::get_if<AboveOthers>(&source);
    auto const bodies = above ? std::vector{above->body} : std::get<std::vector<Body>>(source);
    auto box = shape::bounds(shape::BallRegion{bodies.front().place, bodies.front().radius});
    for (auto const& body : bodies) {
        auto const own = shape::bounds(shape::BallRegion{body.place, body.radius});
        box = {{std::min(box.lower.x, own.lower.x), std::min(box.lower.y, own.lower.y),
                std::min(box.lower.z, own.lower.z)},
               {std::max(box.upper.x, own.upper.x), std::max(box.upper.y, own.upper.y),
                std::max(box.upper.z, own.upper.z)}};
    }
    return box;
}

std::vector<ParticleGroup> read_particles(RunInput const& input, Regions const& regions)
{
    std::vector<ParticleGroup> groups;
    auto const& stages = input.experiment.tables("stage");
    for (auto const& o : input.experiment.tables("particles")) {
        auto const where = "particles." + o.text("name");
        ParticleGroup group{o.text("name"), o.text("material"), position_of(stages, o.text("stage"), 0), {}};
        ParticleTable table;
        switch (read_word(sources, o.text("source"))) {
        case Source::body:
            if (is_absent(o.number("clearance_mm")))
                group.source = std::vector{read_body(o, where)};
            else
                group.source = AboveOthers{read_body(o, where), 1e-3 * o.number("clearance_mm")};
            break;
        case Source::csv:
            table = read_csv(o, input);
            group.source = std::move(table.bodies);
            group.unused = std::move(table.unused);
            break;
        case Source::packing:
            group.source = read_packing(o, input, regions, where);
            break;
        }
        groups.push_back(std::move(group));
    }
    if (groups.empty())
        throw InputError("there are no particles; give at least one table [[experiment.particles]]");
    return groups;
}

std::vector<std::string> particle_warnings(ParticleGroup const& group, double density)
{
    std::vector<std::string> warnings;
    if (!group.unused.empty())
        warnings.push_back(
            fmt::format("columns of the table that are not used: {}", fmt::join(group.unused, ", ")));
    if (auto const* packing = std::get_if<Packing>(&group.source)) {
        std::string missed;
        if (packing->sizes && packing->count > 1) {
            RandomStream any_order(1);
            auto const diameters = sample_diameters(*packing, density, any_order);
            double mass = 0;
            for (double const d : diameters)
                mass += sphere_mass(d, density);
            missed = shape::SampleCheck(*packing->sizes, diameters, mass, density).warning;
        } else if (packing->sizes && packing->count == 0) {
            missed = shape::sample_warning(*packing->sizes, packing->mass, density);
        } else if (packing->count == 0) {
            std::vector<double> const diameters(count_of_mass(*packing, density), packing->diameter);
            missed = shape::SampleCheck(shape::SizeDistribution({packing->diameter}, {1}), diameters,
                                        packing->mass, density)
                         .warning;
        }
        if (!missed.empty())
            warnings.push_back(missed);
    }
    for (auto& warning : warnings)
        warning = fmt::format("particles.{}: {}", group.name, warning);
    return warnings;
}

std::vector<double> sample_diameters(Packing const& packing, double density, RandomStream& random)
{
    auto const of_mass = [&](double mass) {
        RandomStream same_numbers = random;
        return packing.sizes->sample_mass(mass, density, same_numbers);
    };
    if (!packing.sizes) {
        auto const count =
            packing.count > 0 ? static_cast<std::size_t>(packing.count) : count_of_mass(packing, density);
        return std::vector<double>(count, packing.diameter);
    }
    if (packing.count == 0) {
        RandomStream same_numbers = random;
        try {
            return shape::sample_whole(*packing.sizes, packing.mass, density, same_numbers);
        } catch (InputError const& error) {
            throw InputError(fmt::format("{}: {}", packing.where, error.what()));
        }
    }
    // The mass that has as many spheres; one too many goes.
    auto const wanted = static_cast<std::size_t>(packing.count);
    double too_little = 0, enough = sphere_mass(packing.largest(), density) * static_cast<double>(wanted + 1);
    for (int k = 0; k < 50; ++k) {
        double const middle = 0.5 * (too_little + enough);
        (of_mass(middle).size() < wanted ? too_little : enough) = middle;
    }
    auto diameters = of_mass(enough);
    diameters.resize(wanted);
    return diameters;
}

} // namespace demens::rig::custom
