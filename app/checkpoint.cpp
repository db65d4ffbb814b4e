#include "app/checkpoint.hpp"

#include "demens/base/error.hpp"
#include "demens/dem/record_fields.hpp"
#include "ensemble/storage/durable.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace demens::cli {
namespace {

constexpr char prefix[] = "checkpoint/";

//! A stage's name as part of a file's: it may come from somebody else's campaign.
std::string plain(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '-'; }, '_');
    return text;
}

} // namespace

std::filesystem::path Checkpoints::write(std::filesystem::path const& folder, rig::RunState const& state,
                                         std::string const& stage) const
{
    auto record = state.record();
    dem::RecordWriter const writer(record, prefix);
    writer("run", run_);
    writer("input", input_);
    std::filesystem::create_directories(folder);
    auto file =
        folder / fmt::format("run-{}-stage-{}-{}.checkpoint", run_, state.progress.stage, plain(stage));
    ensemble::write_durably(file, record.to_bytes());
    return file;
}

rig::RunState Checkpoints::read(std::filesystem::path const& file) const
try {
    auto record = dem::StateRecord::from_bytes(ensemble::read_bytes(file));
    dem::RecordReader const reader(record, prefix);
    int run = 0;
    std::string input;
    reader("run", run);
    reader("input", input);
    if (run != run_)
        throw InputError(fmt::format("is of run {}; give --run {}", run, run));
    if (input != input_)
        throw InputError("is of another campaign, or was made before this one was extended");
    return rig::RunState::from_record(std::move(record));
} catch (InputError const& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
}

} // namespace demens::cli
