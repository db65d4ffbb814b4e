#include "ensemble/file/campaign_file.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/storage/durable.hpp"
#include "ensemble/version.hpp"

#include <fmt/format.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

char constexpr format_name[] = "demens campaign";

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

} // namespace

void write_header(hid_t file, CampaignInput const& input)
{
    hdf5::set_attribute(file, "/", "format", format_name);
    hdf5::set_attribute(file, "/", "format_version", static_cast<std::int64_t>(format_version));
    hdf5::set_attribute(file, "/", "program_version", program_version);
    hdf5::set_attribute(file, "/", "git_commit", git_commit);
    hdf5::set_attribute(file, "/", "name", input.name);
    hdf5::set_attribute(file, "/", "ended", "");
    hdf5::write_text(file, "/input/toml", input.text());
    hdf5::write_text(file, "/input/resolved_toml", input.resolved_text());
    write_files(file, input.files());
    write_factors(file, input.factors);
    write_experiments(file, input.experiments);
    hdf5::make_group(file, "/waves");
    hdf5::make_group(file, "/series");
    hdf5::make_group(file, "/profiles");
    hdf5::make_group(file, "/snapshots");
}

hdf5::File open_campaign(fs::path const& path)
{
    auto const name = path.string();
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        throw InputError(
            fmt::format("{}: no such file; a campaign file is made by: demens new FILE.toml", name));
    if (!fs::is_regular_file(path, ignored) || H5Fis_hdf5(path.c_str()) <= 0)
        throw InputError(fmt::format(
            "{}: not a campaign file, since it is not HDF5; a campaign file is made by: demens new FILE.toml",
            name));
    hdf5::File file;
    try {
        file = hdf5::open_to_read(path);
    } catch (FileError const& error) {
        throw InputError(fmt::format("{}: damaged or not readable: {}", name, error.what()));
    }
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
    return file;
}

Campaign read_campaign(fs::path const& path, Rigs const& rigs)
{
    auto const file = open_campaign(path);
    try {
        Campaign campaign{CampaignInput::from_text(hdf5::read_texts(file, "/input/toml").at(0),
                                                   path.string() + ":/input/toml", rigs,
                                                   input::stored_files(read_files(file))),
                          {},
                          hdf5::text_attribute(file, "/", "ended")};
        for (auto const& wave : hdf5::children(file, "/waves"))
            campaign.waves.push_back(read_wave(file, std::stoi(wave), campaign.input));
        return campaign;
    } catch (FileError const& error) {
        throw InputError(fmt::format("{}: damaged: {}", path.string(), error.what()));
    }
}

FileUpdate::FileUpdate(fs::path file, std::uintmax_t more_bytes)
    : file_(std::move(file)), copy_(beside(file_, ".new"))
{
    try {
        std::error_code error;
        if (!fs::copy_file(file_, copy_, fs::copy_options::overwrite_existing, error))
            throw system_error("copy " + file_.string() + " to", copy_, error.value());
        reserve_space(copy_, fs::file_size(file_) + more_bytes);
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

void FileUpdate::commit()
{
    sync_file(copy_);
    rename_durably(copy_, file_);
    committed_ = true;
}

void update_file(fs::path const& path, std::uintmax_t more_bytes, std::function<void(hid_t)> const& change)
{
    FileUpdate update(path, more_bytes);
    auto file = hdf5::open_to_write(update.copy());
    change(file);
    hdf5::close(file);
    update.commit();
}

} // namespace demens::ensemble
