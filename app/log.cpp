#include "app/log.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace demens::cli {

CLI::Option* add_log_level(CLI::App& command, std::string& level)
{
    return command
        .add_option(
            "--log-level", level,
            "what is told while it runs: error (what ends it), warning (and why runs failed), info (and "
            "how far it is; default), debug (and each run as it begins and ends, with the time and the "
            "rank)")
        ->check(CLI::IsMember({"error", "warning", "info", "debug"}));
}

void begin_log(std::string const& level, int rank)
{
    auto const log =
        std::make_shared<spdlog::logger>("demens", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    log->set_level(spdlog::level::from_str(level));
    log->flush_on(spdlog::level::debug);
    log->set_pattern(log->should_log(spdlog::level::debug) ? fmt::format("%T.%e rank {}: %v", rank) : "%v");
    spdlog::set_default_logger(log);
}

} // namespace demens::cli
