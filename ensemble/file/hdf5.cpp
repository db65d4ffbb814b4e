#include "ensemble/file/hdf5.hpp"

#include "ensemble/file/hdf5_parts.hpp"
#include "ensemble/storage/durable.hpp"

#include <cstring>
#include <fmt/format.h>

// Files, and what went wrong.
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

Properties access_properties()
{
    keep_quiet();
    Properties access(H5Pcreate(H5P_FILE_ACCESS), "make HDF5 access properties");
    // The layout of HDF5 1.8, whose headers have check sums of their own.
    check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18), "choose the HDF5 layout");
    return access;
}

File open_file(std::filesystem::path const& file, unsigned flags)
{
    auto const access = access_properties();
    auto const state = std::make_shared<DriverState>();
    use_own_driver(access, state);
    return {H5Fopen(file.c_str(), flags, access), file.string(), "open " + file.string(), state};
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

} // namespace demens::ensemble::hdf5
