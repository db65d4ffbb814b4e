#pragma once

#include <string>

namespace demens::ensemble {

//! What a signal asks for.
enum class StopRequest
{
    none,
    after_runs, //!< SIGUSR1: let what runs come to its end, if that takes not too long, and start nothing
    at_once     //!< SIGTERM, SIGINT: give up what runs
};

//! While it lives, SIGUSR1, SIGTERM and SIGINT only set a flag, and a file that grows over a limit (SIGXFSZ)
//! is an error, not a death. Made after PETSc's initialisation, which takes signals too. The flag outlives
//! it.
class StopSignals
{
  public:
    StopSignals();
    ~StopSignals();
    StopSignals(StopSignals const&) = delete;
    StopSignals& operator=(StopSignals const&) = delete;

    static StopRequest request();
    //! Whether a run in progress should end now: at once, or when `patience` [s] has passed since the first
    //! call that saw SIGUSR1. DEMENS_DRAIN_SECONDS sets the patience, 240 s by default.
    static bool should_stop_run();
};

//! While it lives, a signal writes lines to a file first: a deadly one of this process (e.g. a segmentation
//! fault), or the first that asks it to end (SIGTERM, SIGINT).
class CrashNote
{
  public:
    //! `lines_of(signal)` is called now, once per deadly signal.
    template <class LinesOf>
    CrashNote(int descriptor, std::string const& stop_lines, LinesOf lines_of)
    {
        set_stop_lines(stop_lines);
        for (int i = 0; i < signal_count; ++i)
            set_lines(i, lines_of(signal_number(i)));
        arm(descriptor);
    }
    ~CrashNote();
    CrashNote(CrashNote const&) = delete;
    CrashNote& operator=(CrashNote const&) = delete;

  private:
    static int constexpr signal_count = 5;
    static int signal_number(int i);
    static void set_stop_lines(std::string const& lines);
    static void set_lines(int i, std::string const& lines);
    static void arm(int descriptor);
};

} // namespace demens::ensemble
