#pragma once

#include "ensemble/file/hdf5.hpp"
#include "ensemble/mpi/agreement.hpp"

#include <functional>
#include <mpi.h>
#include <span>
#include <string>
#include <vector>

namespace demens::ensemble {

//! Numbers of one rank and where they belong in a file.
struct Piece
{
    std::uintmax_t place; //!< [bytes] from the beginning of the file
    Bytes bytes;
};

//! Writes tables whose rows are spread over the ranks of a communicator: the rows of rank 0, then those of
//! rank 1, ... Rank 0 alone makes the datasets, in full size and with the check sums of all ranks; what each
//! rank then has to put into the closed file is in pieces(). So no rank waits inside HDF5 for another one
//! whose disk fails. With MPI_COMM_NULL one process holds all rows and writes them at once: a shard in
//! memory, a message between ranks. Member functions are collective.
class RowWriter
{
  public:
    //! One process. The file must outlive the writer.
    explicit RowWriter(hid_t file);
    //! \param file on rank 0, anything elsewhere
    RowWriter(hid_t file, MPI_Comm communicator);

    void make_group(std::string const& path);
    template <class Value>
    void set_attribute(std::string const& path, std::string const& name, Value const& value)
    {
        on_maker([&] { hdf5::set_attribute(file_, path, name, value); });
    }
    //! Sum of the local counts of all ranks below this one: where this rank's rows begin.
    std::size_t first_row(std::size_t local_count) const;
    //! The texts of all ranks, without repetition, in the order of the rows.
    std::vector<std::string> all_texts(std::vector<std::string> const& local) const;

    //! Creates the dataset [rows of all ranks] or, with `columns` > 0, [rows of all ranks x columns], with
    //! this rank's rows in it.
    template <class T>
    void write(std::string const& path, std::vector<T> const& local, hdf5::Meaning const& meaning,
               std::size_t columns = 0);
    void write_texts(std::string const& path, std::vector<std::string> const& local, std::string const& doc);

    //! What this rank has to write into the file once rank 0 has closed it. \throws FileError on all ranks
    //! when rank 0 failed before
    std::vector<Piece> pieces();

  private:
    //! Rows of one rank as they will lie in the file.
    struct Rows
    {
        hid_t type;
        std::span<std::byte const> bytes;
        std::size_t count, columns;
    };
    void write_rows(std::string const& path, Rows const& rows, hdf5::Meaning const& meaning);
    //! Calls on the rank that makes the file, unless it has failed before; keeps its failure.
    void on_maker(std::function<void()> const& call);

    hid_t file_;
    MPI_Comm communicator_;
    Failure failure_; //!< of rank 0
    std::vector<Piece> pieces_;
};

//! Writes pieces into an existing file, syncs it and reads them back. \throws FileError
void write_pieces(std::filesystem::path const& file, std::vector<Piece> const& pieces);

} // namespace demens::ensemble
