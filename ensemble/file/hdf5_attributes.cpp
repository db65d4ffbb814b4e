#include "ensemble/file/hdf5_parts.hpp"

// Attributes.
namespace demens::ensemble::hdf5 {
namespace {

Attribute replace_attribute(hid_t object, std::string const& name, hid_t type, hid_t space)
{
    if (H5Aexists(object, name.c_str()) > 0)
        check(H5Adelete(object, name.c_str()), "replace the attribute " + name);
    return {H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
            "create the attribute " + name};
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

} // namespace

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

void set_attribute(hid_t at, std::string const& path, std::string const& name, std::uint32_t value)
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

} // namespace demens::ensemble::hdf5
