#include "ensemble/campaign_reader.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/run_tables.hpp"

#include <fmt/format.h>

namespace demens::ensemble {

struct CampaignReader::Implementation
{
    std::filesystem::path path;
    hdf5::File file;
    Campaign campaign;
};

CampaignReader::CampaignReader(std::filesystem::path path, Rigs const& rigs)
{
    auto file = open_campaign(path);
    auto campaign = read_campaign(file, path, rigs);
    implementation_ = std::make_unique<Implementation>(
        Implementation{std::move(path), std::move(file), std::move(campaign)});
}

CampaignReader::CampaignReader(CampaignReader&&) noexcept = default;
CampaignReader::~CampaignReader() = default;

Campaign const& CampaignReader::campaign() const
{
    return implementation_->campaign;
}

RunDetails CampaignReader::details_of(int run) const
{
    auto const& [path, file, campaign] = *implementation_;
    for (auto const& wave : campaign.waves) {
        if (wave.runs.empty() || run < wave.runs.front().run || run > wave.runs.back().run)
            continue; // runs are numbered one wave after the other
        if (!is_complete(wave))
            throw InputError(fmt::format("{}: run {} is not in the file yet; its wave {} goes on",
                                         path.string(), run, wave.number));
        auto const row = static_cast<std::size_t>(run - wave.runs.front().run);
        auto const experiment = static_cast<std::size_t>(wave.runs[row].experiment);
        return read_details(file, wave.number, row, campaign.input.experiments.at(experiment).name);
    }
    throw InputError(fmt::format("{}: there is no run {}; the campaign has runs 0 to {}", path.string(), run,
                                 campaign.runs_planned() - 1));
}

} // namespace demens::ensemble
