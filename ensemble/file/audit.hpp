#pragma once

#include "ensemble/file/hdf5.hpp"

namespace demens::ensemble {

//! What is known of the file that is looked at.
enum class CheckSums
{
    required,     //!< every dataset has one
    where_present //!< written by a program that knew none
};

//! Looks at everything in a file before anything in it is used, since it may be damaged, or made to do harm:
//! only groups and datasets, each reached in one way, and no links that lead elsewhere; numbers and texts
//! that lie in this file, of a size that the file can hold; attributes that are short; the check sums of all
//! datasets. \throws FileError that names what is wrong
void audit(hid_t file, CheckSums check_sums);

} // namespace demens::ensemble
