#include "ensemble/status/debug_bundle.hpp"

#include "demens/base/error.hpp"
#include "ensemble/file/hdf5.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/session.hpp"
#include "ensemble/status/status_json.hpp"
#include "ensemble/storage/durable.hpp"
#include "ensemble/version.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <mpi.h>
#include <sys/utsname.h>
#include <unistd.h>

namespace demens::ensemble {
namespace {

namespace fs = std::filesystem;

//! Variables of the environment that change how ranks, locks and devices behave.
auto constexpr telling =
    std::array{"OMPI_", "PMIX_", "SLURM_", "HDF5_", "DEMENS_", "CUDA_", "OMP_", "PETSC_"};

std::string mpi_version()
{
    std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
    int length = 0;
    MPI_Get_library_version(text.data(), &length);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string hdf5_version()
{
    unsigned major = 0, minor = 0, release = 0;
    H5get_libversion(&major, &minor, &release);
    return fmt::format("{}.{}.{}", major, minor, release);
}

std::string machine()
{
    utsname name{};
    if (::uname(&name) != 0)
        return "not known";
    return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

std::string environment()
{
    std::string text;
    for (char** entry = ::environ; entry && *entry; ++entry) {
        std::string const line = *entry;
        if (std::any_of(telling.begin(), telling.end(),
                        [&](char const* prefix) { return line.starts_with(prefix); }))
            text += line + "\n";
    }
    return text;
}

std::string about(std::vector<std::pair<std::string, std::string>> const& more)
{
    auto text =
        fmt::format("demens {} ({})\nMPI: {}\nHDF5: {}\nmachine: {}, {} processors\n", program_version,
                    git_commit, mpi_version(), hdf5_version(), machine(), ::sysconf(_SC_NPROCESSORS_ONLN));
    for (auto const& [name, value] : more)
        text += fmt::format("{}: {}\n", name, value);
    return text;
}

//! The campaign file and what lies beside it, with sizes [bytes].
std::string listing(fs::path const& file)
{
    std::string text;
    std::error_code error;
    auto const line = [&](fs::path const& path) {
        auto const size = fs::file_size(path, error);
        text += fmt::format("{:>14} {}\n", error ? std::string("-") : fmt::format("{}", size), path.string());
    };
    line(file);
    for (char const* ending : {".lock", ".new"})
        if (auto const path = beside(file, ending); fs::exists(path, error))
            line(path);
    std::vector<fs::path> parts;
    for (auto const& entry : fs::directory_iterator(Parts(file).folder(), error))
        parts.push_back(entry.path());
    std::sort(parts.begin(), parts.end());
    for (auto const& path : parts)
        line(path);
    auto const space = fs::space(file.has_parent_path() ? file.parent_path() : ".", error);
    return text + (error ? "" : fmt::format("{} bytes are free there\n", space.available));
}

std::string failed_runs(Campaign const& campaign)
{
    std::string text;
    for (auto const& run : campaign.all_runs())
        if (run.status != rig::RunStatus::finished && run.status != rig::RunStatus::not_run) {
            text += fmt::format(
                "run {} wave {} point {} {} replicate {} seed {} after {:.3g} s: {}: {}\n    factors",
                run.run, run.wave, run.point,
                campaign.input.experiments[static_cast<std::size_t>(run.experiment)].name, run.replicate,
                run.seed, run.wall_time, rig::name_of(run.status), run.reason);
            for (double const value : run.factors)
                text += fmt::format(" {:.17g}", value);
            text += "\n";
        }
    return text;
}

} // namespace

std::vector<fs::path> write_debug_bundle(fs::path const& file, fs::path const& folder,
                                         std::vector<std::pair<std::string, std::string>> const& more)
{
    if (!fs::exists(file))
        throw InputError(fmt::format("{}: there is no such file", file.string()));
    if (fs::exists(folder))
        throw InputError(
            fmt::format("{}: exists already; remove it first, or give another folder (-o)", folder.string()));
    std::error_code error;
    if (!fs::create_directories(folder, error))
        throw system_error("create the folder", folder, error.value());
    std::vector<fs::path> written;
    auto const write = [&](std::string const& name, std::function<std::string()> const& content) {
        std::string text;
        try {
            text = content();
        } catch (std::exception const& problem) {
            text = fmt::format("cannot be told: {}\n", problem.what());
        }
        std::ofstream out(folder / name, std::ios::binary);
        if (!(out << text).flush())
            throw system_error("write", folder / name, errno);
        written.push_back(folder / name);
    };
    write("about.txt", [&] { return about(more); });
    write("environment.txt", environment);
    write("files.txt", [&] { return listing(file); });
    write("status.json", [&] { return status_json(read_status(file)) + "\n"; });
    write("input.toml", [&] { return read_campaign_file(file).input.text(); });
    write("failed_runs.txt", [&] { return failed_runs(read_campaign_file(file)); });
    for (auto const& entry : fs::directory_iterator(Parts(file).folder(), error))
        if (auto const name = entry.path().filename().string(); name.starts_with("journal-"))
            write(name + ".txt", [&] {
                auto const bytes = read_bytes(entry.path());
                return std::string(reinterpret_cast<char const*>(bytes.data()), bytes.size());
            });
    return written;
}

} // namespace demens::ensemble
