#include "ensemble/storage/durable.hpp"

#include "ensemble/storage/descriptor.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <zlib.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

void sync_directory(fs::path const& directory)
{
    Descriptor const folder(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder)
        throw system_error("open the folder", directory, errno);
    // Some network file systems cannot sync a folder and say EINVAL; there the rename is already durable.
    if (::fsync(folder.get()) != 0 && errno != EINVAL)
        throw system_error("sync the folder", directory, errno);
}

//! A file that was not there; one that was, a link too, is removed.
Descriptor create_new(fs::path const& file)
{
    ::unlink(file.c_str());
    Descriptor out(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!out)
        throw system_error("create", file, errno);
    return out;
}

fs::path folder_of(fs::path const& file)
{
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

} // namespace

FileError system_error(std::string const& doing, fs::path const& file, int error_number)
{
    char const* hint = "";
    if (error_number == ENOSPC || error_number == EDQUOT)
        hint = "; free some space and start the same command again: finished runs are kept";
    else if (error_number == EFBIG)
        hint = "; a limit on the file size is set (ulimit -f): lift it and start the same command again";
    return FileError(
        fmt::format("cannot {} {}: {}{}", doing, file.string(), std::strerror(error_number), hint));
}

std::uint32_t crc32_of(std::span<std::byte const> bytes)
{
    return static_cast<std::uint32_t>(
        ::crc32_z(0, reinterpret_cast<unsigned char const*>(bytes.data()), bytes.size()));
}

std::uint32_t crc32_of(std::string const& text)
{
    return crc32_of(std::as_bytes(std::span(text)));
}

fs::path beside(fs::path const& file, std::string const& suffix)
{
    return fs::path(file.string() + suffix);
}

int read_at(int descriptor, std::span<std::byte> bytes, std::uintmax_t place, std::size_t& done)
{
    int constexpr most_tries = 3;
    done = 0;
    for (int failures = 0; done < bytes.size();) {
        auto const n =
            ::pread(descriptor, bytes.data() + done, bytes.size() - done, static_cast<off_t>(place + done));
        if (n == 0)
            return 0;
        if (n > 0)
            done += static_cast<std::size_t>(n);
        else if (errno != EINTR && ++failures == most_tries)
            return errno;
    }
    return 0;
}

int write_at(int descriptor, std::span<std::byte const> bytes, std::uintmax_t place)
{
    while (!bytes.empty()) {
        auto const n = ::pwrite(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(place));
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(n));
        place += static_cast<std::uintmax_t>(n);
    }
    return 0;
}

void write_durably(fs::path const& file, std::span<std::byte const> bytes)
{
    auto const part = beside(file, ".part");
    try {
        auto out = create_new(part);
        if (int const error = write_at(out.get(), bytes, 0))
            throw system_error("write", part, error);
        if (::fsync(out.get()) != 0 || out.close() != 0)
            throw system_error("write", part, errno);
        rename_durably(part, file);
    } catch (...) {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw;
    }
}

void rename_durably(fs::path const& from, fs::path const& to)
{
    if (::rename(from.c_str(), to.c_str()) != 0)
        throw system_error("rename " + from.string() + " to", to, errno);
    sync_directory(folder_of(to));
}

void sync_file(fs::path const& file)
{
    Descriptor const in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (!in || ::fsync(in.get()) != 0)
        throw system_error("sync", file, errno);
}

void reserve_space(fs::path const& file, std::uintmax_t bytes)
{
    Descriptor const out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (!out)
        throw system_error("open", file, errno);
    int const error_number = ::posix_fallocate(out.get(), 0, static_cast<off_t>(bytes));
    if (error_number != 0)
        throw system_error("reserve disk space for", file, error_number);
}

void forget_cached(fs::path const& file)
{
    Descriptor const in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    if (in)
        ::posix_fadvise(in.get(), 0, 0, POSIX_FADV_DONTNEED); // advice only: reading is right without it
}

void copy_to_new(fs::path const& from, fs::path const& to)
{
    Descriptor const in(::open(from.c_str(), O_RDONLY | O_CLOEXEC));
    if (!in)
        throw system_error("read", from, errno);
    auto out = create_new(to);
    Bytes buffer(std::size_t{1} << 20);
    for (std::uintmax_t place = 0;;) {
        std::size_t size = 0;
        if (int const error = read_at(in.get(), buffer, place, size))
            throw system_error("read", from, error);
        if (size == 0)
            break;
        if (int const error = write_at(out.get(), std::span(buffer).first(size), place))
            throw system_error("copy " + from.string() + " to", to, error);
        place += size;
    }
    if (out.close() != 0)
        throw system_error("copy " + from.string() + " to", to, errno);
}

Bytes read_bytes(fs::path const& file)
{
    Descriptor const in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    auto const end = in ? ::lseek(in.get(), 0, SEEK_END) : -1;
    if (end < 0)
        throw system_error("read", file, errno);
    Bytes bytes(static_cast<std::size_t>(end));
    std::size_t done = 0;
    if (int const error = read_at(in.get(), bytes, 0, done))
        throw system_error("read", file, error);
    bytes.resize(done);
    return bytes;
}

} // namespace demens::ensemble
