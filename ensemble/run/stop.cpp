#include "ensemble/run/stop.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <unistd.h>
#include <vector>

namespace demens::ensemble {
namespace {

// Signal handlers can reach nothing but static storage.
std::sig_atomic_t volatile request_flag = 0;

std::array constexpr stop_numbers = {SIGUSR1, SIGTERM, SIGINT, SIGXFSZ};
std::array<struct sigaction, stop_numbers.size()> stop_previous;

std::array constexpr crash_numbers = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};
std::array<struct sigaction, crash_numbers.size()> crash_previous;
struct NotedLines
{
    std::vector<char> text;
    char const* data = nullptr;
    std::size_t length = 0;

    void set(std::string const& lines)
    {
        text.assign(lines.begin(), lines.end());
        data = text.data(), length = text.size();
    }
};
std::array<NotedLines, crash_numbers.size()> crash_lines;
NotedLines stop_lines;
std::sig_atomic_t volatile is_noting_stop = 0; // a run is in progress whose journal does not tell of it yet
int volatile crash_descriptor = -1;
alignas(16) std::array<char, 16384> crash_stack; // a run may have died of too little stack

void on_stop(int signal)
{
    int const asked = signal == SIGUSR1 ? static_cast<int>(StopRequest::after_runs)
                                        : static_cast<int>(StopRequest::at_once);
    if (asked > request_flag)
        request_flag = asked;
    if (signal != SIGUSR1 && is_noting_stop) {
        is_noting_stop = 0;
        int const saved = errno;
        if (::write(crash_descriptor, stop_lines.data, stop_lines.length) > 0)
            ::fdatasync(crash_descriptor);
        errno = saved;
    }
}

void on_crash(int signal)
{
    for (std::size_t i = 0; i < crash_numbers.size(); ++i)
        if (crash_numbers[i] == signal) {
            if (::write(crash_descriptor, crash_lines[i].data, crash_lines[i].length) > 0)
                ::fdatasync(crash_descriptor);
            ::sigaction(signal, &crash_previous[i], nullptr);
        }
    ::raise(signal);
}

double drain_seconds()
{
    char const* const text = std::getenv("DEMENS_DRAIN_SECONDS");
    return text ? std::atof(text) : 240.0;
}

} // namespace

StopSignals::StopSignals()
{
    for (std::size_t i = 0; i < stop_numbers.size(); ++i) {
        struct sigaction action = {};
        action.sa_handler = stop_numbers[i] == SIGXFSZ ? SIG_IGN : on_stop;
        action.sa_flags = SA_RESTART;
        ::sigaction(stop_numbers[i], &action, &stop_previous[i]);
    }
}

StopSignals::~StopSignals()
{
    for (std::size_t i = 0; i < stop_numbers.size(); ++i)
        ::sigaction(stop_numbers[i], &stop_previous[i], nullptr);
}

StopRequest StopSignals::request()
{
    return static_cast<StopRequest>(static_cast<int>(request_flag));
}

bool StopSignals::should_stop_run()
{
    if (request() != StopRequest::after_runs)
        return request() == StopRequest::at_once;
    using Clock = std::chrono::steady_clock;
    static auto const asked = Clock::now();
    static double const patience = drain_seconds();
    return std::chrono::duration<double>(Clock::now() - asked).count() >= patience;
}

int CrashNote::signal_number(int i)
{
    return crash_numbers[static_cast<std::size_t>(i)];
}

void CrashNote::set_lines(int i, std::string const& lines)
{
    crash_lines[static_cast<std::size_t>(i)].set(lines);
}

void CrashNote::set_stop_lines(std::string const& lines)
{
    stop_lines.set(lines);
}

void CrashNote::arm(int descriptor)
{
    static_assert(signal_count == crash_numbers.size());
    crash_descriptor = descriptor;
    is_noting_stop = 1;
    stack_t stack = {};
    stack.ss_sp = crash_stack.data();
    stack.ss_size = crash_stack.size();
    ::sigaltstack(&stack, nullptr);
    for (std::size_t i = 0; i < crash_numbers.size(); ++i) {
        struct sigaction action = {};
        action.sa_handler = on_crash;
        action.sa_flags = SA_ONSTACK;
        ::sigaction(crash_numbers[i], &action, &crash_previous[i]);
    }
}

CrashNote::~CrashNote()
{
    is_noting_stop = 0;
    for (std::size_t i = 0; i < crash_numbers.size(); ++i)
        ::sigaction(crash_numbers[i], &crash_previous[i], nullptr);
}

} // namespace demens::ensemble
