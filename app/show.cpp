#include "app/checks.hpp"
#include "app/command.hpp"
#include "app/page_extras.hpp"
#include "report/export.hpp"
#include "report/report.hpp"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <thread>
#include <utility>

namespace demens::cli {
namespace {

//! Writes the page again whenever runs have ended, as long as somebody works on the campaign, and once more
//! at the end.
int follow(std::filesystem::path const& file, std::filesystem::path const& page, double every)
{
    for (int done = -1;;) {
        auto const status = ensemble::read_status(file);
        if (status.state != ensemble::CampaignState::running) {
            report::write_report(file, page);
            fmt::print("wrote {}\n", page.string());
            return status.state == ensemble::CampaignState::ended ? success : drained;
        }
        if (done < 0)
            fmt::print("{} follows the campaign; open it in a browser\n", page.string());
        std::fflush(stdout);
        if (std::exchange(done, status.all.done) != status.all.done)
            report::write_live_report(file, page, status, every);
        std::this_thread::sleep_for(std::chrono::duration<double>(every));
    }
}

} // namespace

void add_report(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string file, output;
        bool follows = false;
        double every = 10; //!< [s]
        PageWishes wishes;
    };
    auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand("report", "write one HTML page with tables and plots");
    command->add_option("FILE.h5", options->file, "campaign file; may be running")->required();
    command->add_option("-o,--output", options->output, "page to write; default FILE.html");
    auto* follow_flag =
        command->add_flag("--follow", options->follows,
                          "write it again as runs end, while anybody works on the campaign; the "
                          "page loads itself again");
    command->add_option("--every", options->every, "time between two looks [s]; default 10")
        ->check(above_zero())
        ->needs(follow_flag);
    command
        ->add_option(
            "--picture-runs", options->wishes.pictures,
            "pictures of these runs too, by number: 3,7; what the file does not keep is simulated again")
        ->delimiter(',')
        ->excludes(follow_flag);
    auto* film_flag =
        command
            ->add_flag("--film", options->wishes.film,
                       "an animation of the runs of --picture-runs, else of the best run of each "
                       "experiment: simulates them again")
            ->excludes(follow_flag);
    command->add_option("--film-frames", options->wishes.frames, "moments of an animation; default 24")
        ->check(CLI::Range(2, 200))
        ->needs(film_flag);
    command->callback([options, &action] {
        action = [options] {
            std::filesystem::path page = options->output;
            if (page.empty())
                page = std::filesystem::path(options->file).replace_extension(".html");
            if (options->follows)
                return follow(options->file, page, options->every);
            report::write_report(options->file, page, page_extras(options->file, options->wishes));
            fmt::print("wrote {}\n", page.string());
            return static_cast<int>(success);
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
