#include "ensemble/storage/durable.hpp"

#include "ensemble/storage/descriptor.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <zlib.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

void write_all(int descriptor, std::span<std::byte const> bytes, fs::path const& file)
{
    while (!bytes.empty()) {
        ssize_t const n = ::write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            throw system_error("write", file, errno);
        bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
}

void sync_directory(fs::path const& directory)
{
    Descriptor const folder(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!folder)
        throw system_error("open the folder", directory, errno);
    // Some network file systems cannot sync a folder and say EINVAL; there the rename is already durable.
    if (::fsync(folder.get()) != 0 && errno != EINVAL)
        throw system_error("sync the folder", directory, errno);
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

void write_durably(fs::path const& file, std::span<std::byte const> bytes)
{
    auto const part = beside(file, ".part");
    try {
        Descriptor out(::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
        if (!out)
            throw system_error("create", part, errno);
        write_all(out.get(), bytes, part);
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

Bytes read_bytes(fs::path const& file)
{
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    auto const size = in ? static_cast<std::streamoff>(in.tellg()) : -1;
    if (size < 0)
        throw FileError(fmt::format("cannot read {}", file.string()));
    Bytes bytes(static_cast<std::size_t>(size));
    in.seekg(0);
    if (!in.read(reinterpret_cast<char*>(bytes.data()), size))
        throw FileError(fmt::format("cannot read {}", file.string()));
    return bytes;
}

} // namespace demens::ensemble
