#include "ensemble/reuse/result_table.hpp"

#include "demens/base/text/csv.hpp"
#include "ensemble/input/design_table.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/toml_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>

namespace demens::ensemble {
namespace {

//! \throws InputError for a word that is none
rig::RunStatus status_of(std::string const& word, std::string const& where)
{
    std::vector<std::string> names;
    for (int status = 0; status < rig::run_statuses; ++status) {
        names.emplace_back(rig::name_of(static_cast<rig::RunStatus>(status)));
        if (names.back() == word)
            return static_cast<rig::RunStatus>(status);
    }
    throw InputError(
        fmt::format("{}: column `status`: \"{}\" is none; {}", where, word, input::suggestion(word, names)));
}

class ResultTable
{
  public:
    ResultTable(CampaignInput const& input, int experiment, std::string const& csv, std::string const& origin)
        : input_(input), experiment_(experiment), table_(text::CsvTable::from_text(csv, origin)),
          factors_(input::factor_columns(table_, input.factors)), status_(table_.find("status"))
    {
        for (auto const& response : input.experiments.at(static_cast<std::size_t>(experiment)).responses)
            responses_.push_back(table_.column(response.name));
    }

    std::vector<RunRecord> runs() const
    {
        std::vector<RunRecord> runs;
        for (int row = 0; row < table_.rows(); ++row)
            if (auto run = run_of(row))
                runs.push_back(std::move(*run));
        return runs;
    }

  private:
    std::optional<RunRecord> run_of(int row) const
    {
        RunRecord run;
        run.experiment = experiment_;
        for (int const column : responses_)
            run.responses.push_back(table_.number(row, column));
        auto const given = std::count_if(run.responses.begin(), run.responses.end(),
                                         [](double value) { return std::isfinite(value); });
        if (status_ && !table_.is_missing(row, *status_))
            run.status = status_of(table_.cell(row, *status_), table_.where(row));
        else
            run.status = given > 0 ? rig::RunStatus::finished : rig::RunStatus::not_run;
        if (run.status == rig::RunStatus::not_run && given > 0)
            run.status = rig::RunStatus::finished; // a row of the design, filled in
        if (run.status == rig::RunStatus::not_run)
            return std::nullopt;
        if (run.status == rig::RunStatus::finished)
            require_all(run, row);
        else
            run.reason = "as its table says";
        run.factors = factors_of(row);
        return run;
    }

    void require_all(RunRecord const& run, int row) const
    {
        for (std::size_t k = 0; k < responses_.size(); ++k)
            if (!std::isfinite(run.responses[k]))
                throw InputError(fmt::format("{}: column `{}` has no value; a run that has finished has one "
                                             "for each response, and one "
                                             "that failed has another `status`",
                                             table_.where(row),
                                             table_.names()[static_cast<std::size_t>(responses_[k])]));
    }

    std::vector<double> factors_of(int row) const
    {
        std::vector<double> point;
        for (int const column : factors_)
            point.push_back(table_.number(row, column));
        if (auto const wrong = input::wrong_with_point(point, input_); !wrong.empty())
            throw InputError(fmt::format("{}: the row{}", table_.where(row), wrong));
        return point;
    }

    CampaignInput const& input_;
    int experiment_;
    text::CsvTable table_;
    std::vector<int> factors_, responses_; //!< columns
    std::optional<int> status_;            //!< column
};

//! \throws InputError where there is no such experiment, or more than one could be meant
int experiment_of(CampaignInput const& input, ResultFile const& table)
{
    std::vector<std::string> names;
    for (auto const& experiment : input.experiments)
        names.push_back(experiment.name);
    auto const found = std::find(names.begin(), names.end(), table.experiment);
    if (found != names.end())
        return static_cast<int>(found - names.begin());
    if (!table.experiment.empty())
        throw InputError(fmt::format("--results {}={}: there is no such experiment; {}", table.experiment,
                                     table.file.string(), input::suggestion(table.experiment, names)));
    if (names.size() > 1)
        throw InputError(fmt::format("--results {0}: of which experiment? Give --results EXPERIMENT={0}",
                                     table.file.string()));
    return 0;
}

} // namespace

std::vector<RunRecord> runs_of_table(CampaignInput const& input, int experiment, std::string const& csv,
                                     std::string const& origin)
{
    return ResultTable(input, experiment, csv, origin).runs();
}

Taken taken_from_tables(CampaignInput const& input, std::vector<ResultFile> const& files)
{
    Taken taken;
    std::vector<RunRecord> all;
    std::set<int> experiments;
    std::string source;
    for (auto const& table : files) {
        int const experiment = experiment_of(input, table);
        auto const name = table.file.string();
        auto const runs =
            runs_of_table(input, experiment, input::read_text(table.file, "a table of results"), name);
        if (runs.empty())
            throw InputError(fmt::format("{}: no row has results", name));
        taken.lines.push_back(fmt::format("{} runs of {} are taken from {}", runs.size(),
                                          input.experiments[static_cast<std::size_t>(experiment)].name,
                                          name));
        experiments.insert(experiment);
        all.insert(all.end(), runs.begin(), runs.end());
        source += (source.empty() ? "" : "; ") + source_text(table.file, table.file);
    }
    for (int e = 0; e < static_cast<int>(input.experiments.size()); ++e)
        if (auto const& experiment = input.experiments[static_cast<std::size_t>(e)];
            experiment.role == ExperimentRole::calibrate && !experiments.contains(e))
            throw InputError(fmt::format("--results: there is no table of the experiment {0}; add --results "
                                         "{0}=FILE.csv",
                                         experiment.name));
    taken.waves = taken_waves(input, all, source);
    return taken;
}

} // namespace demens::ensemble
