#include "ensemble/file/row_writer.hpp"

#include <algorithm>
#include <numeric>

namespace demens::ensemble {
namespace {

using Count = unsigned long long;

Count sum_over(MPI_Comm communicator, Count value)
{
    if (communicator != MPI_COMM_NULL)
        MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator);
    return value;
}

} // namespace

RowWriter::RowWriter(hid_t file, MPI_Comm communicator)
    : file_(file), communicator_(communicator),
      transfer_(H5Pcreate(H5P_DATASET_XFER), "make transfer properties")
{
    if (communicator_ != MPI_COMM_NULL)
        hdf5::check(H5Pset_dxpl_mpio(transfer_, H5FD_MPIO_COLLECTIVE), "choose collective writing");
}

std::size_t RowWriter::first_row(std::size_t local_count) const
{
    if (communicator_ == MPI_COMM_NULL)
        return 0;
    Count const mine = local_count;
    Count first = 0;
    MPI_Exscan(&mine, &first, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator_);
    int rank = 0;
    MPI_Comm_rank(communicator_, &rank);
    return rank == 0 ? 0 : first; // MPI leaves the result of rank 0 undefined
}

std::vector<std::string> RowWriter::all_texts(std::vector<std::string> const& local) const
{
    std::string mine;
    for (auto const& text : local)
        mine += text + '\n';
    std::string all = mine;
    if (communicator_ != MPI_COMM_NULL) {
        int size = 0;
        MPI_Comm_size(communicator_, &size);
        int const length = static_cast<int>(mine.size());
        std::vector<int> lengths(static_cast<std::size_t>(size)), begins(lengths.size());
        MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, communicator_);
        std::exclusive_scan(lengths.begin(), lengths.end(), begins.begin(), 0);
        all.resize(static_cast<std::size_t>(begins.back() + lengths.back()));
        MPI_Allgatherv(mine.data(), length, MPI_CHAR, all.data(), lengths.data(), begins.data(), MPI_CHAR,
                       communicator_);
    }
    std::vector<std::string> texts;
    for (std::size_t begin = 0, end; (end = all.find('\n', begin)) != std::string::npos; begin = end + 1) {
        auto text = all.substr(begin, end - begin);
        if (std::find(texts.begin(), texts.end(), text) == texts.end())
            texts.push_back(std::move(text));
    }
    return texts;
}

template <class T>
void RowWriter::write(std::string const& path, std::vector<T> const& local, hdf5::Meaning const& meaning,
                      std::size_t columns) const
{
    write_rows(path, hdf5::type_of<T>(), local.data(), columns ? local.size() / columns : local.size(),
               columns, meaning);
}

void RowWriter::write_texts(std::string const& path, std::vector<std::string> const& local,
                            std::string const& doc) const
{
    Count length = 1;
    for (auto const& text : local)
        length = std::max<Count>(length, text.size());
    if (communicator_ != MPI_COMM_NULL)
        MPI_Allreduce(MPI_IN_PLACE, &length, 1, MPI_UNSIGNED_LONG_LONG, MPI_MAX, communicator_);
    std::string packed;
    for (auto const& text : local)
        packed += text + std::string(length - text.size(), '\0');
    write_rows(path, hdf5::text_type(length), packed.data(), local.size(), 0,
               {.units = {}, .columns = {}, .doc = doc});
}

void RowWriter::write_rows(std::string const& path, hid_t type, void const* data, std::size_t local_rows,
                           std::size_t columns, hdf5::Meaning const& meaning) const
{
    std::vector<std::size_t> shape = {static_cast<std::size_t>(sum_over(communicator_, local_rows))};
    std::vector<hsize_t> begin = {first_row(local_rows)}, extent = {local_rows};
    if (columns > 0) {
        shape.push_back(columns);
        begin.push_back(0);
        extent.push_back(columns);
    }
    auto const dataset = hdf5::create_dataset(file_, path, type, shape, meaning);
    if (shape.front() == 0)
        return;
    hdf5::Space const space(H5Dget_space(dataset), "read the shape of " + path);
    hdf5::Space const memory(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
                             "make a data space");
    if (local_rows == 0) { // a collective write needs every rank, also one without rows
        hdf5::check(H5Sselect_none(space), "select no rows");
        hdf5::check(H5Sselect_none(memory), "select no rows");
    } else {
        hdf5::check(H5Sselect_hyperslab(space, H5S_SELECT_SET, begin.data(), nullptr, extent.data(), nullptr),
                    "select rows of " + path);
    }
    hdf5::check(H5Dwrite(dataset, type, memory, space, transfer_, data), "write " + path);
}

hdf5::File open_to_write_together(std::filesystem::path const& file, MPI_Comm communicator)
{
    hdf5::Properties const access(H5Pcreate(H5P_FILE_ACCESS), "make HDF5 access properties");
    hdf5::check(H5Pset_fapl_mpio(access, communicator, MPI_INFO_NULL), "choose parallel access");
    return {H5Fopen(file.c_str(), H5F_ACC_RDWR, access), "open for parallel writing " + file.string()};
}

template void RowWriter::write<double>(std::string const&, std::vector<double> const&, hdf5::Meaning const&,
                                       std::size_t) const;
template void RowWriter::write<float>(std::string const&, std::vector<float> const&, hdf5::Meaning const&,
                                      std::size_t) const;
template void RowWriter::write<int>(std::string const&, std::vector<int> const&, hdf5::Meaning const&,
                                    std::size_t) const;
template void RowWriter::write<std::int64_t>(std::string const&, std::vector<std::int64_t> const&,
                                             hdf5::Meaning const&, std::size_t) const;
template void RowWriter::write<std::uint64_t>(std::string const&, std::vector<std::uint64_t> const&,
                                              hdf5::Meaning const&, std::size_t) const;

} // namespace demens::ensemble
