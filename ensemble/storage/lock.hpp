#pragma once

#include "ensemble/storage/descriptor.hpp"

#include <filesystem>
#include <string>

namespace demens::ensemble {

//! Keeps two sessions from working on one campaign file. The locks lie in FILE.lock and are the operating
//! system's, so that a killed process holds none. A session excludes sessions and shard jobs; shard jobs
//! share.
class CampaignLock
{
  public:
    enum class Kind
    {
        session, //!< alone
        shards   //!< together with other shard jobs
    };
    //! Waits for the last processes of a killed session to go. \throws InputError when another session goes
    //! on.
    CampaignLock(std::filesystem::path const& campaign_file, Kind kind);
    ~CampaignLock();
    CampaignLock(CampaignLock const&) = delete;
    CampaignLock& operator=(CampaignLock const&) = delete;

  private:
    std::filesystem::path path_;
    Descriptor file_;
    Kind kind_;
};

//! Held by every process of a session as long as it lives, so that the next session does not begin while
//! processes of a killed one still write.
class PresenceMark
{
  public:
    explicit PresenceMark(std::filesystem::path const& campaign_file);

  private:
    Descriptor file_;
};

//! Who works on a campaign file now, e.g. "process 123 on host4"; empty when nobody does.
std::string lock_owner(std::filesystem::path const& campaign_file);

} // namespace demens::ensemble
