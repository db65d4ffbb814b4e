#pragma once

#include "src/dem/cuda/batch.hpp"

#include <cstddef>
#include <utility>

namespace demens::dem::cuda {

//! An array on a device.
template <class Number>
class DeviceArray
{
  public:
    DeviceArray() = default;
    DeviceArray(Device& device, std::size_t count)
        : device_(&device), data_(static_cast<Number*>(device.allocate(count * sizeof(Number))))
    {
    }
    DeviceArray(DeviceArray&& other) noexcept
        : device_(other.device_), data_(std::exchange(other.data_, nullptr))
    {
    }
    DeviceArray& operator=(DeviceArray&& other) noexcept
    {
        std::swap(device_, other.device_);
        std::swap(data_, other.data_);
        return *this;
    }
    ~DeviceArray()
    {
        if (data_ != nullptr)
            device_->release(data_);
    }

    Number* data() const { return data_; }

  private:
    Device* device_ = nullptr;
    Number* data_ = nullptr;
};

//! All arrays of a view.
struct Batch::Arrays
{
    DeviceArray<Replica> replica;
    DeviceArray<Place> place, seen;
    DeviceArray<Motion> motion;
    DeviceArray<Load> load;
    DeviceArray<std::uint32_t> material, id, neighbours, neighbour, touching, near_walls, near_wall,
        touching_walls, near_meshes, cell_of, place_in_cell, bucket, new_index, old_index, cell_start, sums,
        sums_of_sums, interaction;
    DeviceArray<Tally> tallies;
    DeviceArray<double> history, wall_history, wall_paths;
    DeviceArray<std::byte> laws, layouts, ranges, walls, facets, nodes, orders;

    Arrays(Device& device, Room const& room, View& view)
    {
        std::size_t const slots = room.slots, all = std::size_t{slots} * room.particles, cells = room.cells;
        view.room = room;
        view.all = all;
        auto const make = [&]<class Number>(DeviceArray<Number>& array, std::size_t count) {
            array = DeviceArray<Number>(device, count);
            return array.data();
        };
        auto const make_table = [&]<class Number>(DeviceArray<std::byte>& array, Number const*& in_view,
                                                  std::size_t count) {
            in_view = reinterpret_cast<Number const*>(make(array, count * sizeof(Number)));
        };
        view.replica = make(replica, slots);
        view.place = make(place, 2 * all);
        view.motion = make(motion, 2 * all);
        view.load = make(load, all);
        view.seen = make(seen, 2 * all);
        view.material = make(material, 2 * all);
        view.id = make(id, 2 * all);
        view.neighbours = make(neighbours, 2 * all);
        view.neighbour = make(neighbour, 2 * all * room.neighbours);
        view.touching = make(touching, 2 * all * (room.neighbours / bits_of_word));
        view.history = make(history, 2 * all * room.neighbours * room.history);
        view.near_walls = make(near_walls, 2 * all);
        view.near_wall = make(near_wall, 2 * all * room.walls);
        view.touching_walls = make(touching_walls, 2 * all);
        view.near_meshes = make(near_meshes, all);
        view.tallies = make(tallies, room.has_ledger ? all : 0);
        view.wall_history = make(wall_history, 2 * all * room.walls * (room.history + wall_numbers));
        view.cell_of = make(cell_of, all);
        view.place_in_cell = make(place_in_cell, all);
        view.bucket = make(bucket, all);
        view.new_index = make(new_index, all);
        view.old_index = make(old_index, all);
        view.cell_start = make(cell_start, slots * (cells + 1));
        view.sums = make(sums, slots * (cells / 32 + 1));
        view.sums_of_sums = make(sums_of_sums, slots * (cells / 1024 + 1));
        view.interaction = make(interaction, slots * room.materials * room.materials);
        view.wall_paths = make(wall_paths, slots * (rows_of_block + 1));
        make_table(laws, view.laws, slots * room.laws);
        make_table(layouts, view.layouts, slots * room.laws);
        make_table(ranges, view.ranges, slots * room.laws);
        make_table(walls, view.walls, slots * room.wall_table);
        make_table(facets, view.facets, room.facets);
        make_table(nodes, view.nodes, room.nodes);
        make_table(orders, view.orders, room.facets);
    }
};

} // namespace demens::dem::cuda
