#include "ensemble/file/audit.hpp"

#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <zlib.h>

namespace demens::ensemble {
namespace {

using hdf5::check;

int constexpr deepest_group = 8;
int constexpr most_dimensions = 4;
hsize_t constexpr most_attributes = 64;
hsize_t constexpr longest_attribute = 1 << 16; //!< [bytes] what an object header holds

class Audit
{
  public:
    Audit(hid_t file, CheckSums check_sums) : file_(file), check_sums_(check_sums)
    {
        check(H5Fget_filesize(file, &file_size_), "size the file");
    }

    void group(std::string const& path, int depth)
    {
        if (depth > deepest_group)
            throw FileError(path + ": groups lie deeper than in any campaign file");
        hdf5::Object const object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), "open " + path);
        be_new(object, path);
        attributes(object, path);
        std::vector<std::string> names;
        check(H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, take_hard_link, &names),
              "list " + path + ", where a link leads out of the file or elsewhere in it");
        for (auto const& name : names) {
            auto const below = (path == "/" ? "" : path) + "/" + name;
            H5O_info_t info;
            check(H5Oget_info_by_name(file_, below.c_str(), &info, H5P_DEFAULT), "look at " + below);
            if (info.type == H5O_TYPE_GROUP)
                group(below, depth + 1);
            else if (info.type == H5O_TYPE_DATASET)
                dataset(below);
            else
                throw FileError(below + " is neither a group nor a dataset");
        }
    }

  private:
    static herr_t take_hard_link(hid_t, char const* name, H5L_info_t const* link, void* names)
    {
        if (link->type != H5L_TYPE_HARD)
            return -1;
        static_cast<std::vector<std::string>*>(names)->push_back(name);
        return 0;
    }

    //! A cycle would never end, and a second way to an object is in no campaign file.
    void be_new(hid_t object, std::string const& path)
    {
        H5O_info_t info;
        check(H5Oget_info(object, &info), "look at " + path);
        if (!seen_.insert(info.addr).second)
            throw FileError(path + " is in the file in two ways");
    }

    void attributes(hid_t object, std::string const& path)
    {
        H5O_info_t info;
        check(H5Oget_info(object, &info), "look at " + path);
        if (info.num_attrs > most_attributes)
            throw FileError(path + " has more attributes than any object of a campaign file");
        for (hsize_t i = 0; i < info.num_attrs; ++i) {
            auto const what = fmt::format("look at attribute {} of {}", i, path);
            hdf5::Attribute const attribute(
                H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT), what);
            hdf5::Type const type(H5Aget_type(attribute), what);
            hdf5::Space const space(H5Aget_space(attribute), what);
            auto const kind = H5Tget_class(type);
            bool const is_plain = (kind == H5T_STRING && H5Tis_variable_str(type) == 0) ||
                                  kind == H5T_INTEGER || kind == H5T_FLOAT;
            auto const count = static_cast<hsize_t>(H5Sget_simple_extent_npoints(space));
            if (!is_plain || H5Sget_simple_extent_ndims(space) > 1 || count > longest_attribute ||
                H5Tget_size(type) > longest_attribute || count * H5Tget_size(type) > longest_attribute)
                throw FileError(
                    fmt::format("attribute {} of {} is neither a number nor a short text", i, path));
        }
    }

    void dataset(std::string const& path)
    {
        hdf5::Dataset const dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), "open " + path);
        be_new(dataset, path);
        attributes(dataset, path);
        lies_in_this_file(dataset, path);
        hdf5::Type const type(H5Dget_type(dataset), "read the type of " + path);
        auto const kind = H5Tget_class(type);
        auto const width = H5Tget_size(type);
        bool const is_text = kind == H5T_STRING && H5Tis_variable_str(type) == 0;
        bool const is_number = (kind == H5T_INTEGER || kind == H5T_FLOAT) && width <= 8;
        if (!is_text && !is_number)
            throw FileError(path + " holds neither numbers nor texts of a fixed length");
        check_size(dataset, path, width);
        bool const is_checked =
            check_sums_ == CheckSums::required || hdf5::has_attribute(dataset, ".", hdf5::check_sum_name);
        if (is_checked && read_check_sum(dataset, type, width, path) != stored(path))
            throw FileError(path +
                            " is damaged: its numbers do not have the check sum that is stored with them");
    }

    void lies_in_this_file(hid_t dataset, std::string const& path)
    {
        hdf5::Properties const creation(H5Dget_create_plist(dataset), "read how " + path + " is stored");
        auto const layout = H5Pget_layout(creation);
        if (layout != H5D_CONTIGUOUS && layout != H5D_COMPACT)
            throw FileError(path + " is stored in chunks or in other files; no campaign file is");
        if (H5Pget_external_count(creation) != 0)
            throw FileError(path + " lies in other files, which are not read");
    }

    //! What the file cannot hold is refused.
    void check_size(hid_t dataset, std::string const& path, hsize_t width)
    {
        hdf5::Space const space(H5Dget_space(dataset), "read the shape of " + path);
        int const dimensions = H5Sget_simple_extent_ndims(space);
        if (dimensions < 0 || dimensions > most_dimensions)
            throw FileError(path + " has more dimensions than any dataset of a campaign file");
        extent_.assign(static_cast<std::size_t>(dimensions), 0);
        if (dimensions > 0)
            check(H5Sget_simple_extent_dims(space, extent_.data(), nullptr), "read the shape of " + path);
        hsize_t bytes = width;
        bool const is_empty = std::find(extent_.begin(), extent_.end(), hsize_t{0}) != extent_.end();
        for (auto const extent : extent_) {
            if (!is_empty && extent > file_size_ / bytes)
                throw FileError(path + " claims to be larger than the file");
            bytes = is_empty ? 0 : bytes * extent;
        }
        if (bytes > file_size_ || (!is_empty && H5Dget_storage_size(dataset) != bytes))
            throw FileError(path + " is shorter in the file than its shape says");
    }

    std::uint32_t stored(std::string const& path) const
    {
        if (!hdf5::has_attribute(file_, path, hdf5::check_sum_name))
            throw FileError(fmt::format("{} has no check sum (attribute {})", path, hdf5::check_sum_name));
        return static_cast<std::uint32_t>(hdf5::integer_attribute(file_, path, hdf5::check_sum_name));
    }

    //! Of the numbers as they lie in the file, some rows at a time.
    std::uint32_t read_check_sum(hid_t dataset, hid_t type, hsize_t width, std::string const& path) const
    {
        hsize_t constexpr at_a_time = 16 << 20; // bytes
        hsize_t row = width;
        for (std::size_t d = 1; d < extent_.size(); ++d)
            row *= extent_[d];
        hsize_t const rows = extent_.empty() ? 1 : extent_.front();
        if (row == 0 || rows == 0)
            return crc32_of(std::span<std::byte const>());
        Bytes buffer;
        unsigned long sum = 0;
        hdf5::Space const space(H5Dget_space(dataset), "read the shape of " + path);
        auto start = std::vector<hsize_t>(extent_.size(), 0), count = extent_;
        hsize_t const step = std::max<hsize_t>(1, at_a_time / row);
        for (hsize_t first = 0; first < rows; first += step) {
            auto const now = std::min(step, rows - first);
            buffer.resize(now * row);
            hdf5::Space memory;
            if (!extent_.empty()) {
                start.front() = first;
                count.front() = now;
                check(
                    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
                    "select rows of " + path);
                memory = hdf5::Space(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr),
                                     "make a data space");
            }
            check(H5Dread(dataset, type, extent_.empty() ? H5S_ALL : static_cast<hid_t>(memory),
                          extent_.empty() ? H5S_ALL : static_cast<hid_t>(space), H5P_DEFAULT, buffer.data()),
                  "read " + path);
            sum = ::crc32_z(sum, reinterpret_cast<unsigned char const*>(buffer.data()), buffer.size());
        }
        return static_cast<std::uint32_t>(sum);
    }

    hid_t file_;
    CheckSums check_sums_;
    hsize_t file_size_ = 0;
    std::set<haddr_t> seen_;      //!< addresses of objects
    std::vector<hsize_t> extent_; //!< of the dataset that is looked at
};

} // namespace

void audit(hid_t file, CheckSums check_sums)
{
    Audit(file, check_sums).group("/", 0);
}

} // namespace demens::ensemble
