#pragma once

#include "ensemble/campaign.hpp"
#include "ensemble/storage/durable.hpp"
#include "ensemble/storage/journal.hpp"

#include <map>
#include <vector>

namespace demens::ensemble {

//! A run as it is written to its shard.
struct FinishedRun
{
    RunRecord record;
    RunDetails details;
    std::uint32_t shard_crc = 0; //!< 0: not written yet
};

//! What the whole shard of a run says in short.
struct SeenShard
{
    std::uint32_t crc = 0; //!< 0: there is none
    rig::RunStatus status = rig::RunStatus::not_run;
    double start_time = 0, wall_time = 0; //!< [s]
};

//! What a wave still lacks.
struct WaveState
{
    std::vector<int> pending; //!< rows that can run beside each other
    std::vector<int>
        suspicious; //!< rows that were in progress when processes died: one at a time, nothing beside it
    std::vector<int> poisonous;    //!< rows that are not begun again; see `quarantine_reason`
    std::vector<SeenShard> shards; //!< of each row
};

//! The folder FILE.parts: a shard per finished run of the wave in progress, and journals.
class Parts
{
  public:
    //! Deaths beside other runs after which a run has to run alone.
    static int constexpr deaths_until_alone = 2;
    //! Deaths alone, or deadly signals, after which it is not begun again.
    static int constexpr deaths_alone_until_poisonous = 3, crashes_until_poisonous = 2;

    explicit Parts(std::filesystem::path const& campaign_file) : folder_(beside(campaign_file, ".parts")) {}

    std::filesystem::path const& folder() const { return folder_; }
    //! \throws FileError
    void make_folder() const;
    void remove() const;
    void remove_shard(int run) const;
    //! Removes the shards of a wave that is in the campaign file.
    void remove_shards(Wave const& wave) const;

    //! Writes the shard, then its END line. \throws FileError; then there is no shard
    void store(FinishedRun const& run, CampaignInput const& input, Journal& journal) const;
    //! Reads a shard whose check sum is one of `crcs`.
    SeenShard look(RunRecord const& plan, CampaignInput const& input,
                   std::vector<std::uint32_t> const& crcs) const;
    //! What is to be done with each row, by what journals say and what was seen of its shard.
    static WaveState state_of(Wave const& wave, std::map<int, RunHistory> const& histories,
                              std::vector<SeenShard> shards);
    //! Reads the shard of a planned run with its details. \throws FileError when its check
    //! sum is none of `crcs`
    FinishedRun load(RunRecord const& plan, CampaignInput const& input,
                     std::vector<std::uint32_t> const& crcs) const;
    std::uintmax_t shard_size(RunRecord const& plan) const;

  private:
    std::filesystem::path shard(int run) const;

    std::filesystem::path folder_;
};

//! Why a run is not begun again.
std::string quarantine_reason(RunHistory const& history);

} // namespace demens::ensemble
