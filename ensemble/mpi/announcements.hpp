#pragma once

#include "ensemble/mpi/agreement.hpp"

#include <cstring>
#include <deque>
#include <span>

namespace demens::ensemble {

//! Messages of rank 0 to all ranks, which they fetch when they come to it, while rank 0 goes on. That there
//! is one is told by other means. Construction is collective; every rank must have fetched all of them before
//! the destruction.
class Announcements
{
  public:
    explicit Announcements(MPI_Comm communicator) : communicator_(Communicator::duplicate(communicator)) {}
    ~Announcements();
    Announcements(Announcements const&) = delete;
    Announcements& operator=(Announcements const&) = delete;

    //! On rank 0.
    void send(Bytes message);
    //! The next one, on the other ranks.
    Bytes receive();
    //! Lets those that are on their way go on; called now and then by rank 0.
    void progress();

    template <class T>
    void send_numbers(std::vector<T> const& numbers)
    {
        auto const bytes = std::as_bytes(std::span(numbers));
        send({bytes.begin(), bytes.end()});
    }
    template <class T>
    std::vector<T> receive_numbers()
    {
        auto const bytes = receive();
        std::vector<T> numbers(bytes.size() / sizeof(T));
        if (!bytes.empty())
            std::memcpy(numbers.data(), bytes.data(), bytes.size());
        return numbers;
    }

  private:
    struct Message
    {
        int size;
        Bytes bytes;
        MPI_Request requests[2];
    };

    Communicator communicator_;
    std::deque<Message> messages_; //!< of rank 0, on their way
};

} // namespace demens::ensemble
