#pragma once

#include "demens/base/bytes.hpp"
#include "demens/base/file_error.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace demens::ensemble {

//! Cyclic redundancy check (CRC-32, as in gzip) of bytes.
std::uint32_t crc32_of(std::span<std::byte const> bytes);
std::uint32_t crc32_of(std::string const& text);

//! Reads bytes at a place of an open file, fewer at its end; a read that fails is tried again. \return 0 or
//! errno
int read_at(int descriptor, std::span<std::byte> bytes, std::uintmax_t place, std::size_t& done);
//! Writes all bytes at a place of an open file. \return 0 or errno
int write_at(int descriptor, std::span<std::byte const> bytes, std::uintmax_t place);

//! Writes a whole file so that a kill or a power cut leaves the old file, none, or the new one: written
//! beside it as
//! `.part`, synced, renamed, the folder synced. \throws FileError naming the file; nothing half-written is
//! left.
void write_durably(std::filesystem::path const& file, std::span<std::byte const> bytes);
//! Copies a file to a new one; something of that name, a link too, is removed first. \throws FileError
void copy_to_new(std::filesystem::path const& from, std::filesystem::path const& to);
//! Renames a synced file over another and syncs the folder. \throws FileError
void rename_durably(std::filesystem::path const& from, std::filesystem::path const& to);
//! Flushes a closed file to the disk. \throws FileError
void sync_file(std::filesystem::path const& file);
//! Takes disk space for a file before it is written, so that a full disk is found here. \throws FileError
void reserve_space(std::filesystem::path const& file, std::uintmax_t bytes);
//! Lets the system forget what it has in memory of a synced file, so that it is read from the disk.
void forget_cached(std::filesystem::path const& file);
//! \throws FileError
Bytes read_bytes(std::filesystem::path const& file);

//! `campaign.h5` and `.parts` give `campaign.h5.parts`.
std::filesystem::path beside(std::filesystem::path const& file, std::string const& suffix);

//! "cannot <doing> FILE: <reason of errno>", with a hint where there is a common remedy.
FileError system_error(std::string const& doing, std::filesystem::path const& file, int error_number);

} // namespace demens::ensemble
