#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace demens::rig {

//! Threads that stay, and share the calls of a loop with the thread that asks for it.
class Crew
{
  public:
    //! \param threads with that of the caller
    explicit Crew(int threads);
    ~Crew();

    //! Calls for each of 0 to count - 1; throws what one of the calls throws, when all are done.
    void each(std::size_t count, std::function<void(std::size_t)> call);

  private:
    void wait_for_work();
    void take_calls(std::unique_lock<std::mutex>& lock);

    std::mutex mutex_;
    std::condition_variable work_, done_;
    std::function<void(std::size_t)> call_;
    std::size_t next_ = 0, count_ = 0, running_ = 0;
    std::exception_ptr thrown_;
    bool ends_ = false;
    std::vector<std::jthread> threads_; //!< last, since they use the rest
};

} // namespace demens::rig
