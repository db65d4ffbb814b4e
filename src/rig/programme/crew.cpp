#include "src/rig/programme/crew.hpp"

#include <utility>

namespace demens::rig {

Crew::Crew(int threads)
{
    for (int t = 1; t < threads; ++t)
        threads_.emplace_back([this] { wait_for_work(); });
}

Crew::~Crew()
{
    {
        std::lock_guard const lock(mutex_);
        ends_ = true;
    }
    work_.notify_all();
}

void Crew::each(std::size_t count, std::function<void(std::size_t)> call)
{
    std::unique_lock lock(mutex_);
    call_ = std::move(call);
    next_ = 0, count_ = count;
    if (count > 1)
        work_.notify_all();
    take_calls(lock);
    done_.wait(lock, [&] { return running_ == 0; });
    if (auto const thrown = std::exchange(thrown_, nullptr))
        std::rethrow_exception(thrown);
}

void Crew::wait_for_work()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        work_.wait(lock, [&] { return ends_ || next_ < count_; });
        if (ends_)
            return;
        take_calls(lock);
    }
}

void Crew::take_calls(std::unique_lock<std::mutex>& lock)
{
    while (next_ < count_) {
        std::size_t const k = next_++;
        ++running_;
        lock.unlock();
        std::exception_ptr thrown;
        try {
            call_(k);
        } catch (...) {
            thrown = std::current_exception();
        }
        lock.lock();
        --running_;
        if (thrown)
            thrown_ = thrown;
    }
    if (running_ == 0)
        done_.notify_all();
}

} // namespace demens::rig
