// A rig that another program simulates.
#include "demens/base/error.hpp"
#include "src/rig/command/child.hpp"
#include "src/rig/command/exchange.hpp"
#include "src/rig/option_specs.hpp"
#include "src/rig/rigs.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

namespace demens::rig {
namespace {

namespace fs = std::filesystem;
using namespace command;

std::vector<OptionSpec> options()
{
    auto const command = required_word("command", "command of the shell, run in a folder of the run's own");
    auto results =
        word("results", "file that it writes there: a JSON object, or a CSV table whose last row counts");
    results.default_value = std::string("results.json");
    return {command,
            results,
            word("series",
                 "CSV file of curves over its first column, the time, that it writes there; empty: none"),
            word("keep_in", "folder in which the folders of runs are kept; empty: they are removed"),
            number("time_limit_s", 86400, "it is ended after so long, and the run has timed out [s]", 1e-3),
            number("expected_s", 10, "how long a run takes about, for the order of runs [s]", 1e-3)};
}

TableSpec parameter_table()
{
    return {.key = "parameter",
            .doc = "a number that the command is given; a factor by its path",
            .options = {required_word("name", "its name"), required(number("value", 0, "its value"))}};
}

TableSpec file_table()
{
    return {.key = "file",
            .doc = "a file that is put into the folder; its content is stored with the campaign",
            .options = {required_word("as", "its name there"), file("file", "where it is"),
                        flag("fill", false,
                             "replace ${NAME} in it by the parameter of that name, ${seed} by the seed")}};
}

TableSpec response_table()
{
    return {.key = "response",
            .doc = "a number that the command writes",
            .options = {required_word("name", "its name in the results"),
                        word("units", "its unit; empty: none")}};
}

std::vector<ResponseInfo> asked_responses(OptionValues const& experiment)
{
    std::vector<ResponseInfo> infos;
    for (auto const& o : experiment.tables("response"))
        infos.push_back(
            {o.text("name"), o.text("units").empty() ? "1" : o.text("units"), "given by the command"});
    return infos;
}

Parameters parameters_of(OptionValues const& experiment)
{
    Parameters parameters;
    for (auto const& o : experiment.tables("parameter"))
        parameters[o.text("name")] = o.number("value");
    return parameters;
}

//! What goes into the folder, by name there.
std::map<std::string, std::string> files_of(RunInput const& input)
{
    auto const parameters = parameters_of(input.experiment);
    std::map<std::string, std::string> files = {{"parameters.json", parameters_json(parameters, input.seed)}};
    for (auto const& o : input.experiment.tables("file")) {
        auto const& content = *input.files.at(o.text("file"));
        auto const name = o.text("as");
        if (name.find('/') != std::string::npos)
            throw InputError(
                fmt::format("file: as = \"{}\" must be the name of a file, without a folder", name));
        files[name] = o.flag("fill") ? filled(content, parameters, input.seed) : content;
    }
    return files;
}

void check(RunInput const& input)
{
    if (input.experiment.tables("response").empty())
        throw InputError("nothing is measured; give at least one table [[experiment.response]]");
    files_of(input);
}

//! A folder of a run, removed with all that is in it unless it is kept.
class RunFolder
{
  public:
    explicit RunFolder(std::string const& keep_in) : kept_(!keep_in.empty())
    {
        fs::path const above = kept_ ? fs::absolute(keep_in) : fs::temp_directory_path();
        std::error_code error;
        fs::create_directories(above, error);
        auto name = (above / "demens-run-XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw InputError(fmt::format("no folder for a run can be made in {}", above.string()));
        path_ = name;
    }
    RunFolder(RunFolder const&) = delete;
    RunFolder& operator=(RunFolder const&) = delete;
    ~RunFolder()
    {
        std::error_code ignored;
        if (!kept_)
            fs::remove_all(path_, ignored);
    }
    fs::path const& path() const { return path_; }

  private:
    bool kept_;
    fs::path path_;
};

//! Why a run that has ended is none; empty: it may be one.
std::string fault_of(ChildEnd const& end, fs::path const& folder)
{
    constexpr std::size_t longest = 200;
    auto const said = last_line(folder / "output.txt", longest);
    auto const last = said.empty() ? std::string{} : fmt::format("; its last line: {}", said);
    if (end.signal != 0)
        return fmt::format("the command was ended by signal {}{}", end.signal, last);
    return end.exit_code != 0 ? fmt::format("the command has the exit code {}{}", end.exit_code, last)
                              : std::string{};
}

RunResult simulate(RunInput const& input, RunHooks const& hooks)
{
    auto const& o = input.experiment;
    std::vector<std::string> names;
    for (auto const& response : o.tables("response"))
        names.push_back(response.text("name"));
    RunResult result{.status = RunStatus::error, .responses = std::vector(names.size(), not_given)};
    if (hooks.team && hooks.team->size() > 1) {
        result.reason = "a command is run by one rank: set run.ranks_per_group = 1";
        return result;
    }
    try {
        RunFolder const folder(o.text("keep_in"));
        for (auto const& [name, content] : files_of(input))
            std::ofstream(folder.path() / name, std::ios::binary) << content;
        double const limit = hooks.wall_time_limit > 0
                                 ? std::min(hooks.wall_time_limit, o.number("time_limit_s"))
                                 : o.number("time_limit_s");
        auto const end = run_child(o.text("command"), folder.path(), limit, hooks.should_stop);
        if (end.timed_out) {
            result.status = RunStatus::timed_out;
            result.reason = fmt::format("the command took more than {:g} s", limit);
            return result;
        }
        result.reason = fault_of(end, folder.path());
        if (!result.reason.empty())
            return result;
        result.responses = read_results(folder.path() / o.text("results"), names);
        if (!o.text("series").empty())
            result.series = read_series(folder.path() / o.text("series"));
        for (std::size_t k = 0; k < names.size(); ++k)
            if (!std::isfinite(result.responses[k])) {
                result.reason = fmt::format("{} has no number \"{}\"", o.text("results"), names[k]);
                return result;
            }
        result.status = RunStatus::finished;
        if (result.series.rows() > 0)
            result.simulated_time = result.series.columns.front().back();
    } catch (InputError const& error) {
        result.reason = error.what();
    }
    return result;
}

} // namespace

RigInfo command_rig()
{
    constexpr double steps_per_second = 1e7; // of particles, by which other rigs count their cost
    RigInfo rig{
        .name = "command",
        .doc = "any program: parameters in files of a folder, numbers and curves from files that it writes",
        .options = options(),
        .tables = {parameter_table(), file_table(), response_table()},
        .asked_responses = asked_responses};
    rig.check = check;
    rig.predict_cost = [](RunInput const& input) {
        return steps_per_second * input.experiment.number("expected_s");
    };
    rig.run = simulate;
    return rig;
}

} // namespace demens::rig
