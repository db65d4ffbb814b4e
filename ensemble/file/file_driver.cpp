#include "ensemble/file/file_driver.hpp"

#include "ensemble/file/hdf5.hpp"
#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>

namespace demens::ensemble::hdf5 {
namespace {

//! What the access properties carry; HDF5 copies it byte by byte.
struct DriverInfo
{
    DriverState* state; //!< owned by the File that is opened
};

//! An open file as HDF5 sees it: its own part comes first.
struct OpenFile
{
    H5FD_t base = {};
    int descriptor = -1; //!< -1: in memory
    haddr_t end_allocated = 0;
    haddr_t end_of_file = 0;
    DriverState* state = nullptr;
};

OpenFile& self(H5FD_t* file)
{
    return *reinterpret_cast<OpenFile*>(file);
}
OpenFile const& self(H5FD_t const* file)
{
    return *reinterpret_cast<OpenFile const*>(file);
}

void note(OpenFile const& file, char const* doing, int error)
{
    if (file.state->error != 0)
        return;
    file.state->error = error;
    file.state->doing = doing;
}

H5FD_t* open_memory(DriverState* state)
{
    auto* file = new OpenFile;
    file->end_of_file = state->memory->size();
    file->state = state;
    return &file->base;
}

H5FD_t* open(char const* name, unsigned flags, hid_t access, haddr_t)
{
    auto const* info = static_cast<DriverInfo const*>(H5Pget_driver_info(access));
    if (info && info->state->memory)
        return open_memory(info->state);
    if (!info || flags & H5F_ACC_TRUNC)
        return nullptr; // new files are made in memory
    int const mode = flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY;
    int const descriptor = ::open(name, mode | O_CLOEXEC);
    struct stat status = {};
    if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
        info->state->error = errno;
        info->state->doing = "open";
        if (descriptor >= 0)
            ::close(descriptor);
        return nullptr;
    }
    auto* file = new OpenFile;
    file->descriptor = descriptor;
    file->end_of_file = static_cast<haddr_t>(status.st_size);
    file->state = info->state;
    return &file->base;
}

herr_t close(H5FD_t* base)
{
    auto* file = &self(base);
    if (file->descriptor >= 0 && ::close(file->descriptor) != 0)
        note(*file, "close", errno);
    delete file;
    return 0;
}

int compare(H5FD_t const* a, H5FD_t const* b)
{
    if (self(a).descriptor < 0 || self(b).descriptor < 0)
        return a == b ? 0 : a < b ? -1 : 1;
    struct stat first = {}, second = {};
    if (::fstat(self(a).descriptor, &first) != 0 || ::fstat(self(b).descriptor, &second) != 0)
        return a < b ? -1 : 1;
    auto const key = [](struct stat const& s) { return std::pair(s.st_dev, s.st_ino); };
    return key(first) < key(second) ? -1 : key(second) < key(first) ? 1 : 0;
}

herr_t query(H5FD_t const*, unsigned long* flags)
{
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

haddr_t end_allocated(H5FD_t const* file, H5FD_mem_t)
{
    return self(file).end_allocated;
}

herr_t set_end_allocated(H5FD_t* file, H5FD_mem_t, haddr_t address)
{
    self(file).end_allocated = address;
    return 0;
}

haddr_t end_of_file(H5FD_t const* file, H5FD_mem_t)
{
    return self(file).end_of_file;
}

herr_t read(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer)
{
    auto const& file = self(base);
    std::span const bytes(static_cast<std::byte*>(buffer), size);
    std::size_t done = 0;
    if (file.state->memory) {
        auto const& memory = *file.state->memory;
        auto const begin = std::min<std::size_t>(address, memory.size());
        done = std::min(size, memory.size() - begin);
        std::copy_n(memory.begin() + static_cast<std::ptrdiff_t>(begin), done, bytes.begin());
    } else if (int const error = read_at(file.descriptor, bytes, address, done)) {
        note(file, "read", error);
        return -1;
    }
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(done), bytes.end(), std::byte{});
    return 0;
}

herr_t write(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void const* buffer)
{
    auto& file = self(base);
    std::span const bytes(static_cast<std::byte const*>(buffer), size);
    file.end_of_file = std::max<haddr_t>(file.end_of_file, address + size);
    if (auto& memory = file.state->memory) {
        memory->resize(std::max<std::size_t>(memory->size(), address + size));
        std::copy(bytes.begin(), bytes.end(), memory->begin() + static_cast<std::ptrdiff_t>(address));
    } else if (int const error = write_at(file.descriptor, bytes, address)) {
        note(file, "write", error);
    }
    return 0;
}

herr_t truncate(H5FD_t* base, hid_t, hbool_t)
{
    auto& file = self(base);
    if (file.end_of_file == file.end_allocated)
        return 0;
    if (file.state->memory)
        file.state->memory->resize(file.end_allocated);
    else if (::ftruncate(file.descriptor, static_cast<off_t>(file.end_allocated)) != 0)
        note(file, "resize", errno);
    file.end_of_file = file.end_allocated;
    return 0;
}

hid_t driver()
{
    static H5FD_class_t const description = [] {
        H5FD_class_t made = {};
#if H5_VERSION_GE(1, 14, 0)
        made.version = H5FD_CLASS_VERSION;
        made.value = static_cast<H5FD_class_value_t>(402); // of those that are free for tests and own use
#endif
        made.name = "demens";
        made.maxaddr = (haddr_t{1} << 62) - 1;
        made.fc_degree = H5F_CLOSE_WEAK;
        made.fapl_size = sizeof(DriverInfo);
        made.open = open;
        made.close = close;
        made.cmp = compare;
        made.query = query;
        made.get_eoa = end_allocated;
        made.set_eoa = set_end_allocated;
        made.get_eof = end_of_file;
        made.read = read;
        made.write = write;
        made.truncate = truncate;
        H5FD_mem_t constexpr lists[H5FD_MEM_NTYPES] = H5FD_FLMAP_DICHOTOMY;
        std::copy(std::begin(lists), std::end(lists), std::begin(made.fl_map));
        return made;
    }();
    static hid_t const number = H5FDregister(&description);
    return number;
}

} // namespace

void use_own_driver(hid_t access_properties, std::shared_ptr<DriverState> const& state)
{
    DriverInfo const info{state.get()};
    check(H5Pset_driver(access_properties, driver(), &info), "choose the file driver");
}

} // namespace demens::ensemble::hdf5
