#pragma once

#include "demens/base/bytes.hpp"
#include "demens/base/file_error.hpp"
#include "ensemble/file/file_driver.hpp"

#include <cstdint>
#include <filesystem>
#include <hdf5.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

//! The little of HDF5 that a campaign file needs, with handles that close themselves.
namespace demens::ensemble::hdf5 {

//! Owner of an HDF5 identifier. Creation goes through `Handle(id, "what")`, which throws FileError on
//! failure.
template <herr_t (*Close)(hid_t)>
class Handle
{
  public:
    Handle() = default;
    Handle(hid_t id, std::string const& what);
    ~Handle() { reset(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
    Handle& operator=(Handle&& other) noexcept
    {
        std::swap(id_, other.id_);
        return *this;
    }

    operator hid_t() const { return id_; }
    //! Closes and checks; to be used for what was written. \throws FileError
    void close(std::string const& what);
    void reset()
    {
        if (id_ >= 0)
            Close(std::exchange(id_, -1));
    }

  private:
    hid_t id_ = -1;
};

using Dataset = Handle<H5Dclose>;
using Space = Handle<H5Sclose>;
using Type = Handle<H5Tclose>;
using Properties = Handle<H5Pclose>;
using Attribute = Handle<H5Aclose>;
using Object = Handle<H5Oclose>;

//! An open HDF5 file. One that was written must be closed by close(), which alone tells whether all of it
//! arrived.
class File
{
  public:
    File() = default;
    //! \throws FileError when `id` is negative
    File(hid_t id, std::string name, std::string const& what, std::shared_ptr<DriverState> state);

    operator hid_t() const { return handle_; }
    //! \throws FileError naming the file and what failed
    void close();
    //! Closes a file in memory and gives its content.
    Bytes take_image();

  private:
    std::shared_ptr<DriverState> state_;
    std::string name_;
    Handle<H5Fclose> handle_;
};

//! \throws FileError with what was attempted and HDF5's own reason when `result` is negative.
void check(long long result, std::string const& what);

//! Opens without writing. \throws FileError
File open_to_read(std::filesystem::path const& file);
//! Opens an existing file for writing by this process alone. \throws FileError
File open_to_write(std::filesystem::path const& file);
//! A file in memory only, empty or with the given content.
File create_in_memory();
File open_in_memory(Bytes image);

//! Memory type and file type of the numbers that are stored.
template <class T>
hid_t type_of();
template <>
inline hid_t type_of<double>()
{
    return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t type_of<float>()
{
    return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t type_of<std::uint8_t>()
{
    return H5T_NATIVE_UINT8;
}
template <>
inline hid_t type_of<int>()
{
    return H5T_NATIVE_INT;
}
template <>
inline hid_t type_of<std::uint32_t>()
{
    return H5T_NATIVE_UINT32;
}
template <>
inline hid_t type_of<std::int64_t>()
{
    return H5T_NATIVE_INT64;
}
template <>
inline hid_t type_of<std::uint64_t>()
{
    return H5T_NATIVE_UINT64;
}

//! Text of a fixed length in UTF-8, padded with zeros.
Type text_type(std::size_t length);

//! What a dataset holds, in words; every dataset with a dimension has units.
struct Meaning
{
    std::vector<std::string> units;        //!< one, or one per column; "1" when dimensionless
    std::vector<std::string> columns = {}; //!< names of the columns of a table
    std::string doc = {};                  //!< one line
};
inline Meaning dimensionless(std::string doc)
{
    return {{"1"}, {}, std::move(doc)};
}

bool exists(hid_t at, std::string const& path);
//! Names of the links in a group, sorted.
std::vector<std::string> children(hid_t at, std::string const& group);
void make_group(hid_t at, std::string const& path);
//! Name of the attribute with the check sum of a dataset: CRC-32 of its numbers as they lie in the file.
char constexpr check_sum_name[] = "crc32";
//! A dataset with its groups above it and its attributes, its space in the file taken and not filled.
//! `check_sum`: of the numbers that will be written.
Dataset create_dataset(hid_t at, std::string const& path, hid_t type, std::vector<std::size_t> const& shape,
                       Meaning const& meaning, std::uint32_t check_sum);

template <class T>
void write(hid_t at, std::string const& path, std::vector<std::size_t> const& shape,
           std::vector<T> const& data, Meaning const& meaning);
void write_text(hid_t at, std::string const& path, std::string const& text);

template <class T>
struct Array
{
    std::vector<std::size_t> shape;
    std::vector<T> data; //!< row-major
};
//! \throws FileError unless the shapes are the same
void require_shape(std::string const& path, std::vector<std::size_t> const& found,
                   std::vector<std::size_t> const& right);
template <class T>
Array<T> read_array(hid_t at, std::string const& path);
template <class T>
std::vector<T> read(hid_t at, std::string const& path)
{
    return read_array<T>(at, path).data;
}
//! A dataset that must have this shape. \throws FileError
template <class T>
std::vector<T> read(hid_t at, std::string const& path, std::vector<std::size_t> const& shape)
{
    auto array = read_array<T>(at, path);
    require_shape(path, array.shape, shape);
    return std::move(array.data);
}
//! Rows [first, first + count) of a table.
template <class T>
Array<T> read_rows(hid_t at, std::string const& path, std::size_t first, std::size_t count);
std::vector<std::string> read_texts(hid_t at, std::string const& path);

//! Attributes of the object at `path`; writing replaces.
void set_attribute(hid_t at, std::string const& path, std::string const& name,
                   std::vector<std::string> const& texts);
void set_attribute(hid_t at, std::string const& path, std::string const& name, std::string const& text);
void set_attribute(hid_t at, std::string const& path, std::string const& name, double value);
void set_attribute(hid_t at, std::string const& path, std::string const& name, std::int64_t value);
void set_attribute(hid_t at, std::string const& path, std::string const& name, std::uint32_t value);
bool has_attribute(hid_t at, std::string const& path, std::string const& name);
std::vector<std::string> texts_attribute(hid_t at, std::string const& path, std::string const& name);
std::string text_attribute(hid_t at, std::string const& path, std::string const& name);
double number_attribute(hid_t at, std::string const& path, std::string const& name);
std::int64_t integer_attribute(hid_t at, std::string const& path, std::string const& name);

template <herr_t (*Close)(hid_t)>
void Handle<Close>::close(std::string const& what)
{
    if (id_ >= 0)
        check(Close(std::exchange(id_, -1)), what);
}

template <herr_t (*Close)(hid_t)>
Handle<Close>::Handle(hid_t id, std::string const& what) : id_(id)
{
    check(id, what);
}

} // namespace demens::ensemble::hdf5
