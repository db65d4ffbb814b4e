#include "ensemble/file/row_writer.hpp"

#include "ensemble/storage/descriptor.hpp"
#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <numeric>
#include <zlib.h>

namespace demens::ensemble {
namespace {

using Count = unsigned long long;

Count sum_over(MPI_Comm communicator, Count value)
{
    if (communicator != MPI_COMM_NULL)
        MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, communicator);
    return value;
}

//! Of the bytes of all ranks, one after the other; on rank 0.
std::uint32_t check_sum_of_all(MPI_Comm communicator, std::span<std::byte const> bytes)
{
    std::array<Count, 2> const mine = {crc32_of(bytes), bytes.size()};
    std::vector<Count> all(2 * static_cast<std::size_t>(size_of(communicator)));
    MPI_Gather(mine.data(), 2, MPI_UNSIGNED_LONG_LONG, all.data(), 2, MPI_UNSIGNED_LONG_LONG, 0,
               communicator);
    unsigned long sum = 0; // of no bytes
    for (std::size_t i = 0; rank_of(communicator) == 0 && i < all.size(); i += 2)
        sum = ::crc32_combine(sum, static_cast<unsigned long>(all[i]), static_cast<z_off_t>(all[i + 1]));
    return static_cast<std::uint32_t>(sum);
}

} // namespace

RowWriter::RowWriter(hid_t file) : RowWriter(file, MPI_COMM_NULL) {}

RowWriter::RowWriter(hid_t file, MPI_Comm communicator) : file_(file), communicator_(communicator) {}

void RowWriter::on_maker(std::function<void()> const& call)
{
    if (communicator_ == MPI_COMM_NULL)
        call();
    else if (rank_of(communicator_) == 0 && !failure_)
        failure_ = capture(call);
}

void RowWriter::make_group(std::string const& path)
{
    on_maker([&] { hdf5::make_group(file_, path); });
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
    for (std::size_t begin = 0, end = 0; (end = all.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
        auto text = all.substr(begin, end - begin);
        if (std::find(texts.begin(), texts.end(), text) == texts.end())
            texts.push_back(std::move(text));
    }
    return texts;
}

template <class T>
void RowWriter::write(std::string const& path, std::vector<T> const& local, hdf5::Meaning const& meaning,
                      std::size_t columns)
{
    write_rows(path,
               {hdf5::type_of<T>(), std::as_bytes(std::span(local)),
                columns ? local.size() / columns : local.size(), columns},
               meaning);
}

void RowWriter::write_texts(std::string const& path, std::vector<std::string> const& local,
                            std::string const& doc)
{
    Count length = 1;
    for (auto const& text : local)
        length = std::max<Count>(length, text.size());
    if (communicator_ != MPI_COMM_NULL)
        MPI_Allreduce(MPI_IN_PLACE, &length, 1, MPI_UNSIGNED_LONG_LONG, MPI_MAX, communicator_);
    std::string packed;
    for (auto const& text : local)
        packed += text + std::string(length - text.size(), '\0');
    auto const type = hdf5::text_type(length);
    write_rows(path, {type, std::as_bytes(std::span(packed)), local.size(), 0},
               {.units = {}, .columns = {}, .doc = doc});
}

void RowWriter::write_rows(std::string const& path, Rows const& rows, hdf5::Meaning const& meaning)
{
    std::vector<std::size_t> shape = {static_cast<std::size_t>(sum_over(communicator_, rows.count))};
    if (rows.columns > 0)
        shape.push_back(rows.columns);
    if (communicator_ == MPI_COMM_NULL) {
        auto dataset = hdf5::create_dataset(file_, path, rows.type, shape, meaning, crc32_of(rows.bytes));
        hdf5::check(H5Dwrite(dataset, rows.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.bytes.data()),
                    "write " + path);
        dataset.close("write " + path);
        return;
    }
    auto const check_sum = check_sum_of_all(communicator_, rows.bytes);
    Count place = 0;
    on_maker([&] {
        auto dataset = hdf5::create_dataset(file_, path, rows.type, shape, meaning, check_sum);
        place = H5Dget_offset(dataset); // no place for no numbers, and nobody uses it
        dataset.close("create " + path);
    });
    MPI_Bcast(&place, 1, MPI_UNSIGNED_LONG_LONG, 0, communicator_);
    auto const before = first_row(rows.bytes.size());
    if (!rows.bytes.empty())
        pieces_.push_back({place + before, {rows.bytes.begin(), rows.bytes.end()}});
}

std::vector<Piece> RowWriter::pieces()
{
    agree(communicator_, failure_);
    return std::move(pieces_);
}

void write_pieces(std::filesystem::path const& path, std::vector<Piece> const& pieces)
{
    Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC));
    if (!file)
        throw system_error("open", path, errno);
    for (auto const& piece : pieces)
        if (int const error = write_at(file.get(), piece.bytes, piece.place))
            throw system_error("write", path, error);
    if (::fsync(file.get()) != 0)
        throw system_error("write", path, errno);
    ::posix_fadvise(file.get(), 0, 0, POSIX_FADV_DONTNEED); // so that the disk is asked
    Bytes found;
    for (auto const& piece : pieces) {
        found.resize(piece.bytes.size());
        std::size_t size = 0;
        if (int const error = read_at(file.get(), found, piece.place, size))
            throw system_error("read back", path, error);
        if (size != found.size() || found != piece.bytes)
            throw FileError(fmt::format(
                "{}: what was read back is not what was written; the disk may be failing", path.string()));
    }
    if (file.close() != 0)
        throw system_error("write", path, errno);
}

template void RowWriter::write<double>(std::string const&, std::vector<double> const&, hdf5::Meaning const&,
                                       std::size_t);
template void RowWriter::write<float>(std::string const&, std::vector<float> const&, hdf5::Meaning const&,
                                      std::size_t);
template void RowWriter::write<int>(std::string const&, std::vector<int> const&, hdf5::Meaning const&,
                                    std::size_t);
template void RowWriter::write<std::int64_t>(std::string const&, std::vector<std::int64_t> const&,
                                             hdf5::Meaning const&, std::size_t);
template void RowWriter::write<std::uint64_t>(std::string const&, std::vector<std::uint64_t> const&,
                                              hdf5::Meaning const&, std::size_t);

} // namespace demens::ensemble
