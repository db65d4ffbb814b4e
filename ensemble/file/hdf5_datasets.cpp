#include "ensemble/file/hdf5_parts.hpp"
#include "ensemble/storage/durable.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>

// Datasets.
namespace demens::ensemble::hdf5 {
namespace {

//! As many bytes as the type in the file takes.
std::span<std::byte const> bytes_of(void const* data, std::size_t size)
{
    return {static_cast<std::byte const*>(data), size};
}

//! The type in the file is of the same class as the numbers that are asked for.
template <class T>
void require_type(hid_t dataset, std::string const& path)
{
    Type const type(H5Dget_type(dataset), "read the type of " + path);
    auto const right = std::is_floating_point_v<T> ? H5T_FLOAT : H5T_INTEGER;
    if (H5Tget_class(type) != right)
        throw FileError(path +
                        (right == H5T_FLOAT ? " does not hold numbers" : " does not hold whole numbers"));
}

} // namespace

Dataset create_dataset(hid_t at, std::string const& path, hid_t type, std::vector<std::size_t> const& shape,
                       Meaning const& meaning, std::uint32_t check_sum)
{
    if (auto const slash = path.rfind('/'); slash != 0 && slash != std::string::npos)
        make_group(at, path.substr(0, slash));
    Properties const creation(H5Pcreate(H5P_DATASET_CREATE), "make HDF5 dataset properties");
    check(H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY), "make HDF5 dataset properties");
    check(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), "make HDF5 dataset properties");
    auto const space = make_space(shape);
    Dataset dataset(H5Dcreate2(at, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                    "create " + path);
    set_attribute(dataset, ".", check_sum_name, check_sum);
    if (meaning.units.size() == 1)
        set_attribute(dataset, ".", "units", meaning.units.front());
    else if (!meaning.units.empty())
        set_attribute(dataset, ".", "units", meaning.units);
    if (!meaning.columns.empty())
        set_attribute(dataset, ".", "columns", meaning.columns);
    if (!meaning.doc.empty())
        set_attribute(dataset, ".", "doc", meaning.doc);
    return dataset;
}

template <class T>
void write(hid_t at, std::string const& path, std::vector<std::size_t> const& shape,
           std::vector<T> const& data, Meaning const& meaning)
{
    if (data.size() != count_of(shape))
        throw std::logic_error("array " + path + " does not have as many numbers as its shape says");
    auto dataset = create_dataset(at, path, type_of<T>(), shape, meaning,
                                  crc32_of(bytes_of(data.data(), data.size() * sizeof(T))));
    check(H5Dwrite(dataset, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data()), "write " + path);
    dataset.close("write " + path);
}

template <>
void write(hid_t at, std::string const& path, std::vector<std::size_t> const& shape,
           std::vector<std::string> const& data, Meaning const& meaning)
{
    auto const length = longest(data);
    auto const type = text_type(length);
    auto const packed = pack(data, length);
    auto dataset = create_dataset(at, path, type, shape, meaning, crc32_of(packed));
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), "write " + path);
    dataset.close("write " + path);
}

void write_text(hid_t at, std::string const& path, std::string const& text)
{
    write<std::string>(at, path, {}, {text}, {});
}

void require_shape(std::string const& path, std::vector<std::size_t> const& found,
                   std::vector<std::size_t> const& right)
{
    if (found != right)
        throw FileError(fmt::format("{} has {} entries instead of {}", path, fmt::join(found, " x "),
                                    fmt::join(right, " x ")));
}

template <class T>
Array<T> read_array(hid_t at, std::string const& path)
{
    Dataset const dataset(H5Dopen2(at, path.c_str(), H5P_DEFAULT), "open " + path);
    Space const space(H5Dget_space(dataset), "read the shape of " + path);
    require_type<T>(dataset, path);
    Array<T> array;
    array.shape = shape_of(space);
    array.data.resize(count_of(array.shape));
    check(H5Dread(dataset, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.data.data()), "read " + path);
    return array;
}

template <class T>
Array<T> read_rows(hid_t at, std::string const& path, std::size_t first, std::size_t count)
{
    Dataset const dataset(H5Dopen2(at, path.c_str(), H5P_DEFAULT), "open " + path);
    Space const space(H5Dget_space(dataset), "read the shape of " + path);
    require_type<T>(dataset, path);
    Array<T> array;
    array.shape = shape_of(space);
    if (array.shape.empty() || first > array.shape.front() || count > array.shape.front() - first)
        throw FileError("cannot read rows of " + path + ": it has fewer");
    array.shape.front() = count;
    array.data.resize(count_of(array.shape));
    if (array.data.empty())
        return array;
    std::vector<hsize_t> start(array.shape.size(), 0), extent(array.shape.begin(), array.shape.end());
    start.front() = first;
    check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
          "select rows of " + path);
    auto const memory = make_space(array.shape);
    check(H5Dread(dataset, type_of<T>(), memory, space, H5P_DEFAULT, array.data.data()), "read " + path);
    return array;
}

std::vector<std::string> read_texts(hid_t at, std::string const& path)
{
    Dataset const dataset(H5Dopen2(at, path.c_str(), H5P_DEFAULT), "open " + path);
    Space const space(H5Dget_space(dataset), "read the shape of " + path);
    Type const type(H5Dget_type(dataset), "read the type of " + path);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0)
        throw FileError(path + " does not hold texts of a fixed length");
    auto const length = H5Tget_size(type);
    std::string packed(count_of(shape_of(space)) * length, '\0');
    check(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), "read " + path);
    return unpack(packed, length);
}

#define DEMENS_INSTANTIATE(T)                                                                                \
    template void write<T>(hid_t, std::string const&, std::vector<std::size_t> const&,                       \
                           std::vector<T> const&, Meaning const&);                                           \
    template Array<T> read_array<T>(hid_t, std::string const&);                                              \
    template Array<T> read_rows<T>(hid_t, std::string const&, std::size_t, std::size_t);
DEMENS_INSTANTIATE(double)
DEMENS_INSTANTIATE(float)
DEMENS_INSTANTIATE(std::uint8_t)
DEMENS_INSTANTIATE(int)
DEMENS_INSTANTIATE(std::int64_t)
DEMENS_INSTANTIATE(std::uint64_t)
#undef DEMENS_INSTANTIATE

} // namespace demens::ensemble::hdf5
