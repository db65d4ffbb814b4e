#include "demens/rig/programme/programme_run.hpp"

#include "demens/base/contract.hpp"
#include "demens/rig/programme/memory.hpp"
#include "demens/rig/programme/plausible.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace demens::rig {
namespace {

template <class Named>
auto const& find_named(std::vector<Named> const& all, std::string const& name)
{
    auto const found =
        std::find_if(all.begin(), all.end(), [&](Named const& one) { return one.name == name; });
    DEMENS_EXPECT(found != all.end(), "a name that the programme has");
    return *found;
}

} // namespace

std::vector<double> const& Series::column(std::string const& name) const
{
    auto const found = std::find(names.begin(), names.end(), name);
    DEMENS_EXPECT(found != names.end(), "a reading of the programme");
    return columns[static_cast<std::size_t>(found - names.begin())];
}

std::vector<double> Progress::column_in(std::size_t number, std::string const& name) const
{
    DEMENS_EXPECT(number < rows.size(), "a stage of the programme");
    auto const& column = series.column(name);
    return {column.begin() + static_cast<std::ptrdiff_t>(rows[number].first),
            column.begin() + static_cast<std::ptrdiff_t>(rows[number].end)};
}

Profile const& Progress::profile(std::string const& name) const
{
    return find_named(profiles, name);
}

dem::StateView const& Look::particles()
{
    if (!particles_)
        particles_ = bench_.simulation.read(dem::Fields::all);
    return *particles_;
}

dem::StateView const& Look::grains()
{
    if (!grains_)
        grains_ = bench_.simulation.read_grains(dem::Fields::all);
    return *grains_;
}

namespace {

//! \throws InputError where no engine can do it on so many ranks
void check_engine(Programme const& programme, int ranks)
{
    if (programme.has_rigid_bodies || programme.removes_particles)
        chosen_engine(programme.engine, programme.needs(ranks > 1));
}

} // namespace

Programme programme_of(RigInfo const& rig, RunInput const& input, int ranks)
{
    auto programme = rig.describe(input);
    programme.engine = input.engine;
    for (auto const& material : input.model.materials)
        programme.names.materials.push_back(material.name);
    check_engine(programme, ranks);
    check_memory(programme.expected_particles, ranks, memory_limit());
    return programme;
}

RigInfo described(RigInfo rig)
{
    auto const describe = [of_rig = rig.describe](RunInput const& input) {
        auto programme = of_rig(input);
        programme.engine = input.engine;
        return programme;
    };
    auto const checked = [describe](RunInput const& input) {
        auto const programme = describe(input);
        check_engine(programme, 1);
        check_memory(programme.expected_particles, 1, memory_limit());
        return programme.check ? programme.check() : std::vector<std::string>{};
    };
    rig.check = [checked](RunInput const& input) { checked(input); };
    rig.warnings = [checked](RunInput const& input) {
        auto warnings = checked(input);
        auto const units = unit_warnings(input.model);
        warnings.insert(warnings.end(), units.begin(), units.end());
        return warnings;
    };
    rig.predict_cost = [describe](RunInput const& input) { return describe(input).expected_work(); };
    rig.run = [rig](RunInput const& input, RunHooks const& hooks) {
        std::optional<Programme> programme;
        try {
            programme = programme_of(rig, input, hooks.team ? hooks.team->size() : 1);
        } catch (std::exception const& error) {
            auto const count = responses_of(rig, input.experiment).size();
            return RunResult{.status = RunStatus::error,
                             .reason = error.what(),
                             .responses = std::vector(count, std::numeric_limits<double>::quiet_NaN())};
        }
        return run_programme(std::move(*programme), hooks);
    };
    return rig;
}

} // namespace demens::rig
