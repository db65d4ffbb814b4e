#include "src/dem/cpu/hulls/hull_mesh_finder.hpp"

#include "demens/grain/contact/wall_contacts.hpp"

#include <algorithm>
#include <array>

namespace demens::dem {
namespace {

using grain::ContactFeature;

// Parts of grain::feature_id.
ContactFeature kind_of(std::uint32_t feature)
{
    return static_cast<ContactFeature>(feature >> 24);
}
std::uint32_t of_hull(std::uint32_t feature)
{
    return feature >> 12 & 0xfff;
}
std::uint32_t of_wall(std::uint32_t feature)
{
    return feature & 0xfff;
}

//! A hull as a mesh sees it.
HullParty in_axes_of(Placement const& placement, HullParty hull)
{
    auto const& r = hull.pose.rotation;
    hull.pose.place = placement.inverse(hull.pose.place);
    hull.pose.rotation = {placement.rotation.inverse(r.x), placement.rotation.inverse(r.y),
                          placement.rotation.inverse(r.z)};
    return hull;
}

//! Whether the way from a point to another crosses a triangle.
bool is_crossed(shape::Facet const& facet, Vector3 const& from, Vector3 const& to)
{
    double const before = dot(from - facet.corner, facet.normal),
                 after = dot(to - facet.corner, facet.normal);
    return before * after < 0 &&
           facet.nearest(from + (before / (before - after)) * (to - from)).feature == shape::face;
}

//! Whether a contact lies on an edge: of a pair whose faces are not known the nearest places are told as of
//! edges.
bool is_on(shape::TriangleMesh const& mesh, std::uint32_t edge, grain::FeatureContact const& contact,
           double rounding)
{
    Vector3 const from = mesh.vertices()[mesh.edges()[edge].vertices[0]];
    Vector3 const along = mesh.vertices()[mesh.edges()[edge].vertices[1]] - from;
    Vector3 const place = contact.point - 0.5 * contact.overlap * contact.normal;
    return norm_squared(cross(place - from, along)) < 1e-12 * rounding * rounding * norm_squared(along);
}

//! \param of_mesh number of the edge or the vertex
void add(grain::ContactSet& set, grain::FeatureContact contact, std::uint32_t of_mesh)
{
    contact.feature = grain::feature_id(kind_of(contact.feature), of_hull(contact.feature),
                                        of_mesh % grain::features_of_second);
    set.add(contact);
    set.state = grain::CoreState::near;
}

//! Two edges, less what their ends count already, as in `grain::detail::FacePair`, of these ends alone.
void add_edges(grain::ContactSet& set, grain::FeatureContact const* first, grain::FeatureContact const* end,
               grain::FeatureContact edges, std::uint32_t of_mesh)
{
    auto const ratio = [&](grain::FeatureContact const& of) {
        double const depth = std::min(of.overlap / edges.overlap, 1.0);
        return depth * depth * std::sqrt(depth);
    };
    edges.share = 1;
    for (auto const* of = first; of != end; ++of)
        edges.share *= 1 - ratio(*of);
    for (auto const* of = first; of != end; ++of) {
        double others = 1;
        for (auto const* other = first; other != end; ++other)
            others *= other == of ? 1 : 1 - ratio(*other);
        edges.share += ratio(*of) * others;
        auto contact = *of;
        contact.share = -others;
        add(set, contact, of_mesh);
    }
    add(set, edges, of_mesh);
}

} // namespace

MeshFeatures const& HullMeshFinder::features_of(Mesh const& wall, std::uint32_t number)
{
    known_.resize(std::max<std::size_t>(known_.size(), number + 1));
    Known& known = known_[number];
    if (known.mesh != wall.mesh)
        known = {wall.mesh, std::make_unique<MeshFeatures>(*wall.mesh)};
    return *known.features;
}

bool HullMeshFinder::find(HullParty const& hull, double reach, Mesh const& wall, std::uint32_t number,
                          grain::ContactSet& set)
{
    set.count = 0;
    set.state = grain::CoreState::apart;
    HullParty const here = in_axes_of(wall.placement, hull);
    Vector3 const& centre = here.pose.place;
    shape::TriangleMesh const& mesh = *wall.mesh;
    near_.clear();
    mesh.tree().for_each_near(centre, reach, [&](std::uint32_t triangle) {
        shape::Facet const& facet = mesh.facets()[triangle];
        if (std::abs(dot(centre - facet.corner, facet.normal)) < reach &&
            norm_squared(facet.nearest(centre).offset) < reach * reach)
            near_.push_back({triangle, 0});
    });
    if (near_.empty())
        return false;
    std::sort(near_.begin(), near_.end(),
              [](NearTriangle const& a, NearTriangle const& b) { return a.triangle < b.triangle; });
    bool is_cut = add_vertices(here, mesh, set);
    MeshFeatures const& features = features_of(wall, number);
    seen_.clear();
    for (NearTriangle const& entry : near_) {
        shape::Facet const& facet = mesh.facets()[entry.triangle];
        if (features.may_touch(entry.triangle, dot(centre - facet.corner, facet.normal) > 0))
            is_cut |= add_ridges(here, mesh, features, entry.triangle, set);
    }
    for (int k = 0; k < set.count; ++k) {
        grain::FeatureContact& contact = set.contacts[k];
        contact.point = wall.placement(contact.point);
        contact.normal = wall.placement.rotation(contact.normal);
    }
    return is_cut;
}

bool HullMeshFinder::add_vertices(HullParty const& hull, shape::TriangleMesh const& mesh,
                                  grain::ContactSet& set)
{
    bool is_cut = false;
    std::vector<grain::FeatureContact> others; // of vertices that touch in several places
    for (std::uint16_t v = 0; v < hull.core.vertex_count; ++v) {
        Vector3 const p = hull.pose.place + hull.pose.rotation(hull.pose.scale * hull.core.vertices[v]);
        for (NearTriangle& entry : near_) {
            entry.due = 0;
            is_cut |= is_crossed(mesh.facets()[entry.triangle], hull.pose.place, p);
        }
        auto const offsets = balls_.find(mesh, near_, 0, {p, hull.rounding, hull.rounding});
        for (Vector3 const& offset : offsets) {
            double const distance = norm(offset);
            Vector3 const n = (-1 / distance) * offset;
            grain::FeatureContact const contact{p + 0.5 * (hull.rounding + distance) * n, n,
                                                hull.rounding - distance, 1,
                                                grain::feature_id(ContactFeature::vertex_of_a, v, 0)};
            if (&offset == offsets.data())
                set.add(contact);
            else
                others.push_back(contact);
        }
    }
    if (set.count > 0)
        set.state = grain::CoreState::near;
    if (set.count > 1)
        grain::share_places(set, hull.rounding);
    for (grain::FeatureContact const& contact : others)
        set.add(contact);
    return is_cut;
}

bool HullMeshFinder::add_ridges(HullParty const& hull, shape::TriangleMesh const& mesh,
                                MeshFeatures const& features, std::uint32_t triangle, grain::ContactSet& set)
{
    shape::Facet const& facet = mesh.facets()[triangle];
    // The triangle as a hull, about its first corner.
    std::array const vertices{Vector3{}, facet.side_1, facet.side_2};
    std::array faces{triangle_.faces()[0], triangle_.faces()[1]};
    faces[0].normal = facet.normal;
    faces[1].normal = -facet.normal;
    grain::CoreView core(triangle_);
    core.vertices = vertices.data();
    core.faces = faces.data();

    grain::PairMemory memory;
    Vector3 const away = facet.nearest(hull.pose.place).offset;
    grain::detail::remember_normal(memory, hull.pose.rotation.inverse(-away / norm(away)));
    grain::ContactSet& found = of_triangle_;
    grain::hull_contacts(grain::CorePair(hull.core, hull.pose, core, {facet.corner, {}, 1}), hull.rounding, 0,
                         memory, found);
    if (found.state == grain::CoreState::overlapping)
        return true;
    grain::put_in_space(found, hull.pose);

    auto const edge_of = [&](std::uint32_t feature) {
        auto const& [i, j] = triangle_.edges()[of_wall(feature)].vertices;
        return features.edge(triangle, i == 0 && j == 2 ? 2 : i);
    };
    auto const vertex_of = [&](std::uint32_t feature) { return facet.vertices[of_wall(feature)]; };
    int first = 0; // of the contacts of an edge with the ends of another, which stand before that of both
    for (int k = 0; k < found.count; ++k) {
        grain::FeatureContact const& contact = found.contacts[k];
        auto const kind = kind_of(contact.feature);
        if (kind == ContactFeature::vertex_of_a_on_edge || kind == ContactFeature::vertex_of_b_on_edge)
            continue;
        if (kind == ContactFeature::edges) {
            std::uint32_t const edge = edge_of(contact.feature);
            if (is_on(mesh, edge, contact, hull.rounding) && features.edge_touches(edge, -contact.normal) &&
                is_first(contact.feature, edge)) {
                auto const ends =
                    std::remove_if(found.contacts + first, found.contacts + k, [&](auto const& end) {
                        return kind_of(end.feature) == ContactFeature::vertex_of_b_on_edge &&
                               !features.is_sharp_corner(vertex_of(end.feature));
                    });
                add_edges(set, found.contacts + first, ends, contact, edge);
            }
        } else if (kind != ContactFeature::vertex_of_a) { // that is a ball
            std::uint32_t const vertex = vertex_of(contact.feature);
            // A corner touches a hull once, whatever face of it.
            bool const is_alone = kind == ContactFeature::vertex_of_b;
            if (features.corner_touches(vertex, -contact.normal) &&
                is_first(is_alone ? grain::feature_id(kind, 0, 0) : contact.feature, vertex))
                add(set, contact, vertex);
        }
        first = k + 1;
    }
    return false;
}

} // namespace demens::dem
