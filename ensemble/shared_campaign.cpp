#include "ensemble/shared_campaign.hpp"

#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/mpi/agreement.hpp"

#include <optional>

namespace demens::ensemble {
namespace {

//! Rank 0's files, which may be large and binary. Collective.
rig::Files share_files(MPI_Comm communicator, rig::Files const& mine)
{
    std::vector<int> count = {static_cast<int>(mine.size())};
    broadcast(communicator, count);
    auto next = mine.begin();
    rig::Files files;
    for (int k = 0; k < count.front(); ++k) {
        std::string name, content;
        if (rank_of(communicator) == 0) {
            name = next->first;
            content = *next->second;
            ++next;
        }
        broadcast(communicator, name);
        broadcast(communicator, content);
        files.emplace(name, std::make_shared<std::string const>(std::move(content)));
    }
    return files;
}

//! What the last extension says of the waves that follow; the other ranks need no more of them. Collective.
void share_last(MPI_Comm communicator, std::vector<Extension>& extensions)
{
    std::vector<int> last(3);
    if (!extensions.empty())
        last = {1, extensions.back().first_wave, extensions.back().runs};
    broadcast(communicator, last);
    if (rank_of(communicator) != 0 && last[0] == 1)
        extensions = {{last[1], last[2]}};
}

} // namespace

Campaign read_for_all(MPI_Comm communicator, std::filesystem::path const& file, Rigs const& rigs)
{
    std::optional<Campaign> campaign;
    std::string toml, ended;
    std::vector<int> waves(1);
    on_root(communicator, [&] {
        campaign = read_campaign(file, rigs);
        toml = campaign->input.text();
        ended = campaign->ended;
        waves.front() = static_cast<int>(campaign->waves.size());
    });
    broadcast(communicator, toml);
    broadcast(communicator, ended);
    broadcast(communicator, waves);
    auto extensions = campaign ? campaign->extensions : std::vector<Extension>{};
    share_last(communicator, extensions);
    auto const files = share_files(communicator, campaign ? campaign->input.files() : rig::Files{});
    on_all(communicator, [&] {
        if (!campaign)
            campaign =
                Campaign{CampaignInput::from_text(toml, file.string(), rigs, input::stored_files(files),
                                                  input::OldWords::understood),
                         {},
                         ended,
                         extensions};
    });
    if (!extensions.empty() && extensions.back().runs > 0)
        campaign->input.stop.runs = extensions.back().runs;
    for (int number = 0; number < waves.front(); ++number)
        share_wave(communicator, *campaign, number);
    return std::move(*campaign);
}

Bytes packed_wave(Wave const& wave, CampaignInput const& input)
{
    auto file = hdf5::create_in_memory();
    RowWriter writer(file);
    write_plan(writer, wave, input);
    if (is_complete(wave))
        write_results(writer, wave, input);
    write_analysis(file, wave.number, wave.analysis);
    return file.take_image();
}

Wave unpacked_wave(Bytes const& message, int number, CampaignInput const& input)
{
    return read_wave(hdf5::open_in_memory(message), number, input);
}

void share_wave(MPI_Comm communicator, Campaign& campaign, int number)
{
    auto const place = static_cast<std::size_t>(number);
    Bytes image;
    on_root(communicator, [&] { image = packed_wave(campaign.waves.at(place), campaign.input); });
    broadcast(communicator, image);
    if (rank_of(communicator) == 0)
        return;
    campaign.waves.resize(std::max(campaign.waves.size(), place + 1));
    campaign.waves[place] = unpacked_wave(image, number, campaign.input);
}

} // namespace demens::ensemble
