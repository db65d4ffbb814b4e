#include "ensemble/storage/journal.hpp"

#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <fcntl.h>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <sstream>

namespace demens::ensemble {

double seconds_since_epoch()
{
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

namespace {

namespace fs = std::filesystem;

std::string line_of(std::string const& text)
{
    return fmt::format("{:08x} {}\n", crc32_of(text), text);
}

struct Entry
{
    std::string verb;
    int run = 0;
    double begun = 0;              //!< [s] since 1970; of START and ALONE
    std::uint32_t shard_crc = 0;   //!< of END
    int status = -1, signal = 0;   //!< of END; of CRASH
    double seconds = -1;           //!< of END
    bool was_asked_to_end = false; //!< a death after that is not the run's doing
    double share = 0, told = 0;    //!< of AT, or of the last one of a start
    std::string moment = {};
};

//! A line that is not as `Journal` writes it, by its check sum or by what it says, is none.
std::optional<Entry> parse(std::string const& line)
{
    if (line.size() < 10 || line != line_of(line.substr(9)).substr(0, line.size()))
        return std::nullopt;
    Entry entry;
    std::istringstream in(line.substr(9));
    if (!(in >> entry.verb >> entry.run))
        return std::nullopt;
    if (entry.verb == "START" || entry.verb == "ALONE") {
        in >> entry.begun;
    } else if (entry.verb == "AT") {
        in >> entry.share >> entry.told >> std::ws;
        if (!(entry.share >= 0) || !std::isfinite(entry.share) || !std::getline(in, entry.moment))
            return std::nullopt;
        return entry;
    } else if (entry.verb == "CRASH") {
        in >> entry.signal;
    } else if (entry.verb == "END") {
        std::string word;
        in >> word;
        auto const end = word.data() + word.size();
        if (auto const read = std::from_chars(word.data(), end, entry.shard_crc, 16);
            read.ec != std::errc() || read.ptr != end)
            return std::nullopt;
        if (int status = 0; in >> status)
            entry.status = status;
        if (double seconds = 0; in >> seconds)
            entry.seconds = seconds;
        return entry;
    } else if (entry.verb != "BEGIN" && entry.verb != "DRAIN" && entry.verb != "STOP") {
        return std::nullopt;
    }
    return in ? std::optional(entry) : std::nullopt;
}

std::vector<fs::path> journals_of(fs::path const& folder)
{
    std::error_code error;
    std::vector<fs::path> files;
    for (auto const& entry : fs::directory_iterator(folder, error))
        if (entry.path().filename().string().starts_with("journal-"))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::istringstream lines_of(fs::path const& file)
{
    auto const bytes = read_bytes(file);
    return std::istringstream(std::string(reinterpret_cast<char const*>(bytes.data()), bytes.size()));
}

//! Takes in one writer's journal. What was in progress when its process began anew has died with the one
//! before; so has a run that is begun again without an end.
void take_in(fs::path const& file, std::map<int, RunHistory>& histories)
{
    auto in = lines_of(file);
    std::map<int, Entry> open; // by run
    auto const count_death = [&](Entry const& start) {
        auto& history = histories[start.run];
        ++(start.was_asked_to_end  ? history.stops
           : start.verb == "ALONE" ? history.deaths_alone
                                   : history.deaths);
    };
    auto const count_deaths = [&] {
        for (auto const& [run, start] : open)
            count_death(start);
    };
    for (std::string line; std::getline(in, line);) {
        auto const entry = parse(line);
        if (!entry)
            continue;
        auto const started = open.find(entry->run);
        if (entry->verb == "BEGIN") {
            count_deaths();
            open.clear();
        } else if (entry->verb == "START" || entry->verb == "ALONE") {
            if (started != open.end())
                count_death(started->second);
            open[entry->run] = *entry;
        } else if (entry->verb == "AT") {
            if (started != open.end()) {
                Entry& start = started->second;
                start.share = entry->share, start.told = entry->told, start.moment = entry->moment;
            }
        } else if (entry->verb == "STOP") {
            if (started != open.end())
                started->second.was_asked_to_end = true;
        } else {
            open.erase(entry->run);
            auto& history = histories[entry->run];
            if (entry->verb == "END") {
                history.shard_crcs.push_back(entry->shard_crc);
                history.status = entry->status;
                history.seconds = entry->seconds;
            }
            history.stops += entry->verb == "DRAIN";
            if (entry->verb == "CRASH") {
                ++history.crashes;
                history.crash = fmt::format("signal {}", entry->signal);
            }
        }
    }
    for (auto const& [run, start] : open) {
        auto& history = histories[run];
        history.open = true;
        if (start.begun < history.begun)
            continue;
        history.begun = start.begun;
        history.share = start.share, history.told = start.told, history.moment = start.moment;
    }
    count_deaths();
}

} // namespace

Journal::Journal(fs::path const& folder, std::string const& writer) : path_(folder / ("journal-" + writer))
{
    file_ = Descriptor(::open(path_.c_str(), O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!file_)
        throw system_error("open", path_, errno);
    // A kill may have cut the last line off; begin a new one so that only that line is lost.
    auto const size = ::lseek(file_.get(), 0, SEEK_END);
    char last = '\n';
    if (size > 0 && ::pread(file_.get(), &last, 1, size - 1) == 1 && last != '\n' &&
        ::write(file_.get(), "\n", 1) != 1)
        throw system_error("write", path_, errno);
    append(fmt::format("BEGIN 0 {:.3f}", seconds_since_epoch()));
}

void Journal::append(std::string const& text)
{
    auto const line = line_of(text);
    auto const n = ::write(file_.get(), line.data(), line.size());
    if (n != static_cast<ssize_t>(line.size())) {
        int const error_number = n < 0 ? errno : ENOSPC;
        if (n > 0 && ::write(file_.get(), "\n", 1) < 0) // keep the next line whole, if there is room for one
            throw system_error("write", path_, errno);
        throw system_error("write", path_, error_number);
    }
    if (::fdatasync(file_.get()) != 0)
        throw system_error("write", path_, errno);
}

void Journal::start(int run, Company company)
{
    append(fmt::format("{} {} {:.3f}", company == Company::alone ? "ALONE" : "START", run,
                       seconds_since_epoch()));
}

void Journal::at(int run, double share, std::string const& moment)
{
    append(fmt::format("AT {} {:.4g} {:.3f} {}", run, share, seconds_since_epoch(), moment));
}

void Journal::end(int run, std::uint32_t shard_crc, int status, double seconds)
{
    append(fmt::format("END {} {:08x} {} {:.6g}", run, shard_crc, status, seconds));
}

void Journal::drain(int run)
{
    append(fmt::format("DRAIN {}", run));
}

std::string Journal::stop_line(int run) const
{
    return line_of(fmt::format("STOP {}", run));
}

std::string Journal::crash_line(int run, int signal) const
{
    return line_of(fmt::format("CRASH {} {}", run, signal));
}

void forget_runs(fs::path const& folder, std::set<int> const& runs)
{
    for (auto const& file : journals_of(folder)) {
        std::string kept;
        auto lines = lines_of(file);
        for (std::string line; std::getline(lines, line);)
            if (auto const entry = parse(line);
                entry && (entry->verb == "BEGIN" || !runs.contains(entry->run)))
                kept += line + "\n";
        write_durably(file, std::as_bytes(std::span(kept)));
    }
}

std::map<int, RunHistory> read_journals(fs::path const& folder)
{
    std::map<int, RunHistory> histories;
    for (auto const& file : journals_of(folder))
        take_in(file, histories);
    return histories;
}

} // namespace demens::ensemble
