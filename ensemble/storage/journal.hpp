#pragma once

#include "ensemble/storage/descriptor.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace demens::ensemble {

//! Now, by the clock of the wall [s since 1970], as journals tell times.
double seconds_since_epoch();

//! What one process writes down of the runs it begins and ends, a line each, on the disk before it goes on:
//!
//!     <CRC of the rest> BEGIN 0 1732243967.456        begins: what was in progress before has died
//!     <CRC of the rest> START 17 1732243968.123       begun, other runs beside it
//!     <CRC of the rest> ALONE 17 1732243968.123       begun with nothing beside it
//!     <CRC of the rest> AT 17 0.28 1732243988.123 in stage "flow" at 0.85 s    share done, when, where
//!     <CRC of the rest> END 17 <CRC> <status> 12.3    the shard of this CRC is on the disk; time [s]
//!     <CRC of the rest> DRAIN 17                      given up on request; begin it again
//!     <CRC of the rest> STOP 17                       asked to end (SIGTERM, SIGINT) meanwhile
//!     <CRC of the rest> CRASH 17 <signal>             received a deadly signal while it simulated
//!
//! A line whose CRC is wrong, e.g. one cut off by a kill, is as if it were not there.
class Journal
{
  public:
    //! Appends to the journal of one writer. \throws FileError
    Journal(std::filesystem::path const& folder, std::string const& writer);

    enum class Company
    {
        others,
        alone
    };
    void start(int run, Company company);
    //! \param share of the run that is done, about \param moment a line of text
    void at(int run, double share, std::string const& moment);
    void end(int run, std::uint32_t shard_crc, int status, double seconds);
    void drain(int run);
    //! Lines that tell of a crash or of a request to end, made beforehand for a signal handler.
    std::string crash_line(int run, int signal) const;
    std::string stop_line(int run) const;
    int descriptor() const { return file_.get(); }

  private:
    void append(std::string const& text);

    std::filesystem::path path_;
    Descriptor file_;
};

//! What the journals say of one run.
struct RunHistory
{
    std::vector<std::uint32_t> shard_crcs; //!< one per END; a whole shard has one of them
    int status = -1;                       //!< of the last END; -1: not known
    double seconds = -1;                   //!< [s] that it took, of the last END; -1: not known
    int deaths = 0;                        //!< starts that ended without a word, with other runs beside it
    int deaths_alone = 0;                  //!< the same with nothing beside it
    int crashes = 0;                       //!< deadly signals
    int stops = 0;                         //!< starts given up on request
    std::string crash;                     //!< the last of them, e.g. "signal 11"
    bool open = false;                     //!< a start is the last line of a journal: running, or killed
    double begun = 0;                      //!< [s] since 1970, of that start
    double share = 0;                      //!< of it that was done when it was last told; 0: not told yet
    double told = 0;                       //!< [s] since 1970, of that
    std::string moment;                    //!< where it was then
};

//! As if these runs had never begun: takes their lines out of all journals of a folder. Nobody may write them
//! meanwhile. \throws FileError
void forget_runs(std::filesystem::path const& folder, std::set<int> const& runs);

//! Reads all journals of a folder; safe while they are written.
std::map<int, RunHistory> read_journals(std::filesystem::path const& folder);

} // namespace demens::ensemble
