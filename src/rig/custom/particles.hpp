#pragma once

#include "demens/rig/rig.hpp"
#include "demens/shape/packing.hpp"
#include "src/rig/custom/particle_csv.hpp"
#include "src/rig/custom/regions.hpp"

#include <optional>
#include <variant>

namespace demens::rig::custom {

//! `[[experiment.particles]]`
TableSpec particles_table();

//! Grains at random places in a region.
struct Packing
{
    shape::Region region;
    std::optional<shape::Region> within = {};          //!< lies in this one too
    std::optional<shape::SizeDistribution> sizes = {}; //!< none: all of one diameter
    std::optional<grain::Grains> grains = {};          //!< of these sizes, or of the diameter
    double diameter = 0;                               //!< of all, where there is no distribution [m]
    std::int64_t count = 0;                            //!< 0: as many as make the mass
    double mass = 0;                                   //!< [kg]
    Vector3 velocity = {};                             //!< [m/s]
    int batches = 1;                                   //!< so often
    double every = 0;                                  //!< [s] from one batch to the next
    std::string where = {};                            //!< its table in messages

    //! How many batches enter within so long [s].
    double batches_within(double duration) const;
};

//! Particles that enter together.
struct ParticleGroup
{
    std::string name, material;
    std::size_t stage; //!< at whose beginning they enter
    std::variant<ParticleTable, Packing> source;
    //! Of the lowest point of one body above the mean surface of the particles then there; none: it enters
    //! where it was given [m].
    std::optional<double> clearance;

    bool is_one_body() const;
    //! Whether it goes on entering while its stage lasts.
    bool is_inlet() const;
    bool are_spheres() const;
    bool have_hulls() const; //!< among them
    double smallest() const; //!< diameter [m]; of other grains that of their smallest sphere
    double largest() const;  //!< diameter of what holds a grain [m]
    //! \param duration of its stage at most, in which an inlet enters [s]
    double expected_count(double density, double duration) const;
    double work_per_grain() const;   //!< of a step, over a sphere's
    shape::BoxRegion bounds() const; //!< of where they enter
};

//! \throws InputError for what is wrong in one group; where they are is checked later
std::vector<ParticleGroup> read_particles(RunInput const& input, Regions const& regions);

//! What a group's author may not expect: columns that are not used, masses that whole spheres cannot meet.
std::vector<std::string> particle_warnings(ParticleGroup const& group, double density);

//! Grains of a packing. \throws InputError where whole ones leave a class of sizes out
std::vector<grain::Grain> sample_of(Packing const& packing, double density, RandomStream& random);

} // namespace demens::rig::custom
