#pragma once

#include "demens/base/error.hpp"
#include "ensemble/input/campaign_input.hpp"

#include <map>
#include <stdexcept>
#include <string>

namespace demens::test {

//! Contents of files that a test's campaign names.
using TestFiles = std::map<std::string, std::string>;

//! A campaign of one experiment of the rig `custom`; line 19 is the first of `tables`.
inline std::string custom_campaign(std::string const& tables, std::string const& options = "")
{
    return R"([campaign]
name = "custom"
[material.glass]
density = 2500
[material.steel]
density = 7800
[contact.glass_glass]
restitution = 0.5
static_friction = 0.5
[contact.glass_steel]
restitution = 0.5
static_friction = 0.5
[[factor]]
path = "material.glass.poisson_ratio"
lower = 0.2
upper = 0.3
[[experiment]]
name = "bench"
rig = "custom"
)" + options +
           tables + R"(
[stop]
waves = 0
)";
}

inline ensemble::CampaignInput read_custom(std::string const& text, TestFiles const& files = {})
{
    return ensemble::CampaignInput::from_text(text, "test.toml", rig::all_rigs(),
                                              [files](std::string const& name) {
                                                  if (!files.count(name))
                                                      throw InputError(name + " cannot be read");
                                                  return files.at(name);
                                              });
}

//! What a campaign's first run gives.
inline rig::RunResult run_custom(std::string const& text, TestFiles const& files = {}, int replicate = 0)
{
    auto const input = read_custom(text, files);
    return input.experiments[0].rig->run(input.run_input({0.25}, 0, 0, replicate), {});
}

//! The response of that name of a run that must have finished.
inline double response_of(std::string const& text, std::string const& name, TestFiles const& files = {})
{
    auto const input = read_custom(text, files);
    auto const& experiment = input.experiments[0];
    auto const result = experiment.rig->run(input.run_input({0.25}, 0, 0, 0), {});
    if (result.status != rig::RunStatus::finished)
        throw std::runtime_error(result.reason);
    for (std::size_t k = 0; k < experiment.responses.size(); ++k)
        if (experiment.responses[k].name == name)
            return result.responses[k];
    throw std::logic_error("no response " + name);
}

//! One glass sphere of 10 mm.
inline std::string ball(std::string const& more, std::string const& name = "ball")
{
    return "[[experiment.particles]]\nname = \"" + name +
           "\"\nsource = \"body\"\nmaterial = \"glass\"\ndiameter_mm = 10\n" + more + "\n";
}
inline std::string stage(std::string const& name, std::string const& more)
{
    return "[[experiment.stage]]\nname = \"" + name + "\"\n" + more + "\n";
}
inline std::string response(std::string const& name, std::string const& more)
{
    return "[[experiment.response]]\nname = \"" + name + "\"\n" + more + "\n";
}
//! A steel wall.
inline std::string wall(std::string const& name, std::string const& more)
{
    return "[[experiment.wall]]\nname = \"" + name + "\"\nmaterial = \"steel\"\n" + more + "\n";
}

inline std::string const floor_at_zero =
    wall("floor", "shape = \"plane\"\nthrough_mm = [0, 0, 0]\nnormal = [0, 0, 1]");

//! Mass of the glass sphere of 10 mm [kg].
inline double const ball_mass = 2500 * 3.14159265358979323846 / 6 * 1e-6;

} // namespace demens::test
