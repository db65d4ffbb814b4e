#include "src/rig/custom/entry.hpp"
#include "src/rig/custom/quantities.hpp"
#include "src/rig/custom/wall_driver.hpp"
#include "src/rig/custom/wall_seams.hpp"
#include "src/rig/rigs.hpp"

#include <algorithm>
#include <cmath>

namespace demens::rig {
namespace {

using namespace custom;

Apparatus build(Setup const& setup)
{
    Apparatus apparatus{.model = setup.model, .options = setup.options};
    for (auto const& plan : setup.walls)
        apparatus.walls.insert(apparatus.walls.end(), plan.parts.begin(), plan.parts.end());
    return apparatus;
}

Programme describe(RunInput const& input)
{
    auto const setup = std::make_shared<Setup const>(input); // kept alive by `build`
    Programme programme{
        .time_step = setup->options.time_step,
        .steps_per_look = std::max<std::int64_t>(1, std::llround(setup->interval / setup->options.time_step)),
        .expected_particles = setup->expected_particles(),
        .work_per_particle = setup->work_per_particle(),
        .expected_duration = setup->longest_duration(),
        .has_rigid_bodies = setup->has_rigid_bodies(),
        .removes_particles = !setup->outlets.empty()};
    for (auto const& group : setup->groups)
        programme.names.groups.push_back(group.name);
    for (auto const& wall : setup->walls)
        programme.names.walls.insert(programme.names.walls.end(), wall.parts.size(), wall.name);
    for (auto const& response : setup->responses)
        programme.reads_loads |= response.quantity->reads_loads;
    programme.build = [setup] { return build(*setup); };
    programme.check = [setup] {
        check_places(*setup);
        auto all = warnings(setup->walls);
        for (auto& warning : seam_warnings(setup->walls))
            all.push_back(std::move(warning));
        for (auto const& group : setup->groups)
            for (auto& warning : particle_warnings(group, setup->density(group)))
                all.push_back(std::move(warning));
        return all;
    };
    for (std::size_t k = 0; k < setup->stages.size(); ++k) {
        auto stage = make_stage(setup->stages[k]);
        stage.enter = [k, &setup = *setup](Bench& bench) {
            begin_walls(bench, setup, k);
            enter(bench, setup, k);
        };
        bool const pours = std::any_of(setup->groups.begin(), setup->groups.end(), [k](auto const& group) {
            return group.stage == k && group.is_inlet();
        });
        if (bool const lets_out = is_open(*setup, k); pours || lets_out)
            stage.at_look = [k, pours, lets_out, &setup = *setup](Bench& bench) {
                if (lets_out)
                    let_out(bench, setup, k);
                if (pours)
                    pour(bench, setup, k);
            };
        programme.stages.push_back(std::move(stage));
    }
    programme.readings = readings(*setup);
    programme.profiles = profiles(*setup);
    programme.responses = custom::responses(*setup, asked_responses(input.experiment));
    return programme;
}

} // namespace

RigInfo custom_rig()
{
    RigInfo rig{.name = "custom",
                .doc = "made in the file itself: particles, walls and their motions, stages, responses",
                .options = experiment_options(),
                .tables = {particles_table(), region_table(), wall_table(), stage_table(), outlet_table(),
                           response_table()},
                .asked_responses = asked_responses};
    rig.describe = describe;
    return described(std::move(rig));
}

} // namespace demens::rig
