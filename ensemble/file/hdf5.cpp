#include "ensemble/file/hdf5.hpp"

#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>

namespace demens::ensemble::hdf5 {
namespace {

//! HDF5 prints its error stack by default; here errors are exceptions that carry its innermost reason.
void keep_quiet()
{
    static bool const done = [] {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        return true;
    }();
    (void)done;
}

herr_t keep_reason(unsigned, H5E_error2_t const* error, void* reason)
{
    auto& text = *static_cast<std::string*>(reason);
    if (text.empty() && error->desc)
        text = error->desc;
    return 0;
}

std::size_t count_of(std::vector<std::size_t> const& shape)
{
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<std::size_t> shape_of(hid_t space)
{
    std::vector<hsize_t> extent(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, extent.data(), nullptr);
    return {extent.begin(), extent.end()};
}

Space make_space(std::vector<std::size_t> const& shape)
{
    std::vector<hsize_t> const extent(shape.begin(), shape.end());
    return {extent.empty() ? H5Screate(H5S_SCALAR)
                           : H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
            "make an HDF5 data space"};
}

//! Equally long texts one after the other, zero-padded.
std::string pack(std::vector<std::string> const& texts, std::size_t length)
{
    std::string packed;
    for (auto const& text : texts)
        packed += text + std::string(length - text.size(), '\0');
    return packed;
}

std::vector<std::string> unpack(std::string const& packed, std::size_t length)
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; i + length <= packed.size(); i += length)
        texts.push_back(packed.substr(i, std::min(length, packed.find('\0', i) - i)));
    return texts;
}

std::size_t longest(std::vector<std::string> const& texts)
{
    std::size_t length = 1;
    for (auto const& text : texts)
        length = std::max(length, text.size());
    return length;
}

Attribute replace_attribute(hid_t object, std::string const& name, hid_t type, hid_t space)
{
    if (H5Aexists(object, name.c_str()) > 0)
        check(H5Adelete(object, name.c_str()), "replace the attribute " + name);
    return {H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
            "create the attribute " + name};
}

Object open_object(hid_t at, std::string const& path)
{
    return {H5Oopen(at, path.c_str(), H5P_DEFAULT), "open " + path};
}

template <class T>
void set_number(hid_t at, std::string const& path, std::string const& name, T value)
{
    auto const object = open_object(at, path);
    auto const space = make_space({});
    auto const attribute = replace_attribute(object, name, type_of<T>(), space);
    check(H5Awrite(attribute, type_of<T>(), &value), "write the attribute " + name);
}

template <class T>
T get_number(hid_t at, std::string const& path, std::string const& name)
{
    auto const object = open_object(at, path);
    Attribute const attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT),
                              "read the attribute " + name + " of " + path);
    Type const type(H5Aget_type(attribute), "read the attribute " + name + " of " + path);
    Space const space(H5Aget_space(attribute), "read the attribute " + name + " of " + path);
    auto const kind = H5Tget_class(type);
    if (H5Sget_simple_extent_npoints(space) != 1 || (kind != H5T_INTEGER && kind != H5T_FLOAT))
        throw FileError("the attribute " + name + " of " + path + " is not one number");
    T value{};
    check(H5Aread(attribute, type_of<T>(), &value), "read the attribute " + name + " of " + path);
    return value;
}

Properties access_properties()
{
    keep_quiet();
    Properties access(H5Pcreate(H5P_FILE_ACCESS), "make HDF5 access properties");
    // The layout of HDF5 1.8, whose headers have check sums of their own.
    check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18), "choose the HDF5 layout");
    return access;
}

//! Links lie in the header of their group, which has a check sum; HDF5 1.10 crashes on damage in the heap in
//! which it would keep many of them.
void keep_links_in_header(hid_t group_creation)
{
    unsigned constexpr most = 65535;
    check(H5Pset_link_phase_change(group_creation, most, most - 1), "choose how groups are stored");
}

File open_file(std::filesystem::path const& file, unsigned flags)
{
    auto const access = access_properties();
    auto const state = std::make_shared<DriverState>();
    use_own_driver(access, state);
    return {H5Fopen(file.c_str(), flags, access), file.string(), "open " + file.string(), state};
}

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

void check(long long result, std::string const& what)
{
    if (result >= 0)
        return;
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_reason, &reason);
    throw FileError(fmt::format("cannot {} (HDF5: {})", what, reason.empty() ? "no reason given" : reason));
}

File::File(hid_t id, std::string name, std::string const& what, std::shared_ptr<DriverState> state)
    : state_(std::move(state)), name_(std::move(name))
{
    if (id < 0 && state_ && state_->error != 0)
        throw FileError(fmt::format("cannot {} {}: {}", state_->doing, name_, std::strerror(state_->error)));
    handle_ = Handle<H5Fclose>(id, what);
}

void File::close()
{
    auto const what = "write the last of " + name_;
    handle_.close(what);
    if (state_ && state_->error != 0)
        throw system_error(state_->doing, name_, state_->error);
}

File open_to_read(std::filesystem::path const& file)
{
    return open_file(file, H5F_ACC_RDONLY);
}

File open_to_write(std::filesystem::path const& file)
{
    return open_file(file, H5F_ACC_RDWR);
}

File create_in_memory()
{
    auto const access = access_properties();
    auto const state = std::make_shared<DriverState>();
    state->memory.emplace();
    use_own_driver(access, state);
    Properties const creation(H5Pcreate(H5P_FILE_CREATE), "make HDF5 file properties");
    keep_links_in_header(creation);
    return {H5Fcreate("in memory", H5F_ACC_TRUNC, creation, access), "a file in memory",
            "create a file in memory", state};
}

File open_in_memory(Bytes image)
{
    auto const access = access_properties();
    auto const state = std::make_shared<DriverState>();
    state->memory = std::move(image);
    use_own_driver(access, state);
    return {H5Fopen("in memory", H5F_ACC_RDONLY, access), "a file in memory", "open a file image", state};
}

Bytes File::take_image()
{
    close();
    return std::move(*state_->memory);
}

Type text_type(std::size_t length)
{
    Type type(H5Tcopy(H5T_C_S1), "make a text type");
    check(H5Tset_size(type, std::max<std::size_t>(length, 1)), "make a text type");
    check(H5Tset_cset(type, H5T_CSET_UTF8), "make a text type");
    check(H5Tset_strpad(type, H5T_STR_NULLPAD), "make a text type");
    return type;
}

bool exists(hid_t at, std::string const& path)
{
    for (auto slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
        if (H5Lexists(at, path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0)
            return false;
        if (slash == std::string::npos)
            return true;
    }
}

std::vector<std::string> children(hid_t at, std::string const& group)
{
    std::vector<std::string> names;
    if (!exists(at, group))
        return names;
    auto const object = open_object(at, group);
    auto const add = [](hid_t, char const* name, H5L_info_t const*, void* list) -> herr_t {
        static_cast<std::vector<std::string>*>(list)->push_back(name);
        return 0;
    };
    check(H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names), "list " + group);
    return names;
}

void make_group(hid_t at, std::string const& path)
{
    if (exists(at, path))
        return;
    if (auto const slash = path.rfind('/'); slash != 0 && slash != std::string::npos)
        make_group(at, path.substr(0, slash));
    Properties const creation(H5Pcreate(H5P_GROUP_CREATE), "make HDF5 group properties");
    keep_links_in_header(creation);
    Handle<H5Gclose> group(H5Gcreate2(at, path.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT),
                           "create the group " + path);
    group.close("create the group " + path);
}

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
    set_number(dataset, ".", check_sum_name, check_sum);
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

void set_attribute(hid_t at, std::string const& path, std::string const& name,
                   std::vector<std::string> const& texts)
{
    auto const object = open_object(at, path);
    auto const type = text_type(longest(texts));
    auto const space = make_space({texts.size()});
    auto const attribute = replace_attribute(object, name, type, space);
    check(H5Awrite(attribute, type, pack(texts, longest(texts)).data()), "write the attribute " + name);
}

void set_attribute(hid_t at, std::string const& path, std::string const& name, std::string const& text)
{
    auto const object = open_object(at, path);
    auto const type = text_type(text.size());
    auto const space = make_space({});
    auto const attribute = replace_attribute(object, name, type, space);
    check(H5Awrite(attribute, type, pack({text}, longest({text})).data()), "write the attribute " + name);
}

void set_attribute(hid_t at, std::string const& path, std::string const& name, double value)
{
    set_number(at, path, name, value);
}

void set_attribute(hid_t at, std::string const& path, std::string const& name, std::int64_t value)
{
    set_number(at, path, name, value);
}

bool has_attribute(hid_t at, std::string const& path, std::string const& name)
{
    auto const object = open_object(at, path);
    return H5Aexists(object, name.c_str()) > 0;
}

std::vector<std::string> texts_attribute(hid_t at, std::string const& path, std::string const& name)
{
    auto const object = open_object(at, path);
    Attribute const attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT),
                              "read the attribute " + name + " of " + path);
    Type const type(H5Aget_type(attribute), "read the attribute " + name + " of " + path);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0)
        throw FileError("the attribute " + name + " of " + path + " is not text of a fixed length");
    Space const space(H5Aget_space(attribute), "read the attribute " + name + " of " + path);
    auto const length = H5Tget_size(type);
    std::string packed(count_of(shape_of(space)) * length, '\0');
    check(H5Aread(attribute, type, packed.data()), "read the attribute " + name + " of " + path);
    return unpack(packed, length);
}

std::string text_attribute(hid_t at, std::string const& path, std::string const& name)
{
    auto const texts = texts_attribute(at, path, name);
    return texts.empty() ? std::string() : texts.front();
}

double number_attribute(hid_t at, std::string const& path, std::string const& name)
{
    return get_number<double>(at, path, name);
}

std::int64_t integer_attribute(hid_t at, std::string const& path, std::string const& name)
{
    return get_number<std::int64_t>(at, path, name);
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
