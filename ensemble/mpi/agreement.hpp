#pragma once

#include "demens/base/bytes.hpp"

#include <functional>
#include <mpi.h>
#include <string>
#include <vector>

//! Ranks that must go on, or fail, together.
namespace demens::ensemble {

//! An exception as it can be sent to other ranks.
struct Failure
{
    enum class Kind
    {
        none,
        input,
        file,
        other
    };
    Kind kind = Kind::none;
    std::string message;

    explicit operator bool() const { return kind != Kind::none; }
};

//! Calls and gives back what was thrown.
Failure capture(std::function<void()> const& call);
//! Throws the failure of the lowest rank that has one, the same on all ranks. Collective.
void agree(MPI_Comm communicator, Failure const& mine);
//! Calls on rank 0; all ranks throw when it throws. Collective.
void on_root(MPI_Comm communicator, std::function<void()> const& call);
//! Calls on every rank; all ranks throw when one throws. `call` must not communicate. Collective.
void on_all(MPI_Comm communicator, std::function<void()> const& call);

int rank_of(MPI_Comm communicator);
int size_of(MPI_Comm communicator);
//! Rank 0's bytes. Collective.
void broadcast(MPI_Comm communicator, Bytes& bytes);
void broadcast(MPI_Comm communicator, std::vector<int>& numbers);
void broadcast(MPI_Comm communicator, std::vector<double>& numbers);
void broadcast(MPI_Comm communicator, std::string& text);

//! A communicator of its own; freed with its owner.
class Communicator
{
  public:
    Communicator() = default;
    static Communicator duplicate(MPI_Comm communicator);
    //! Ranks of the same colour; those with a negative colour get none.
    static Communicator split(MPI_Comm communicator, int colour);
    //! Ranks of this rank's node.
    static Communicator of_node(MPI_Comm communicator);
    ~Communicator();
    Communicator(Communicator&& other) noexcept;
    Communicator& operator=(Communicator&& other) noexcept;

    operator MPI_Comm() const { return communicator_; }

  private:
    MPI_Comm communicator_ = MPI_COMM_NULL;
};

} // namespace demens::ensemble
