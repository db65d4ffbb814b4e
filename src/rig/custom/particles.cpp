#include "src/rig/custom/particles.hpp"

#include "demens/base/error.hpp"
#include "demens/shape/sample_check.hpp"
#include "src/rig/common.hpp"
#include "src/rig/custom/geometry.hpp"
#include "src/rig/custom/selection.hpp"
#include "src/rig/kinds.hpp"
#include "src/rig/one_grain.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::rig::custom {
namespace {

double sphere_mass(double diameter, double density)
{
    return density * std::numbers::pi / 6 * diameter * diameter * diameter;
}

using Source = std::variant<ParticleTable, Packing>;

std::string place_of(OptionValues const& o)
{
    return "particles." + o.text("name");
}

//! Of what is random about a group; not that of a packing's places and sizes.
std::uint64_t seed_of(OptionValues const& o, RunInput const& input)
{
    auto const& groups = input.experiment.tables("particles");
    auto const number = position_of(groups, o.text("name"), groups.size());
    return derive_seed(derive_seed(input.seed, number + 1), 0);
}

Source read_body(OptionValues const& o, RunInput const& input, Regions const&)
{
    auto const shape = in_place(place_of(o), [&] { return shape_of(input, o); });
    auto const orientation =
        in_place(place_of(o), [&] { return orientation_of(o, shape, seed_of(o, input)); });
    return ParticleTable{
        {{millimetres(o, "place_mm"), radius_of(shape, 1e-3 * o.number("diameter_mm")),
          o.vector("velocity_m_s"), o.vector("spin_rad_s"), place_of(o), shape.shape, orientation}}};
}

//! How the grains of a table stand. \throws InputError
void orient(ParticleTable& table, OptionValues const& o, RunInput const& input,
            grain::GrainShape const& shape)
{
    bool const at_random = stands_at_random(o, shape);
    if (at_random && table.has_orientations)
        throw InputError(
            "orientation = \"random\", and the table says how they stand (qw, qx, qy, qz); leave "
            "one of them out");
    if (shape.is_sphere() && table.has_orientations)
        table.unused.insert(table.unused.end(), {"qw", "qx", "qy", "qz"});
    RandomStream random(seed_of(o, input));
    for (Body& body : table.bodies)
        body.orientation = at_random ? shape::random_orientation(random) : turned(shape, body.orientation);
}

Source read_csv(OptionValues const& o, RunInput const& input, Regions const&)
{
    auto table = read_particle_csv(*input.files.at(o.text("file")), o.text("file"));
    in_place(place_of(o), [&] {
        auto const shape = shape_of(input, o);
        orient(table, o, input, shape);
        for (Body& body : table.bodies) {
            body.place += millimetres(o, "shift_mm");
            body.radius = radius_of(shape, 2 * body.radius);
            body.shape = shape.shape;
        }
    });
    return table;
}

Source read_packing(OptionValues const& o, RunInput const& input, Regions const& regions)
{
    auto const where = place_of(o);
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
    packing.grains = one_size ? grain::Grains(shape::SizeDistribution({packing.diameter}, {1}))
                              : grains_of(input, sizes, *packing.sizes);
    packing.count = o.integer("count");
    packing.mass = o.number("mass_kg");
    if ((packing.count > 0) == (packing.mass > 0))
        throw InputError(where + " needs either count or mass_kg");
    packing.batches = static_cast<int>(o.integer("batches"));
    packing.every = o.number("every_s");
    if ((packing.batches > 1) != (packing.every > 0))
        throw InputError(where + " needs both batches and every_s to be an inlet");
    return packing;
}

//! Spheres of one diameter that come closest to the mass; at least one.
std::size_t count_of_mass(Packing const& packing, double density)
{
    return static_cast<std::size_t>(
        std::llround(std::max(1.0, packing.mass / sphere_mass(packing.diameter, density))));
}

using SourceKind = ReadKind<Source, RunInput const&, Regions const&>;

std::vector<SourceKind> make_sources()
{
    auto const velocity = vector("velocity_m_s", {}, "velocity at first [m/s]");
    auto const shapes = shape_options();
    return {{{"body", "one grain",
              joined({{required(number("diameter_mm", 0, "diameter; of a shape what it calls its size [mm]",
                                       positive)),
                       required_vector("place_mm", "centre of mass [mm]"), velocity,
                       vector("spin_rad_s", {}, "angular velocity at first [rad/s]"),
                       number("clearance_mm", not_given,
                              "its lowest point enters so high above the mean surface of the particles then "
                              "there; how high place_mm is is not used [mm]",
                              0)},
                      shapes,
                      {turn_option()}})},
             read_body},
            {{"csv", "grains from a table, of one shape",
              joined({{file("file", "CSV with the header x,y,z,radius and, if known, vx,vy,vz, wx,wy,wz and "
                                    "qw,qx,qy,qz, in m, m/s and rad/s; the radius is half of what a shape "
                                    "calls its size, the quaternion turns it from as it is given"),
                       vector("shift_mm", {}, "added to all places [mm]")},
                      shapes})},
             read_csv},
            {{"packing",
              "spheres at random places, which depend on the run's seed",
              {required(entry("region", "region", "where; whole spheres lie in it")),
               entry("within", "region", "lie whole in this one too; empty: none"),
               entry("size_distribution", "size_distribution", "sizes of the spheres"),
               number("diameter_mm", 0, "diameter of all, instead of size_distribution [mm]", 0),
               integer("count", 0, "number of spheres", 0, 1e8),
               number("mass_kg", 0, "mass of all together, instead of count [kg]", 0), velocity,
               integer("batches", 1,
                       "an inlet: so often, as long as its stage lasts, with other places each time", 1, 1e6),
               number("every_s", 0, "of an inlet: from one batch to the next [s]", 0)}},
             read_packing}};
}

std::vector<SourceKind> const& sources()
{
    static auto const all = make_sources();
    return all;
}

} // namespace

TableSpec particles_table()
{
    return {.key = "particles",
            .doc = "a group of particles that enter together",
            .options = {required_word("name", "its name"),
                        required(entry("material", "material", "material of the particles")),
                        entry("stage", "stage", "enters when this stage begins; empty: the first one")},
            .kind_key = "source",
            .kinds = keys_of(sources())};
}

bool ParticleGroup::is_one_body() const
{
    auto const* packing = std::get_if<Packing>(&source);
    return packing ? packing->count == 1 && packing->batches == 1
                   : std::get<ParticleTable>(source).bodies.size() == 1;
}

bool ParticleGroup::is_inlet() const
{
    auto const* packing = std::get_if<Packing>(&source);
    return packing && packing->batches > 1;
}

bool ParticleGroup::are_spheres() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return packing->grains->are_spheres();
    return !std::get<ParticleTable>(source).bodies.front().shape; // all are of one shape
}

bool ParticleGroup::have_hulls() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return packing->grains->have_hulls();
    auto const& shape = std::get<ParticleTable>(source).bodies.front().shape;
    return shape && shape->is_hull();
}

double ParticleGroup::smallest() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return packing->grains->smallest_ball();
    double diameter = std::numeric_limits<double>::infinity();
    for (Body const& body : std::get<ParticleTable>(source).bodies)
        diameter = std::min(diameter, 2 * body.radius * grain::smallest_ball(body.shape.get()));
    return diameter;
}

double ParticleGroup::largest() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return packing->grains->widest();
    double diameter = 0;
    for (Body const& body : std::get<ParticleTable>(source).bodies)
        diameter = std::max(diameter, 2 * body.reach());
    return diameter;
}

double Packing::batches_within(double duration) const
{
    return every > 0 ? std::min<double>(batches, 1 + std::floor(duration / every)) : 1;
}

double ParticleGroup::work_per_grain() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return packing->grains->work_per_grain();
    return grain::step_work(std::get<ParticleTable>(source).bodies.front().shape.get());
}

double ParticleGroup::expected_count(double density, double duration) const
{
    if (auto const* packing = std::get_if<Packing>(&source)) {
        double const batches = packing->batches_within(duration), mass = packing->mass * batches;
        if (packing->count > 0)
            return static_cast<double>(packing->count) * batches;
        if (!packing->grains->are_spheres())
            return mass / density * packing->grains->per_volume();
        double per_mass = 0; // mean of 1/m over the mass
        constexpr int samples = 100;
        for (int k = 0; k < samples; ++k) {
            double const d =
                packing->sizes ? packing->sizes->quantile((k + 0.5) / samples) : packing->diameter;
            per_mass += 1 / sphere_mass(d, density) / samples;
        }
        return mass * per_mass;
    }
    return static_cast<double>(std::get<ParticleTable>(source).bodies.size());
}

shape::BoxRegion ParticleGroup::bounds() const
{
    if (auto const* packing = std::get_if<Packing>(&source))
        return shape::bounds(packing->region);
    auto const box_of = [](Body const& body) {
        return shape::bounds(shape::BallRegion{body.place, body.reach()});
    };
    auto const& bodies = std::get<ParticleTable>(source).bodies;
    auto box = box_of(bodies.front());
    for (auto const& body : bodies)
        box = hull(box, box_of(body));
    return box;
}

std::vector<ParticleGroup> read_particles(RunInput const& input, Regions const& regions)
{
    std::vector<ParticleGroup> groups;
    auto const& stages = input.experiment.tables("stage");
    for (auto const& o : input.experiment.tables("particles")) {
        ParticleGroup group{o.text("name"),
                            o.text("material"),
                            position_of(stages, o.text("stage"), 0),
                            kind_named(sources(), o.text("source")).read(o, input, regions),
                            {}};
        if (o.has("clearance_mm") && !is_absent(o.number("clearance_mm")))
            group.clearance = 1e-3 * o.number("clearance_mm");
        groups.push_back(std::move(group));
    }
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (std::size_t later = g + 1; later < groups.size(); ++later)
            if (groups[g].is_inlet() && groups[later].stage == groups[g].stage)
                throw InputError(
                    fmt::format("particles.{} enters in batches, and particles.{} in the same stage "
                                "after it; list the inlet last, and one a stage",
                                groups[g].name, groups[later].name));
    if (groups.empty())
        throw InputError("there are no particles; give at least one table [[experiment.particles]]");
    return groups;
}

std::vector<std::string> particle_warnings(ParticleGroup const& group, double density)
{
    std::vector<std::string> warnings;
    if (auto const* table = std::get_if<ParticleTable>(&group.source); table && !table->unused.empty())
        warnings.push_back(
            fmt::format("columns of the table that are not used: {}", fmt::join(table->unused, ", ")));
    if (auto const* packing = std::get_if<Packing>(&group.source)) {
        std::string missed;
        if (packing->sizes && packing->count > 1) {
            RandomStream any_order(1);
            std::vector<double> diameters;
            double mass = 0;
            for (auto const& grain : sample_of(*packing, density, any_order)) {
                diameters.push_back(grain.diameter);
                mass += sphere_mass(grain.diameter, density);
            }
            if (packing->grains->are_spheres())
                missed = shape::SampleCheck(*packing->sizes, diameters, mass, density).warning;
        } else if (packing->sizes && packing->count == 0) {
            missed = packing->grains->sample_warning(packing->mass, density);
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

std::vector<grain::Grain> sample_of(Packing const& packing, double density, RandomStream& random)
{
    auto const of_mass = [&](double mass) {
        RandomStream same_numbers = random;
        return packing.grains->sample_mass(mass, density, same_numbers);
    };
    if (!packing.sizes) {
        auto const count =
            packing.count > 0 ? static_cast<std::size_t>(packing.count) : count_of_mass(packing, density);
        return std::vector<grain::Grain>(count, {packing.diameter, 0});
    }
    if (packing.count == 0) {
        RandomStream same_numbers = random;
        return in_place(packing.where,
                        [&] { return packing.grains->sample_whole(packing.mass, density, same_numbers); });
    }
    // The mass that has as many spheres; one too many goes.
    auto const wanted = static_cast<std::size_t>(packing.count);
    double too_little = 0,
           enough = sphere_mass(packing.grains->largest(), density) * static_cast<double>(wanted + 1);
    for (int k = 0; k < 50; ++k) {
        double const middle = 0.5 * (too_little + enough);
        (of_mass(middle).size() < wanted ? too_little : enough) = middle;
    }
    auto grains = of_mass(enough);
    grains.resize(wanted);
    return grains;
}

} // namespace demens::rig::custom
