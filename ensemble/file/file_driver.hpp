#pragma once

#include "demens/base/bytes.hpp"

#include <hdf5.h>
#include <memory>
#include <optional>
#include <string>

namespace demens::ensemble::hdf5 {

//! Where a file lies, and what went wrong while HDF5 wrote it; outlives the file.
struct DriverState
{
    std::optional<Bytes> memory; //!< the content of a file that is in memory only
    int error = 0;               //!< errno of the first failure; 0: none
    std::string doing;           //!< what failed, e.g. "write"
};

//! Makes HDF5 use memory, or plain files of the operating system through this program's own functions, on
//! which it can rely when a disk fails. HDF5 1.10 crashes or waits for ever when a write fails and tells of
//! it too late: it never learns of it here, but the state does, which whoever closes the file must ask. Reads
//! are tried again. Files are not locked: they are never changed in place, and campaigns have a lock of their
//! own.
void use_own_driver(hid_t access_properties, std::shared_ptr<DriverState> const& state);

} // namespace demens::ensemble::hdf5
