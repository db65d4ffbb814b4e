#include "report/report.hpp"

#include "demens/base/error.hpp"
#include "ensemble/session.hpp"
#include "report/document.hpp"
#include "report/page.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <unistd.h>

namespace demens::report {

namespace {

//! The whole file or none of it: written beside its place, then renamed.
void write_whole(std::filesystem::path const& file, std::string const& text)
{
    std::filesystem::path part = file;
    part += fmt::format(".{}.part", getpid());
    std::ofstream out(part, std::ios::binary);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    std::error_code rename_error;
    int const write_error = out ? 0 : errno;
    if (out)
        std::filesystem::rename(part, file, rename_error);
    if (write_error != 0 || !out || rename_error) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw InputError(
            fmt::format("{}: the report cannot be written ({}); give a place that exists, is writable "
                        "and has {:.1f} MB free",
                        file.string(), rename_error ? rename_error.message() : std::strerror(write_error),
                        static_cast<double>(text.size()) * 1e-6));
    }
}

} // namespace

void write_report(std::filesystem::path const& campaign_file, std::filesystem::path const& html)
{
    auto const campaign = ensemble::read_campaign_file(campaign_file);
    auto document =
        document_of(campaign, [&](int run) { return ensemble::read_run_details(campaign_file, run); });
    document["file"] = campaign_file.filename().string();
    write_whole(html, page_of(document, campaign.input.name));
}

} // namespace demens::report
