#pragma once

#include "ensemble/file/hdf5.hpp"

#include <mpi.h>
#include <string>
#include <vector>

namespace demens::ensemble {

//! Writes tables whose rows are spread over the ranks of a communicator: the rows of rank 0, then those of
//! rank 1, ... With MPI_COMM_NULL one process holds all rows. The same code thus writes a shard in memory, a
//! message between ranks and, in parallel, the campaign file. Every member function is collective.
class RowWriter
{
  public:
    explicit RowWriter(hid_t file, MPI_Comm communicator = MPI_COMM_NULL);

    hid_t file() const { return file_; }
    //! Sum of the local counts of all ranks below this one: where this rank's rows begin.
    std::size_t first_row(std::size_t local_count) const;
    //! The texts of all ranks, without repetition, in the order of the rows.
    std::vector<std::string> all_texts(std::vector<std::string> const& local) const;

    //! Creates the dataset [rows of all ranks] or, with `columns` > 0, [rows of all ranks x columns], and
    //! writes this rank's rows.
    template <class T>
    void write(std::string const& path, std::vector<T> const& local, hdf5::Meaning const& meaning,
               std::size_t columns = 0) const;
    void write_texts(std::string const& path, std::vector<std::string> const& local,
                     std::string const& doc) const;

  private:
    void write_rows(std::string const& path, hid_t type, void const* data, std::size_t local_rows,
                    std::size_t columns, hdf5::Meaning const& meaning) const;

    hid_t file_;
    MPI_Comm communicator_;
    hdf5::Properties transfer_;
};

//! Opens an existing file for writing by all ranks together. \throws FileError
hdf5::File open_to_write_together(std::filesystem::path const& file, MPI_Comm communicator);

} // namespace demens::ensemble
