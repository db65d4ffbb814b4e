#pragma once

#include "demens/base/error.hpp"
#include "demens/rig/rig.hpp"
#include "ensemble/input/campaign_input.hpp"
#include "tests/support/fault_of.hpp"

namespace demens::test {

//! Two rigs of which only the tables matter: `hopper` with every type of option, `plate` with few.
inline std::vector<rig::RigInfo> const& rigs()
{
    auto const check = [](rig::RunInput const& input) {
        if (input.experiment.number("mass_kg") > 100)
            throw InputError("mass_kg is more than the box holds; at most 100");
    };
    static std::vector<rig::RigInfo> const rigs = {
        {.name = "hopper",
         .doc = "a box with a gate",
         .options =
             {{.key = "material",
               .default_value = std::string(),
               .doc = "of the particles",
               .required = true,
               .names_entry_of = "material"},
              {.key = "sizes",
               .default_value = std::string(),
               .doc = "of the particles",
               .names_entry_of = "size_distribution"},
              {.key = "mass_kg", .default_value = 1.0, .doc = "fill [kg]", .required = true, .lower = 0.001},
              {.key = "slot_mm", .default_value = 80.0, .doc = "slot [mm]", .lower = 1, .upper = 500},
              {.key = "layers", .default_value = std::int64_t{2}, .doc = "layers", .lower = 1},
              {.key = "periodic", .default_value = false, .doc = "no front and back"}},
         .responses = {{"angle_deg", "deg", "slope of the heap"}, {"flow_kg_s", "kg/s", "rate of outflow"}},
         .check = check,
         .predict_cost = {},
         .run = {}},
        {.name = "plate",
         .doc = "one sphere on a plate",
         .options = {{.key = "speed_m_s", .default_value = 1.0, .doc = "before impact [m/s]", .lower = 0}},
         .responses = {{"rebound", "1", "ratio of speeds"}},
         .check = {},
         .predict_cost = {},
         .run = {}},
    };
    return rigs;
}

//! A correct campaign that uses every section and every type of key.
inline std::string good_campaign()
{
    return R"([campaign]
name = "test"
seed = 7

[material.quartz]
density = 2604.1
youngs_modulus = 1e7
poisson_ratio = 0.3

[material.wood_dry]
density = 700

[contact.quartz_quartz]
normal = "hysteretic_spring"
tangential = "linear_coulomb"
rolling = "epsd"
restitution = 0.3719
static_friction = 0.9
kinetic_friction = 0.8
rolling_friction = 0.2

[contact.wood_dry_quartz]
restitution = 0.3
static_friction = 0.7
allow_attraction = false

[size_distribution.half_inch]
diameters_mm = [12.7, 25.4]
cumulative_mass_fraction = [0.0, 1.0]

[size_distribution.two]
classes_mm = [10, 20]
mass_fraction = [0.25, 0.75]

[[experiment]]
name = "bench"
rig = "hopper"
replicates = 2
material = "quartz"
sizes = "half_inch"
mass_kg = 25.75
slot_mm = 86
layers = 3
periodic = true
target.angle_deg = { value = 26.25, scale = 2.0, sd = 0.8, tolerance = 1.0 }
target.flow_kg_s = { value = 4.83, scale = 0.3 }

[[experiment]]
name = "drop"
rig = "plate"
speed_m_s = 2.5
target.rebound = { value = 0.4, scale = 0.1 }

[[factor]]
path = "contact.quartz_quartz.static_friction"
lower = 0.1
upper = 1.2

[[factor]]
path = "contact.quartz_quartz.kinetic_friction"
name = "mu_k"
lower = 0.1
upper = 1.2

[[factor]]
path = "material.quartz.youngs_modulus"
lower = 1e6
upper = 1e8
scale = "log"

[[constraint]]
expression = "mu_k <= static_friction"

[design]
kind = "latin_hypercube"
points = 12

[surrogate]
kind = "rbf"

[search]
batch = 4

[solver]
kind = "pounders"
starts = 10

[stop]
wmse = 0.05
within_tolerance = false
waves = 10
runs = 100
wall_time_s = 3600
no_improvement_waves = 3
confirmation = 2

[run]
ranks_per_group = 1
run_wall_time_s = 180
)";
}

//! The text with one piece of it replaced; the piece must be there.
inline std::string replaced(std::string text, std::string const& piece, std::string const& by)
{
    auto const at = text.find(piece);
    if (at == std::string::npos)
        throw std::logic_error("the test's campaign has no \"" + piece + "\"");
    return text.replace(at, piece.size(), by);
}

//! Reads a campaign of these rigs.
inline ensemble::CampaignInput read(std::string const& text)
{
    return ensemble::CampaignInput::from_text(text, "test.toml", rigs());
}

//! The message about a text; empty when it is accepted.
inline std::string message_about(std::string const& text)
{
    return fault_of([&] { read(text); });
}

} // namespace demens::test
