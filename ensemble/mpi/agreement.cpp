#include "ensemble/mpi/agreement.hpp"

#include "demens/base/error.hpp"
#include "demens/base/file_error.hpp"

#include <utility>

namespace demens::ensemble {
namespace {

template <class Container>
void broadcast_contents(MPI_Comm communicator, Container& contents)
{
    unsigned long long size = contents.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, communicator);
    contents.resize(size);
    auto* data = reinterpret_cast<char*>(contents.data());
    unsigned long long constexpr largest = 1u << 30; // MPI counts are ints
    for (unsigned long long left = size * sizeof(*contents.data()); left > 0;) {
        auto const part = std::min(left, largest);
        MPI_Bcast(data, static_cast<int>(part), MPI_BYTE, 0, communicator);
        data += part;
        left -= part;
    }
}

[[noreturn]] void raise(Failure::Kind kind, std::string const& message)
{
    if (kind == Failure::Kind::input)
        throw InputError(message);
    if (kind == Failure::Kind::file)
        throw FileError(message);
    throw std::runtime_error(message);
}

} // namespace

Failure capture(std::function<void()> const& call)
{
    try {
        call();
        return {};
    } catch (InputError const& error) {
        return {Failure::Kind::input, error.what()};
    } catch (FileError const& error) {
        return {Failure::Kind::file, error.what()};
    } catch (std::exception const& error) {
        return {Failure::Kind::other, error.what()};
    }
}

void agree(MPI_Comm communicator, Failure const& mine)
{
    int const size = size_of(communicator);
    int lowest = mine ? rank_of(communicator) : size;
    MPI_Allreduce(MPI_IN_PLACE, &lowest, 1, MPI_INT, MPI_MIN, communicator);
    if (lowest == size)
        return;
    int kind = static_cast<int>(mine.kind);
    int length = static_cast<int>(mine.message.size());
    MPI_Bcast(&kind, 1, MPI_INT, lowest, communicator);
    MPI_Bcast(&length, 1, MPI_INT, lowest, communicator);
    std::string message = mine.message;
    message.resize(static_cast<std::size_t>(length));
    MPI_Bcast(message.data(), length, MPI_CHAR, lowest, communicator);
    raise(static_cast<Failure::Kind>(kind), message);
}

void on_root(MPI_Comm communicator, std::function<void()> const& call)
{
    agree(communicator, rank_of(communicator) == 0 ? capture(call) : Failure{});
}

void on_all(MPI_Comm communicator, std::function<void()> const& call)
{
    agree(communicator, capture(call));
}

int rank_of(MPI_Comm communicator)
{
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    return rank;
}

int size_of(MPI_Comm communicator)
{
    int size = 0;
    MPI_Comm_size(communicator, &size);
    return size;
}

void broadcast(MPI_Comm communicator, Bytes& bytes)
{
    broadcast_contents(communicator, bytes);
}
void broadcast(MPI_Comm communicator, std::vector<int>& numbers)
{
    broadcast_contents(communicator, numbers);
}
void broadcast(MPI_Comm communicator, std::vector<double>& numbers)
{
    broadcast_contents(communicator, numbers);
}
void broadcast(MPI_Comm communicator, std::string& text)
{
    broadcast_contents(communicator, text);
}

Communicator Communicator::duplicate(MPI_Comm communicator)
{
    Communicator copy;
    MPI_Comm_dup(communicator, &copy.communicator_);
    return copy;
}

Communicator Communicator::split(MPI_Comm communicator, int colour)
{
    Communicator part;
    MPI_Comm_split(communicator, colour < 0 ? MPI_UNDEFINED : colour, rank_of(communicator),
                   &part.communicator_);
    return part;
}

Communicator Communicator::of_node(MPI_Comm communicator)
{
    Communicator part;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, rank_of(communicator), MPI_INFO_NULL,
                        &part.communicator_);
    return part;
}

Communicator::~Communicator()
{
    if (communicator_ != MPI_COMM_NULL)
        MPI_Comm_free(&communicator_);
}

Communicator::Communicator(Communicator&& other) noexcept
    : communicator_(std::exchange(other.communicator_, MPI_COMM_NULL))
{
}

Communicator& Communicator::operator=(Communicator&& other) noexcept
{
    std::swap(communicator_, other.communicator_);
    return *this;
}

} // namespace demens::ensemble
