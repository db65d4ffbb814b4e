#include "ensemble/storage/lock.hpp"

#include "demens/base/error.hpp"
#include "ensemble/storage/durable.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>
#include <thread>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

off_t constexpr owner_byte = 0;    //!< a session locks it alone, shard jobs share it
off_t constexpr presence_byte = 1; //!< every process of a session or shard job shares it
auto constexpr patience = std::chrono::seconds(20);

struct flock lock_request(short type, off_t byte)
{
    struct flock request = {};
    request.l_type = type;
    request.l_whence = SEEK_SET;
    request.l_start = byte;
    request.l_len = 1;
    return request;
}

//! Some network file systems have no locks; a campaign must run there all the same.
void go_on_without(fs::path const& path, int error_number)
{
    spdlog::warn(
        "cannot lock {}: {}; this file system seems to have no locks: see to it that only one session "
        "works on the campaign at a time",
        path.string(), std::strerror(error_number));
}

//! Locks of the open file, not of the process: they end when the last process that has it open dies.
bool try_lock(Descriptor const& file, short type, off_t byte, fs::path const& path)
{
    auto request = lock_request(type, byte);
    if (::fcntl(file.get(), F_OFD_SETLK, &request) == 0)
        return true;
    int const error = errno;
    if (error == EAGAIN || error == EACCES || error == EINTR)
        return false;
    if (error == EIO || error == EBADF || error == ENOMEM)
        throw system_error("lock", path, error);
    go_on_without(path, error);
    return true;
}

bool lock_within(std::chrono::milliseconds limit, Descriptor const& file, short type, off_t byte,
                 fs::path const& path)
{
    auto const give_up = std::chrono::steady_clock::now() + limit;
    while (!try_lock(file, type, byte, path)) {
        if (std::chrono::steady_clock::now() > give_up)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return true;
}

Descriptor open_lock_file(fs::path const& path, int flags)
{
    return Descriptor(::open(path.c_str(), flags | O_NOFOLLOW | O_CLOEXEC, 0666));
}

bool is_same_file(Descriptor const& file, fs::path const& path)
{
    struct stat opened, named;
    return ::fstat(file.get(), &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
           opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

fs::path lock_path(fs::path const& campaign_file)
{
    return beside(campaign_file, ".lock");
}

//! What is made beside a campaign file must not reach elsewhere through a link. \throws InputError
void refuse_links(fs::path const& campaign_file)
{
    std::error_code ignored;
    for (auto const& path : {campaign_file, lock_path(campaign_file), beside(campaign_file, ".parts")})
        if (fs::is_symlink(path, ignored))
            throw InputError(
                fmt::format("{}: is a symbolic link (to {}), which a session would replace or write through; "
                            "give the path of the file itself, or remove the link",
                            path.string(), fs::read_symlink(path, ignored).string()));
}

std::string read_owner(Descriptor const& file)
{
    std::array<char, 256> text = {};
    auto const n = ::pread(file.get(), text.data(), text.size(), 0);
    return n > 0 ? std::string(text.data(), static_cast<std::size_t>(n)) : "another process";
}

void write_owner(Descriptor const& file)
{
    std::array<char, 128> host = {};
    ::gethostname(host.data(), host.size() - 1);
    auto const text = fmt::format("process {} on {}", ::getpid(), host.data());
    // Only for messages: a full disk must not matter here.
    if (::ftruncate(file.get(), 0) == 0 && ::pwrite(file.get(), text.data(), text.size(), 0) < 0)
        errno = 0;
}

} // namespace

CampaignLock::CampaignLock(fs::path const& campaign_file, Kind kind)
    : path_(lock_path(campaign_file)), kind_(kind)
{
    refuse_links(campaign_file);
    short const type = kind == Kind::session ? F_WRLCK : F_RDLCK;
    do {
        file_ = open_lock_file(path_, O_RDWR | O_CREAT);
        if (!file_)
            throw system_error("create the lock", path_, errno);
        if (!lock_within(std::chrono::seconds(3), file_, type, owner_byte, path_))
            throw InputError(
                fmt::format("{}: in use by {}; two sessions on one campaign would run its runs twice: "
                            "wait until it ends, or stop it",
                            campaign_file.string(), read_owner(file_)));
    } while (!is_same_file(file_, path_)); // the last owner may have removed it meanwhile
    if (kind == Kind::session) {
        if (!lock_within(patience, file_, F_WRLCK, presence_byte, path_))
            throw InputError(
                fmt::format("{}: processes of an ended session or shard job still work on it; wait until "
                            "they end, or stop them",
                            campaign_file.string()));
        auto release = lock_request(F_UNLCK, presence_byte);
        ::fcntl(file_.get(), F_OFD_SETLK, &release);
        write_owner(file_);
    }
}

CampaignLock::~CampaignLock()
{
    if (kind_ == Kind::session)
        ::unlink(path_.c_str());
}

PresenceMark::PresenceMark(fs::path const& campaign_file)
    : file_(open_lock_file(lock_path(campaign_file), O_RDWR | O_CREAT))
{
    auto const path = lock_path(campaign_file);
    if (!file_)
        throw system_error("open the lock", path, errno);
    if (!lock_within(patience, file_, F_RDLCK, presence_byte, path))
        throw InputError(fmt::format("{}: another session has just begun on it", campaign_file.string()));
}

std::string lock_owner(fs::path const& campaign_file)
{
    auto const path = lock_path(campaign_file);
    auto const file = open_lock_file(path, O_RDONLY);
    if (!file)
        return {};
    auto request = lock_request(F_WRLCK, owner_byte);
    if (::fcntl(file.get(), F_OFD_GETLK, &request) != 0 || request.l_type == F_UNLCK)
        return {};
    return read_owner(file);
}

} // namespace demens::ensemble
