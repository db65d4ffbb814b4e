#include "demens/base/error.hpp"
#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/session.hpp"
#include "ensemble/storage/lock.hpp"

#include <fmt/format.h>
#include <functional>

namespace demens::ensemble {

namespace {

void create(std::filesystem::path const& path, CampaignInput const& input,
            std::function<void(RowWriter&)> const& write_waves)
{
    if (std::filesystem::exists(path))
        throw InputError(
            fmt::format("{}: exists already; give another name, or remove it first", path.string()));
    CampaignLock const lock(path, CampaignLock::Kind::session);
    auto file = hdf5::create_in_memory();
    write_header(file, input);
    RowWriter writer(file);
    write_waves(writer);
    Parts(path).remove(); // of a campaign file that is no more
    write_durably(path, file.take_image());
    try {
        forget_cached(path);
        open_campaign(path); // read back
    } catch (InputError const& error) {
        std::filesystem::remove(path);
        throw FileError(
            fmt::format("{}; it was just written, so that the disk may be failing", error.what()));
    }
}

} // namespace

void create_campaign_file(std::filesystem::path const& path, CampaignInput const& input,
                          std::optional<WavePlan> const& first_wave)
{
    create(path, input, [&](RowWriter& writer) {
        if (first_wave)
            write_plan(writer, plan_runs({input, {}, {}}, *first_wave), input);
    });
}

void create_campaign_file(std::filesystem::path const& path, CampaignInput const& input,
                          std::vector<Wave> const& taken)
{
    create(path, input, [&](RowWriter& writer) {
        for (auto const& wave : taken) {
            if (!is_complete(wave))
                throw InputError(
                    fmt::format("{}: only runs that have ended can be taken over", path.string()));
            write_plan(writer, wave, input);
            write_results(writer, wave, input);
            write_details(writer, wave.number, wave.runs, std::vector<RunDetails>(wave.runs.size()), input);
        }
    });
}

Campaign read_campaign_file(std::filesystem::path const& path, Rigs const& rigs)
{
    return read_campaign(path, rigs);
}

} // namespace demens::ensemble
