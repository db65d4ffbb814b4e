#include "app/command.hpp"
#include "report/export.hpp"
#include "report/report.hpp"

#include <fmt/format.h>

namespace demens::cli {

void add_report(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string file, output;
    };
    auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand("report", "write one HTML page with tables and plots");
    command->add_option("FILE.h5", options->file, "campaign file; may be running")->required();
    command->add_option("-o,--output", options->output, "page to write; default FILE.html");
    command->callback([options, &action] {
        action = [options] {
            std::filesystem::path page = options->output;
            if (page.empty())
                page = std::filesystem::path(options->file).replace_extension(".html");
            report::write_report(options->file, page);
            fmt::print("wrote {}\n", page.string());
            return success;
        };
    });
}

void add_export(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string file, folder;
    };
    auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand(
        "export", "write runs, curves and factors as CSV, the best point as a campaign");
    command->add_option("FILE.h5", options->file, "campaign file; may be running")->required();
    command->add_option("-o,--output", options->folder, "folder to write into; default FILE.export");
    command->callback([options, &action] {
        action = [options] {
            std::filesystem::path folder = options->folder;
            if (folder.empty())
                folder = std::filesystem::path(options->file).replace_extension(".export");
            for (auto const& file : report::export_campaign(options->file, folder))
                fmt::print("wrote {}\n", file.string());
            return success;
        };
    });
}

} // namespace demens::cli
