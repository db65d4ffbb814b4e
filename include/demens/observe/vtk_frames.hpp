#pragma once

#include "demens/observe/snapshot.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace demens::observe {

//! Frames for ParaView: one VTK PolyData file of the particles and one of the walls a frame, and the
//! collections `particles.pvd` and `walls.pvd` that join them over time. Grains that are hulls are in
//! `hulls.pvd` as they are, and among the particles as balls whose array `hull` is not 0. The collections are
//! complete after every frame.
class VtkFrames
{
  public:
    //! \throws InputError when the folder can neither be found nor made.
    explicit VtkFrames(std::filesystem::path folder);

    //! Adds a frame. \throws InputError when it cannot be written.
    void write(Snapshot const& snapshot);
    //! Number of frames so far.
    std::size_t size() const { return times_.size(); }
    //! How many there are, and how they are shown, for messages.
    std::string told() const;

  private:
    void write_collection(std::string const& name, std::size_t from) const;

    std::filesystem::path folder_;
    std::vector<double> times_;                        //!< of the frames [s]
    std::optional<std::size_t> first_with_hulls_ = {}; //!< frame
};

} // namespace demens::observe
