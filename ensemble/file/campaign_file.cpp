#include "ensemble/file/campaign_file.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/audit.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/storage/descriptor.hpp"
#include "ensemble/storage/durable.hpp"
#include "ensemble/version.hpp"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

char constexpr format_name[] = "demens campaign";
int constexpr first_version_with_check_sums = 2;

hdf5::Meaning plain(std::string doc)
{
    return {{}, {}, std::move(doc)};
}
hdf5::Meaning own_units(std::string doc)
{
    return {{"as in the name"}, {}, std::move(doc)};
}

template <class T>
void write_list(hid_t file, std::string const& path, std::vector<T> const& values,
                hdf5::Meaning const& meaning)
{
    hdf5::write<T>(file, path, {values.size()}, values, meaning);
}

void write_factors(hid_t file, std::vector<Factor> const& factors)
{
    std::vector<std::string> names, paths;
    std::vector<double> lower, upper;
    std::vector<int> log_scale;
    for (auto const& factor : factors) {
        names.push_back(factor.name);
        paths.push_back(factor.path);
        lower.push_back(factor.lower);
        upper.push_back(factor.upper);
        log_scale.push_back(factor.log_scale);
    }
    write_list(file, "/factors/name", names, plain("short name"));
    write_list(file, "/factors/path", paths, plain("scalar of the resolved input that is to be found"));
    write_list(file, "/factors/lower", lower, own_units("lower bound"));
    write_list(file, "/factors/upper", upper, own_units("upper bound"));
    write_list(file, "/factors/log_scale", log_scale, {{"1"}, {}, "1: searched on a logarithmic scale"});
}

//! Files that the input names, each as its bytes.
void write_files(hid_t file, rig::Files const& files)
{
    for (auto const& [name, content] : files) {
        auto const path =
            fmt::format("/input/files/{:04}",
                        hdf5::exists(file, "/input/files") ? hdf5::children(file, "/input/files").size() : 0);
        hdf5::write<std::uint8_t>(file, path, {content->size()}, {content->begin(), content->end()},
                                  {{"1"}, {}, "bytes of a file that the input names"});
        hdf5::set_attribute(file, path, "name", name);
    }
}

rig::Files read_files(hid_t file)
{
    rig::Files files;
    if (!hdf5::exists(file, "/input/files"))
        return files;
    for (auto const& child : hdf5::children(file, "/input/files")) {
        auto const path = "/input/files/" + child;
        auto const bytes = hdf5::read<std::uint8_t>(file, path);
        files.emplace(hdf5::text_attribute(file, path, "name"),
                      std::make_shared<std::string const>(bytes.begin(), bytes.end()));
    }
    return files;
}

std::string read_text(hid_t file, std::string const& path)
{
    auto const texts = hdf5::read_texts(file, path);
    hdf5::require_shape(path, {texts.size()}, {1});
    return texts.front();
}

std::string units_of(Experiment const& experiment, Target const& target)
{
    return experiment.responses.at(static_cast<std::size_t>(target.response_index)).units;
}

void write_experiments(hid_t file, std::vector<Experiment> const& experiments)
{
    std::vector<std::string> names, rigs, target_experiment, response, units;
    std::vector<int> replicates;
    std::vector<double> value, scale, sd, tolerance;
    for (auto const& experiment : experiments) {
        names.push_back(experiment.name);
        rigs.push_back(experiment.rig->name);
        replicates.push_back(experiment.replicates);
        for (auto const& target : experiment.targets) {
            target_experiment.push_back(experiment.name);
            response.push_back(target.response);
            units.push_back(units_of(experiment, target));
            value.push_back(target.value);
            scale.push_back(target.scale);
            sd.push_back(target.sd);
            tolerance.push_back(target.tolerance);
        }
    }
    write_list(file, "/experiments/name", names, plain("one rig under one set of conditions"));
    write_list(file, "/experiments/rig", rigs, plain("test apparatus"));
    write_list(file, "/experiments/replicates", replicates, {{"1"}, {}, "runs per design point"});
    auto const in_units = [&](std::string doc) { return hdf5::Meaning{{"see units"}, {}, std::move(doc)}; };
    write_list(file, "/targets/experiment", target_experiment, plain("name of the experiment"));
    write_list(file, "/targets/response", response, plain("name of the response"));
    write_list(file, "/targets/units", units, plain("units of value, scale, sd and tolerance"));
    write_list(file, "/targets/value", value, in_units("measured value"));
    write_list(file, "/targets/scale", scale, in_units("deviation that counts as one"));
    write_list(file, "/targets/sd", sd, in_units("standard deviation of the measurement; NaN: not given"));
    write_list(file, "/targets/tolerance", tolerance,
               in_units("deviation that is good enough; NaN: not given"));
}

void write_input(hid_t file, CampaignInput const& input)
{
    hdf5::set_attribute(file, "/", "name", input.name);
    hdf5::write_text(file, "/input/toml", input.text());
    hdf5::write_text(file, "/input/resolved_toml", input.resolved_text());
    write_files(file, input.files());
    write_factors(file, input.factors);
    write_experiments(file, input.experiments);
}

std::vector<Extension> read_extensions(hid_t file)
{
    std::vector<Extension> extensions;
    if (!hdf5::exists(file, "/extensions"))
        return extensions;
    for (auto const& child : hdf5::children(file, "/extensions")) {
        auto const path = "/extensions/" + child;
        extensions.push_back({static_cast<int>(hdf5::integer_attribute(file, path, "first_wave")),
                              static_cast<int>(hdf5::integer_attribute(file, path, "runs")),
                              hdf5::read_texts(file, path + "/changes"),
                              read_text(file, path + "/toml_before")});
    }
    return extensions;
}

//! An HDF5 file of this program begins with the signature. \throws FileError when it cannot be read
bool begins_like_hdf5(fs::path const& path)
{
    std::array<char, 8> constexpr signature = {'\211', 'H', 'D', 'F', '\r', '\n', '\032', '\n'};
    Descriptor const in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!in)
        throw InputError(system_error("read", path, errno).what());
    std::array<char, 8> begin = {};
    std::size_t size = 0;
    if (int const error = read_at(in.get(), std::as_writable_bytes(std::span(begin)), 0, size))
        throw system_error("read", path, error);
    return begin == signature;
}

//! \throws InputError
void require_known_format(hid_t file, std::string const& name)
{
    if (!hdf5::has_attribute(file, "/", "format_version") || !hdf5::has_attribute(file, "/", "format") ||
        hdf5::text_attribute(file, "/", "format") != format_name)
        throw InputError(
            fmt::format("{}: an HDF5 file but not a campaign, since its attribute `format` is not \"{}\"; "
                        "a campaign file is made by: demens new FILE.toml",
                        name, format_name));
    auto const version = hdf5::integer_attribute(file, "/", "format_version");
    if (version > format_version)
        throw InputError(
            fmt::format("{}: campaign format {} is newer than this program, which reads up to format {}; "
                        "use the demens that wrote it (version {}) or a later one",
                        name, version, format_version,
                        hdf5::has_attribute(file, "/", "program_version")
                            ? hdf5::text_attribute(file, "/", "program_version")
                            : "unknown"));
}

//! Looks at everything in a file of a known format. \throws FileError
void audit_campaign(hid_t file)
{
    auto const version = hdf5::integer_attribute(file, "/", "format_version");
    audit(file, version >= first_version_with_check_sums ? CheckSums::required : CheckSums::where_present);
}

//! Runs and design points are numbered from 0 on, waves one after the other; all that is stored relies on it.
//! \throws FileError
void require_numbers(Campaign const& campaign)
{
    int next_run = 0, points_before = 0;
    for (auto const& wave : campaign.waves) {
        int next_point = points_before;
        for (auto const& run : wave.runs) {
            auto const replicates =
                wave.replicates > 0
                    ? wave.replicates
                    : campaign.input.experiments.at(static_cast<std::size_t>(run.experiment)).replicates;
            if (run.run != next_run)
                throw FileError(fmt::format("{}/runs/run: {} stands where run {} should",
                                            wave_path(wave.number), run.run, next_run));
            if (run.point != next_point && (run.point != next_point - 1 || next_point == points_before))
                throw FileError(
                    fmt::format("{}/runs/point: run {} is of design point {}, which does not follow "
                                "those before it",
                                wave_path(wave.number), run.run, run.point));
            if (run.replicate < 0 || run.replicate >= replicates)
                throw FileError(fmt::format("{}/runs/replicate: run {} is replicate {} of {}",
                                            wave_path(wave.number), run.run, run.replicate, replicates));
            next_point = run.point + 1;
            ++next_run;
        }
        points_before = next_point;
    }
}

} // namespace

void write_header(hid_t file, CampaignInput const& input)
{
    hdf5::set_attribute(file, "/", "format", format_name);
    hdf5::set_attribute(file, "/", "format_version", static_cast<std::int64_t>(format_version));
    hdf5::set_attribute(file, "/", "program_version", program_version);
    hdf5::set_attribute(file, "/", "git_commit", git_commit);
    hdf5::set_attribute(file, "/", "ended", "");
    write_input(file, input);
    hdf5::make_group(file, "/waves");
    hdf5::make_group(file, "/series");
    hdf5::make_group(file, "/profiles");
    hdf5::make_group(file, "/snapshots");
}

void replace_input(hid_t file, CampaignInput const& input)
{
    for (char const* group : {"/input", "/factors", "/experiments", "/targets"})
        hdf5::check(H5Ldelete(file, group, H5P_DEFAULT), std::string("replace ") + group);
    write_input(file, input);
}

void write_extension(hid_t file, Extension const& extension)
{
    auto const path =
        fmt::format("/extensions/{:04}",
                    hdf5::exists(file, "/extensions") ? hdf5::children(file, "/extensions").size() : 0);
    write_list(file, path + "/changes", extension.changes, plain("what was changed"));
    hdf5::write_text(file, path + "/toml_before", extension.toml_before);
    hdf5::set_attribute(file, path, "first_wave", static_cast<std::int64_t>(extension.first_wave));
    hdf5::set_attribute(file, path, "runs", static_cast<std::int64_t>(extension.runs));
    hdf5::set_attribute(file, path, "program_version", program_version);
}

hdf5::File open_campaign(fs::path const& path)
{
    auto const name = path.string();
    std::error_code error;
    if (!fs::exists(path, error))
        throw InputError(
            error ? fmt::format("{}: cannot be read: {}", name, error.message())
                  : fmt::format("{}: no such file; a campaign file is made by: demens new FILE.toml", name));
    try {
        if (!fs::is_regular_file(path, error) || !begins_like_hdf5(path))
            throw InputError(fmt::format("{}: not a campaign file, since it is not HDF5; a campaign file is "
                                         "made by: demens new FILE.toml",
                                         name));
        auto file = hdf5::open_to_read(path);
        require_known_format(file, name);
        audit_campaign(file);
        return file;
    } catch (FileError const& failure) {
        throw InputError(fmt::format("{}: damaged or not readable: {}", name, failure.what()));
    }
}

Campaign read_campaign(fs::path const& path, Rigs const& rigs)
{
    return read_campaign(open_campaign(path), path, rigs);
}

Campaign read_campaign(hid_t file, fs::path const& path, Rigs const& rigs)
{
    try {
        Campaign campaign{
            CampaignInput::from_text(read_text(file, "/input/toml"), path.string() + ":/input/toml", rigs,
                                     input::stored_files(read_files(file)), input::OldWords::understood),
            {},
            hdf5::text_attribute(file, "/", "ended"),
            read_extensions(file)};
        if (!campaign.extensions.empty() && campaign.extensions.back().runs > 0)
            campaign.input.stop.runs = campaign.extensions.back().runs;
        auto const waves = hdf5::children(file, "/waves");
        for (int number = 0; number < static_cast<int>(waves.size()); ++number) {
            if (!hdf5::exists(file, wave_path(number)))
                throw FileError(
                    fmt::format("{} waves are there, but not {}", waves.size(), wave_path(number)));
            campaign.waves.push_back(read_wave(file, number, campaign.input));
        }
        require_numbers(campaign);
        if (campaign.first_counted_wave() < 0 ||
            campaign.first_counted_wave() > static_cast<int>(waves.size()))
            throw FileError(fmt::format("/extensions: there is no wave {}", campaign.first_counted_wave()));
        return campaign;
    } catch (FileError const& error) {
        throw InputError(fmt::format("{}: damaged: {}", path.string(), error.what()));
    }
}

FileUpdate::FileUpdate(fs::path const& file, std::uintmax_t more_bytes) : FileUpdate(file, file, more_bytes)
{
}

FileUpdate::FileUpdate(fs::path file, fs::path const& from, std::uintmax_t more_bytes)
    : file_(std::move(file)), copy_(beside(file_, ".new"))
{
    try {
        copy_to_new(from, copy_);
        reserve_space(copy_, fs::file_size(from) + more_bytes);
    } catch (...) {
        std::error_code ignored;
        fs::remove(copy_, ignored);
        throw;
    }
}

FileUpdate::~FileUpdate()
{
    std::error_code ignored;
    if (!committed_)
        fs::remove(copy_, ignored);
}

void FileUpdate::verify() const
{
    sync_file(copy_);
    forget_cached(copy_);
    audit_campaign(hdf5::open_to_read(copy_));
}

void FileUpdate::commit()
{
    rename_durably(copy_, file_);
    committed_ = true;
}

void update_file(fs::path const& path, std::uintmax_t more_bytes, std::function<void(hid_t)> const& change)
{
    FileUpdate update(path, more_bytes);
    auto file = hdf5::open_to_write(update.copy());
    change(file);
    file.close();
    update.verify();
    update.commit();
}

} // namespace demens::ensemble
