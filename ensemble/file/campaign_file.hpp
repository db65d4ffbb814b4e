#pragma once

#include "ensemble/campaign.hpp"
#include "ensemble/file/hdf5.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace demens::ensemble {

//! Version of the layout that CAMPAIGN_FILE.md documents; raised when a reader of an older one could be
//! misled.
int constexpr format_version = 2;

//! Format, program version, input, factors, experiments, targets.
void write_header(hid_t file, CampaignInput const& input);
//! Another input in the place of the one that is there, with its factors, experiments and targets.
void replace_input(hid_t file, CampaignInput const& input);
//! Adds an extension to those that are there.
void write_extension(hid_t file, Extension const& extension);
//! Opens a campaign file for reading, after a look at everything in it. \throws InputError when it is none,
//! damaged, of a newer format, or not readable
hdf5::File open_campaign(std::filesystem::path const& file);
//! Everything but series and snapshots. \throws InputError
Campaign read_campaign(std::filesystem::path const& file, Rigs const& rigs);
//! The same of a file that is open. \param path where it is, for messages
Campaign read_campaign(hid_t file, std::filesystem::path const& path, Rigs const& rigs);

//! A change of a campaign file that is either made completely or not at all: a copy beside it is changed,
//! synced and renamed. Used by one process; the copy may be opened by several.
class FileUpdate
{
  public:
    //! Copies the file to FILE.new, with disk space for `more_bytes`. \throws FileError
    FileUpdate(std::filesystem::path const& file, std::uintmax_t more_bytes);
    //! The same of a file that need not be there yet: the change begins with a copy of another one.
    FileUpdate(std::filesystem::path file, std::filesystem::path const& from, std::uintmax_t more_bytes);
    ~FileUpdate();
    FileUpdate(FileUpdate const&) = delete;
    FileUpdate& operator=(FileUpdate const&) = delete;

    std::filesystem::path const& copy() const { return copy_; }
    //! Syncs the closed copy and reads all of it back. \throws FileError when it is not as it should be
    void verify() const;
    //! The verified copy takes the place of the file. \throws FileError
    void commit();

  private:
    std::filesystem::path file_, copy_;
    bool committed_ = false;
};

//! Room for a change of tables without particles [bytes].
inline constexpr std::uintmax_t small_change = 1 << 20;

//! Makes one change by one process. \throws FileError
void update_file(std::filesystem::path const& file, std::uintmax_t more_bytes,
                 std::function<void(hid_t)> const& change);

} // namespace demens::ensemble
