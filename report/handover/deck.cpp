#include "report/handover/parameters.hpp"
#include "report/handover/scene.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::report {
namespace {

std::int64_t steps_of(Scene const& scene)
{
    return std::max<std::int64_t>(1, std::llround(std::ceil(scene.duration / scene.options.time_step)));
}

std::string beginning(Scene const& scene, std::string const& name, char const* code, char const* velocities)
{
    auto const& bodies = scene.bodies;
    double const smallest = std::min_element(bodies.begin(), bodies.end(), [](auto const& a, auto const& b) {
                                return a.radius < b.radius;
                            })->radius;
    auto text = fmt::format("# {} for {}: what stands there at first, in SI units.\n", name, code);
    for (auto const& note : left_out(scene))
        text += "# " + note + "\n";
    return text +
           fmt::format("units si\natom_style sphere\natom_modify map array\nboundary f f f\nnewton off\n{}\n"
                       "read_data {}.data\nneighbor {} bin\nneigh_modify delay 0\n\n",
                       velocities, name, smallest);
}

std::string end(Scene const& scene, std::string const& name)
{
    Vector3 const& g = scene.options.gravity;
    std::int64_t const steps = steps_of(scene);
    auto text = std::string("\n");
    if (norm(g) > 0)
        text += fmt::format("fix gravity all gravity {} vector {} {} {}\n", norm(g), g.x, g.y, g.z);
    return text +
           fmt::format("fix integrate all nve/sphere\ntimestep {}\n\n"
                       "variable mean_x equal xcm(all,x)\nvariable mean_z equal xcm(all,z)\n"
                       "variable top_z equal bound(all,zmax)\n"
                       "variable mean_vx equal vcm(all,x)\nvariable mean_vz equal vcm(all,z)\n"
                       "thermo_style custom step atoms ke v_mean_x v_mean_z v_top_z v_mean_vx v_mean_vz\n"
                       "thermo_modify lost warn norm no\nthermo {}\nrun {}\n\n"
                       "write_dump all custom {}.final.dump id type radius x y z vx vy vz omegax omegay "
                       "omegaz\n",
                       scene.options.time_step, std::max<std::int64_t>(1, steps / 20), steps, name);
}

//! Which coordinate a direction is along, -1: none.
int axis_of(Vector3 const& unit)
{
    constexpr double along = 1 - 1e-12;
    return std::abs(unit.x) > along ? 0 : std::abs(unit.y) > along ? 1 : std::abs(unit.z) > along ? 2 : -1;
}

//! A plane through a point, seen from the particles.
std::string plane(Scene const& scene, Vector3 const& through, Vector3 normal)
{
    if (dot(scene.middle() - through, normal) < 0)
        normal = -1.0 * normal;
    return fmt::format("plane {} {} {} {} {} {} side in units box", through.x, through.y, through.z, normal.x,
                       normal.y, normal.z);
}

std::string region_of(Scene const& scene, dem::Rectangle const& r)
{
    return plane(scene, r.centre, cross(r.axis_u, r.axis_v));
}

std::string region_of(Scene const& scene, dem::Disc const& disc)
{
    return plane(scene, disc.centre, disc.axis);
}

//! Cylinders and cones along an axis, with the particles inside.
template <class Shape>
std::string region_of(Scene const&, Shape const& shape)
{
    if constexpr (dem::RoundShape<Shape>) {
        int const axis = axis_of(shape.axis);
        if (axis < 0)
            return {};
        auto const m = dem::meridian(shape);
        double const centre[] = {shape.centre.x, shape.centre.y, shape.centre.z},
                     direction[] = {shape.axis.x, shape.axis.y, shape.axis.z};
        bool const forwards = direction[axis] > 0;
        double const start = centre[axis] + direction[axis] * m.height_start,
                     stop = centre[axis] + direction[axis] * m.height_end;
        return fmt::format("cone {} {} {} {} {} {} {} open 1 open 2 side in units box", "xyz"[axis],
                           centre[axis == 0 ? 1 : 0], centre[axis == 2 ? 1 : 2],
                           forwards ? m.radius_start : m.radius_end, forwards ? m.radius_end : m.radius_start,
                           forwards ? start : stop, forwards ? stop : start);
    }
    return {};
}

} // namespace

std::string liggghts_deck(Scene const& scene, std::string const& name)
{
    auto const& model = scene.model;
    auto text = beginning(scene, name, "LIGGGHTS", "communicate single vel yes");
    for (auto const& fault : liggghts_faults(model))
        text += "# " + fault + "\n";
    auto const models = liggghts_models(model), keywords = liggghts_keywords(model);
    text += liggghts_properties(model) + "pair_style gran " + models + keywords + "\npair_coeff * *\n\n";
    std::string names;
    int count = 0;
    auto const& walls = scene.walls;
    for (std::size_t k = 0; k < walls.size(); ++k)
        if (is_written(walls[k])) {
            text += fmt::format("fix wall{0} all mesh/surface file {1}.wall{0}.stl type {2}\n", k + 1, name,
                                walls[k].material.value + 1);
            names += fmt::format(" wall{}", k + 1);
            ++count;
        }
    if (count > 0)
        text += fmt::format("fix walls all wall/gran {} mesh n_meshes {} meshes{}{}\n", models, count, names,
                            keywords);
    return text + end(scene, name);
}

std::string lammps_deck(Scene const& scene, std::string const& name)
{
    auto const& model = scene.model;
    auto text = beginning(scene, name, "LAMMPS", "comm_modify mode single vel yes");
    auto const& materials = model.materials;
    text += "pair_style granular\n";
    for (std::size_t i = 0; i < materials.size(); ++i)
        for (std::size_t j = i; j < materials.size(); ++j)
            text += fmt::format("pair_coeff {} {} {}\n", i + 1, j + 1,
                                lammps_coefficients(model, materials[i].name, materials[j].name));
    text += "\n";
    for (std::size_t i = 0; i < materials.size(); ++i)
        text += fmt::format("group {} type {}\n", materials[i].name, i + 1);
    auto const& walls = scene.walls;
    for (std::size_t k = 0; k < walls.size(); ++k) {
        if (!is_written(walls[k]))
            continue;
        auto const region =
            std::visit([&](auto const& shape) { return region_of(scene, shape); }, walls[k].shape);
        if (region.empty()) {
            text +=
                fmt::format("# wall {} has no counterpart: a mesh, or round and not along an axis\n", k + 1);
            continue;
        }
        text += fmt::format("region wall{} {}\n", k + 1, region);
        for (std::size_t i = 0; i < materials.size(); ++i) {
            bool const used = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                          [&](auto const& body) { return body.material.value == i; });
            if (used)
                text += fmt::format(
                    "fix wall{0}_{1} {1} wall/gran/region granular {2} region wall{0}\n", k + 1,
                    materials[i].name,
                    lammps_coefficients(model, materials[i].name, materials[walls[k].material.value].name));
        }
    }
    return text + end(scene, name);
}

} // namespace demens::report
