#pragma once

#include "ensemble/file/hdf5.hpp"

//! What the functions of hdf5.hpp share among themselves.
namespace demens::ensemble::hdf5 {

//! Product of the extents.
std::size_t count_of(std::vector<std::size_t> const& shape);
std::vector<std::size_t> shape_of(hid_t space);
//! Without extents: a scalar.
Space make_space(std::vector<std::size_t> const& shape);
Object open_object(hid_t at, std::string const& path);

//! Links lie in the header of their group, which has a check sum; HDF5 1.10 crashes on damage in the heap in
//! which it would keep many of them.
void keep_links_in_header(hid_t group_creation);

//! Equally long texts one after the other, zero-padded.
std::string pack(std::vector<std::string> const& texts, std::size_t length);
std::vector<std::string> unpack(std::string const& packed, std::size_t length);
std::size_t longest(std::vector<std::string> const& texts);

} // namespace demens::ensemble::hdf5
