#include "src/dem/cpu/decomposition/particle_parcels.hpp"

namespace demens::dem {
namespace {

//! The arrays that travel.
template <class P, class Visit>
void for_each_array(P& particles, Loads loads, Visit&& visit)
{
    visit(particles.place), visit(particles.motion), visit(particles.material), visit(particles.id);
    if (loads == Loads::travel)
        visit(particles.load);
}

} // namespace

void write_particles(ByteWriter& out, Particles const& particles, std::span<std::uint32_t const> which,
                     Loads loads)
{
    out.put(static_cast<std::uint64_t>(which.size()));
    for_each_array(particles, loads, [&]<class T>(std::vector<T> const& values) {
        for (std::uint32_t const k : which)
            out.put(values[k]);
    });
}

std::size_t append_particles(ByteReader& in, Particles& particles, Loads loads)
{
    auto const count = static_cast<std::size_t>(in.get<std::uint64_t>());
    std::size_t const before = particles.size();
    particles.resize(before + count);
    for_each_array(particles, loads,
                   [&]<class T>(std::vector<T>& values) { in.get(values.data() + before, count); });
    return count;
}

} // namespace demens::dem
