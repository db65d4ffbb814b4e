#include "src/dem/cpu/decomposition/ghost_exchange.hpp"

#include "demens/base/error.hpp"
#include "src/dem/cpu/decomposition/body_parcels.hpp"
#include "src/dem/cpu/decomposition/particle_parcels.hpp"

#include <map>

namespace demens::dem {

void GhostExchange::rebuild(Team& team, Bisection const& boxes, State& state, double reach)
{
    Particles& particles = state.particles;
    std::map<int, std::vector<std::uint32_t>> near; // by rank
    std::size_t const owned = particles.size(), numbers = record(particles.has_hulls);
    int const here = team.rank();
    for (std::uint32_t i = 0; i < owned; ++i) {
        Place const& place = particles.place[i];
        double const distance = place.radius + reach;
        if (boxes.is_deep_inside(here, place, distance))
            continue;
        boxes.for_each_near(place, distance, [&](int rank) {
            if (rank != here)
                near[rank].push_back(i);
        });
    }

    std::vector<Team::Parcel> parcels;
    std::map<int, Team::Link> links;
    sent_.clear();
    for (auto const& [rank, which] : near) {
        ByteWriter out(parcels.emplace_back(Team::Parcel{rank, {}}).bytes);
        write_particles(out, particles, which, Loads::stay);
        if (particles.has_hulls)
            write_ghost_hulls(out, state, which);
        links[rank] = {rank, numbers * sent_.size(), numbers * which.size(), 0, 0};
        sent_.insert(sent_.end(), which.begin(), which.end());
    }
    for (auto const& parcel : team.exchange(parcels)) {
        ByteReader in(parcel.bytes);
        std::size_t const before = particles.size() - owned;
        auto const count = append_particles(in, particles, Loads::stay);
        if (particles.has_hulls)
            read_ghost_hulls(in, state, owned + before);
        auto& link = links[parcel.rank];
        link.rank = parcel.rank, link.in_begin = numbers * before, link.in_count = numbers * count;
    }
    particles.ghosts = particles.size() - owned;
    received_.clear();
    for (std::size_t k = owned; k < particles.size(); ++k)
        received_.push_back(static_cast<std::uint32_t>(k));
    links_.clear();
    for (auto const& [rank, link] : links)
        links_.push_back(link);
    resize_buffers(particles.has_hulls);
}

void GhostExchange::resize_buffers(bool has_hulls)
{
    out_.resize(record(has_hulls) * sent_.size());
    in_.resize(record(has_hulls) * received_.size());
}

void GhostExchange::renumber(std::span<std::uint32_t const> new_number)
{
    for (auto* numbers : {&sent_, &received_})
        for (std::uint32_t& k : *numbers)
            k = new_number[k];
}

void GhostExchange::begin(Team& team, State const& state)
{
    Particles const& particles = state.particles;
    std::size_t const numbers = record(particles.has_hulls);
    double* to = out_.data();
    for (std::uint32_t const k : sent_) {
        Place const& p = particles.place[k];
        Motion const& m = particles.motion[k];
        to[0] = p.x, to[1] = p.y, to[2] = p.z;
        to[3] = m.vx, to[4] = m.vy, to[5] = m.vz;
        to[6] = m.wx, to[7] = m.wy, to[8] = m.wz;
        if (particles.is_hull(k)) {
            Quaternion const& turned = state.bodies.pose[particles.body[k]].orientation;
            to[9] = turned.w, to[10] = turned.x, to[11] = turned.y, to[12] = turned.z;
        }
        to += numbers;
    }
    team.begin(links_, out_.data(), in_.data());
}

void GhostExchange::finish(Team& team, State& state)
{
    team.finish();
    Particles& particles = state.particles;
    RigidBodies& bodies = state.bodies;
    std::size_t const numbers = record(particles.has_hulls);
    double const* from = in_.data();
    for (std::uint32_t const k : received_) {
        Place& p = particles.place[k];
        Motion& m = particles.motion[k];
        p.x = from[0], p.y = from[1], p.z = from[2];
        m.vx = from[3], m.vy = from[4], m.vz = from[5];
        m.wx = from[6], m.wy = from[7], m.wz = from[8];
        particles.load[k] = {};
        if (particles.is_hull(k))
            bodies.ghosts.orientation[particles.body[k] - bodies.size()] = {from[9], from[10], from[11],
                                                                            from[12]};
        from += numbers;
    }
}

GhostExchange::Routes GhostExchange::routes() const
{
    Routes routes{sent_, received_, {}};
    for (Team::Link const& link : links_) {
        routes.links.push_back(link.rank);
        for (std::size_t const number : {link.out_begin, link.out_count, link.in_begin, link.in_count})
            routes.links.push_back(static_cast<std::int64_t>(number));
    }
    return routes;
}

void GhostExchange::restore(Routes const& routes, Team const& team, std::size_t particles, bool has_hulls)
{
    auto const expect = [](bool fits) {
        if (!fits)
            throw InputError("the state record does not fit together: the routes of its ghosts lead nowhere");
    };
    for (auto const* numbers : {&routes.sent, &routes.received})
        for (std::uint32_t const k : *numbers)
            expect(k < particles);
    expect(routes.links.size() % 5 == 0);
    std::vector<Team::Link> links;
    auto const out = static_cast<std::int64_t>(record(has_hulls) * routes.sent.size());
    auto const in = static_cast<std::int64_t>(record(has_hulls) * routes.received.size());
    for (std::size_t k = 0; k < routes.links.size(); k += 5) {
        std::int64_t const* link = routes.links.data() + k;
        expect(link[0] >= 0 && link[0] < team.size());
        expect(link[1] >= 0 && link[1] <= out && link[2] >= 0 && link[2] <= out - link[1]);
        expect(link[3] >= 0 && link[3] <= in && link[4] >= 0 && link[4] <= in - link[3]);
        links.push_back({static_cast<int>(link[0]), static_cast<std::size_t>(link[1]),
                         static_cast<std::size_t>(link[2]), static_cast<std::size_t>(link[3]),
                         static_cast<std::size_t>(link[4])});
    }
    sent_ = routes.sent, received_ = routes.received, links_ = std::move(links);
    resize_buffers(has_hulls);
}

} // namespace demens::dem
