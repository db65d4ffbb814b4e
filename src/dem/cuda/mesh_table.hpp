#pragma once

#include "demens/dem/wall.hpp"
#include "src/dem/cuda/flat_wall.hpp"

#include <memory>
#include <span>
#include <vector>

namespace demens::dem::cuda {

//! The meshes of all walls of a batch, each once: one behind the other in the arrays of a device.
class MeshTable
{
  public:
    //! Only the meshes of these walls from now on.
    void begin();
    void add(std::vector<Wall> const& walls);
    //! Whether there are others than before `begin`.
    bool has_changed() const { return is_new_; }

    std::uint32_t facets() const { return end_.facet; }
    std::uint32_t nodes() const { return end_.node; }
    //! Where the mesh of a wall is; nowhere for other walls.
    MeshPlace place_of(Wall const& wall) const;

    //! Of all meshes, one mesh behind the other. Numbers in a mesh are those of it alone.
    std::vector<shape::Facet> all_facets() const;
    std::vector<shape::TreeNode> all_nodes() const;
    std::vector<std::uint32_t> all_orders() const;

  private:
    using Pointer = std::shared_ptr<shape::TriangleMesh const>;
    struct Entry
    {
        Pointer mesh;
        MeshPlace at;
    };

    std::vector<Entry> meshes_; //!< no two alike
    std::vector<Entry> alike_;  //!< what walls hold, with the place of the one that it is like
    std::vector<Entry> before_;
    MeshPlace end_;
    bool is_new_ = false;
};

} // namespace demens::dem::cuda
