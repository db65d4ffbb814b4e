#include "demens/grain/mesh_mass.hpp"

#include "demens/base/error.hpp"

#include <fmt/format.h>

namespace demens::grain {

VolumeMoments of_tetrahedron(Vector3 const& a, Vector3 const& b, Vector3 const& c)
{
    double const volume = dot(a, cross(b, c)) / 6;
    Vector3 const sum = a + b + c;
    return {volume, 0.25 * volume * sum,
            0.05 * volume * (products(sum) + products(a) + products(b) + products(c))};
}

VolumeMoments volume_moments(shape::TriangleMesh const& mesh)
{
    VolumeMoments moments;
    for (shape::Facet const& facet : mesh.facets()) {
        Vector3 const a = facet.corner - mesh.centre();
        moments += of_tetrahedron(a, a + facet.side_1, a + facet.side_2);
    }
    return moments.shifted(mesh.centre());
}

MassProperties mass_properties(shape::TriangleMesh const& mesh, std::string const& origin)
{
    shape::MeshFaults const& faults = mesh.faults();
    if (faults.open_edges > 0 || faults.manifold_faults > 0)
        throw InputError(
            fmt::format("{}: a body needs a closed surface, but {}; close it in the program that "
                        "made it",
                        origin, faults.warnings().back()));
    VolumeMoments moments = volume_moments(mesh);
    if (moments.volume < 0)
        moments = {-moments.volume, -moments.first, -1 * moments.second};
    double const extent = mesh.extent();
    if (!(moments.volume > 1e-9 * extent * extent * extent))
        throw InputError(
            fmt::format("{}: the surface holds a volume of {:.3g} m^3, next to nothing for its "
                        "size of {:.3g} m: is it flat, or do some of its triangles face inwards?",
                        origin, moments.volume, 2 * extent));
    return mass_properties_of(moments);
}

} // namespace demens::grain
