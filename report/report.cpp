#include "report/report.hpp"

#include "demens/base/error.hpp"
#include "ensemble/campaign_reader.hpp"
#include "report/document.hpp"
#include "report/page.hpp"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
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

nlohmann::json read_document(std::filesystem::path const& campaign_file, Extras const& extras = {})
{
    ensemble::CampaignReader const reader(campaign_file);
    auto document = document_of(
        reader.campaign(), [&](int run) { return reader.details_of(run); }, extras);
    document["file"] = campaign_file.filename().string();
    return document;
}

void write_page(nlohmann::json const& document, std::filesystem::path const& html)
{
    write_whole(html, page_of(document, document["name"].get<std::string>()));
}

} // namespace

void write_report(std::filesystem::path const& campaign_file, std::filesystem::path const& html,
                  Extras const& extras)
{
    write_page(read_document(campaign_file, extras), html);
}

void write_live_report(std::filesystem::path const& campaign_file, std::filesystem::path const& html,
                       ensemble::CampaignStatus const& status, double reload_every)
{
    auto document = read_document(campaign_file);
    document["live"] = {
        {"reload_every", reload_every},
        {"done", status.all.done},
        {"planned", status.all.planned},
        {"running", status.all.running},
        {"failed", status.all.failed},
        {"time_left", status.time_left ? nlohmann::json(status.time_left->seconds) : nullptr}};
    write_page(document, html);
}

} // namespace demens::report
