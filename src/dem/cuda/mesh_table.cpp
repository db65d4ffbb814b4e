#include "src/dem/cuda/mesh_table.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <utility>

namespace demens::dem::cuda {
namespace {

bool is_same(shape::TriangleMesh const& a, shape::TriangleMesh const& b)
{
    auto const alike = [](shape::Facet const& f, shape::Facet const& g) { return f.vertices == g.vertices; };
    return a.vertices() == b.vertices() &&
           std::equal(a.facets().begin(), a.facets().end(), b.facets().begin(), b.facets().end(), alike);
}

} // namespace

void MeshTable::begin()
{
    before_ = std::exchange(meshes_, {});
    alike_.clear();
    end_ = {};
    is_new_ = false;
}

void MeshTable::add(std::vector<Wall> const& walls)
{
    for (Wall const& wall : walls) {
        auto const* const shape = std::get_if<Mesh>(&wall.shape);
        if (shape == nullptr || std::any_of(alike_.begin(), alike_.end(),
                                            [&](Entry const& known) { return known.mesh == shape->mesh; }))
            continue;
        auto const found = std::find_if(meshes_.begin(), meshes_.end(), [&](Entry const& known) {
            return is_same(*known.mesh, *shape->mesh);
        });
        if (found != meshes_.end()) {
            alike_.push_back({shape->mesh, found->at});
            continue;
        }
        std::size_t const number = meshes_.size();
        // One that was in this place before: the arrays of the device have it already.
        is_new_ = is_new_ || number >= before_.size() || !is_same(*before_[number].mesh, *shape->mesh);
        meshes_.push_back({shape->mesh, end_});
        alike_.push_back(meshes_.back());
        end_.facet += static_cast<std::uint32_t>(shape->mesh->facets().size());
        end_.node += static_cast<std::uint32_t>(shape->mesh->tree().nodes().size());
    }
}

MeshPlace MeshTable::place_of(Wall const& wall) const
{
    auto const* const shape = std::get_if<Mesh>(&wall.shape);
    if (shape == nullptr)
        return {};
    auto const found = std::find_if(alike_.begin(), alike_.end(),
                                    [&](Entry const& known) { return known.mesh == shape->mesh; });
    DEMENS_EXPECT(found != alike_.end(), "a mesh of one of the walls that were added");
    return found->at;
}

namespace {

template <class Entry, class Part>
auto joined(std::vector<Entry> const& meshes, Part const& part)
{
    std::decay_t<decltype(part(*meshes.front().mesh))> all;
    for (Entry const& entry : meshes)
        all.insert(all.end(), part(*entry.mesh).begin(), part(*entry.mesh).end());
    return all;
}

} // namespace

std::vector<shape::Facet> MeshTable::all_facets() const
{
    return joined(
        meshes_, [](auto const& mesh) -> auto const& { return mesh.facets(); });
}
std::vector<shape::TreeNode> MeshTable::all_nodes() const
{
    return joined(
        meshes_, [](auto const& mesh) -> auto const& { return mesh.tree().nodes(); });
}
std::vector<std::uint32_t> MeshTable::all_orders() const
{
    return joined(
        meshes_, [](auto const& mesh) -> auto const& { return mesh.tree().order(); });
}

} // namespace demens::dem::cuda
