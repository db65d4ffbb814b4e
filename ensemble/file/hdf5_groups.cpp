#include "ensemble/file/hdf5_parts.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

// Groups, shapes and texts.
namespace demens::ensemble::hdf5 {

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

Object open_object(hid_t at, std::string const& path)
{
    return {H5Oopen(at, path.c_str(), H5P_DEFAULT), "open " + path};
}

void keep_links_in_header(hid_t group_creation)
{
    unsigned constexpr most = 65535;
    check(H5Pset_link_phase_change(group_creation, most, most - 1), "choose how groups are stored");
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

} // namespace demens::ensemble::hdf5
