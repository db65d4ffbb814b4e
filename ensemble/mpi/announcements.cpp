#include "ensemble/mpi/announcements.hpp"

#include "ensemble/mpi/patience.hpp"

namespace demens::ensemble {

Announcements::~Announcements()
{
    for (auto& message : messages_)
        for (auto& request : message.requests)
            wait_patiently(request);
}

void Announcements::send(Bytes bytes)
{
    auto& message = messages_.emplace_back();
    message.size = static_cast<int>(bytes.size());
    message.bytes = std::move(bytes);
    MPI_Ibcast(&message.size, 1, MPI_INT, 0, communicator_, &message.requests[0]);
    MPI_Ibcast(message.bytes.data(), message.size, MPI_BYTE, 0, communicator_, &message.requests[1]);
}

Bytes Announcements::receive()
{
    int size = 0;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(&size, 1, MPI_INT, 0, communicator_, &request);
    wait_patiently(request);
    Bytes bytes(static_cast<std::size_t>(size));
    MPI_Ibcast(bytes.data(), size, MPI_BYTE, 0, communicator_, &request);
    wait_patiently(request);
    return bytes;
}

void Announcements::progress()
{
    while (!messages_.empty()) {
        int arrived = 0;
        MPI_Testall(2, messages_.front().requests, &arrived, MPI_STATUSES_IGNORE);
        if (!arrived)
            return;
        messages_.pop_front();
    }
}

} // namespace demens::ensemble
