// Cases whose cause is known: drawn and sealed, diagnosed without it, scored.
#include "app/rehearse.hpp"

#include "app/command.hpp"
#include "app/mpi_scope.hpp"
#include "app/new_campaign.hpp"
#include "demens/base/error.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "gap/campaign/diagnose.hpp"
#include "gap/campaign/report.hpp"
#include "gap/rehearsal/measure.hpp"
#include "gap/rehearsal/scores.hpp"
#include "tao_calib/calibrate.hpp"
#include "tao_calib/solver/petsc_session.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace demens::cli {
namespace {

namespace fs = std::filesystem;
using ensemble::on_root;
using nlohmann::json;

constexpr int most_tries = 10; // at a case that can be measured

void write(fs::path const& file, std::string const& text)
{
    std::ofstream out(file);
    out << text;
    out.close();
    if (!out)
        throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

json read_json(fs::path const& file)
{
    std::ifstream in(file);
    if (!in)
        throw InputError(fmt::format("{}: cannot be read", file.string()));
    try {
        return json::parse(in);
    } catch (json::exception const& error) {
        throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

//! What draws cases into a folder.
struct Drawing
{
    ensemble::CampaignInput input;
    gap::RehearsedEffects effects;
    fs::path folder;
    int cases, repeats;
    fs::file_time_type written; //!< what all files of a case say: how long one took would tell of its cause
    std::vector<gap::CaseKind> kinds = {}; //!< of the cases so far; on rank 0
};

//! The truth of a case, drawn and sealed where that was not done before. On rank 0.
gap::CaseTruth sealed_truth(Drawing const& drawing, std::string const& name)
{
    auto const& folder = drawing.folder;
    auto const file = folder / "truth" / (name + ".json");
    if (fs::exists(file))
        return gap::truth_of(read_json(file).at("truth"));
    auto const kind = gap::draw_kind(drawing.effects, drawing.kinds, drawing.cases, gap::entropy());
    auto const truth = gap::draw_case(drawing.input, drawing.effects, kind, name, gap::entropy());
    auto const salt = gap::new_salt();
    write(file, json{{"salt", salt}, {"truth", gap::json_of(truth)}}.dump(1) + "\n");
    auto seals = fs::exists(folder / "seals.json") ? read_json(folder / "seals.json") : json::object();
    seals[name] = gap::seal_of(salt, truth);
    write(folder / "seals.json", seals.dump(1) + "\n");
    fmt::print("{} {}\n", name, seals[name].get<std::string>());
    return truth;
}

//! A case that cannot be measured was not drawn.
void take_back(fs::path const& folder, std::string const& name)
{
    // The seal last: whoever is stopped here draws a new truth, never keeps one that has no seal.
    for (auto const* ending : {".json", ".h5", ".h5.lock", ".h5.parts"})
        fs::remove_all(folder / "truth" / (name + ending));
    auto seals = read_json(folder / "seals.json");
    seals.erase(name);
    write(folder / "seals.json", seals.dump(1) + "\n");
}

void write_case(Drawing const& drawing, std::string const& name, std::string const& text)
{
    auto const folder = drawing.folder / "cases" / name;
    fs::create_directories(folder);
    for (auto const& [file, content] : drawing.input.files()) {
        fs::create_directories((folder / file).parent_path());
        write(folder / file, *content);
    }
    write(folder / "campaign.toml", text);
    for (auto const& entry : fs::recursive_directory_iterator(folder))
        fs::last_write_time(entry.path(), drawing.written);
    fs::last_write_time(folder, drawing.written);
}

//! Draws a case and simulates what is measured, anew where that cannot be. False when asked to stop.
bool draw_case(Drawing& drawing, std::string const& name)
{
    for (int tries = 1;; ++tries) {
        gap::CaseTruth truth;
        std::vector<int> is_there(1);
        on_root(MPI_COMM_WORLD, [&] {
            truth = sealed_truth(drawing, name);
            drawing.kinds.push_back(truth.kind);
            is_there[0] = fs::exists(drawing.folder / "cases" / name / "campaign.toml");
        });
        ensemble::broadcast(MPI_COMM_WORLD, is_there);
        if (is_there[0] != 0)
            return true;
        auto const file = drawing.folder / "truth" / (name + ".h5");
        auto const measured = gap::measured_campaign(MPI_COMM_WORLD, drawing.input, drawing.effects, truth,
                                                     file, drawing.repeats);
        switch (measured.end) {
        case gap::MeasuredCase::End::stopped:
            return false;
        case gap::MeasuredCase::End::measured:
            on_root(MPI_COMM_WORLD, [&] { write_case(drawing, name, measured.text); });
            return true;
        case gap::MeasuredCase::End::unmeasurable:
            on_root(MPI_COMM_WORLD, [&] {
                if (tries == most_tries)
                    throw InputError(
                        fmt::format("{}: in {} draws no run of {} has finished; `demens status {}` says why",
                                    name, tries, measured.text, file.string()));
                fmt::print("{}: no run of {} has finished; drawn anew\n", name, measured.text);
                take_back(drawing.folder, name);
                drawing.kinds.pop_back();
            });
        }
    }
}

//! `NAME` or `NAME=AMPLITUDE`.
gap::OutsideEffect outside_effect(std::string const& text)
{
    auto const sign = text.find('=');
    if (sign == std::string::npos)
        return {text};
    double amplitude = 0;
    if (!CLI::detail::lexical_cast(text.substr(sign + 1), amplitude))
        throw InputError(fmt::format("--outside {}: `{}` is no amplitude", text, text.substr(sign + 1)));
    return {text.substr(0, sign), amplitude};
}

int draw(std::string const& toml, fs::path const& folder, int cases, int repeats,
         std::vector<std::string> const& outside)
{
    auto input = ensemble::CampaignInput::from_file(toml);
    if (!input.run.bank.empty()) // as every case sees it
        input.run.bank = fs::relative(fs::absolute(fs::path(toml).parent_path() / input.run.bank),
                                      fs::absolute(folder) / "cases" / "case")
                             .string();
    std::vector<gap::OutsideEffect> wanted;
    for (auto const& text : outside)
        wanted.push_back(outside_effect(text));
    auto effects = gap::rehearsed_effects(input, wanted);
    on_root(MPI_COMM_WORLD, [&] { fs::create_directories(folder / "truth"); });
    Drawing drawing{std::move(input), std::move(effects), folder, cases, repeats, fs::last_write_time(toml)};
    for (int k = 1; k <= cases; ++k)
        if (!draw_case(drawing, fmt::format("case{:02}", k)))
            return drained;
    return success;
}

std::vector<fs::path> case_folders(fs::path const& folder)
{
    std::vector<fs::path> folders;
    if (fs::is_directory(folder / "cases"))
        for (auto const& entry : fs::directory_iterator(folder / "cases"))
            if (fs::exists(entry.path() / "campaign.toml"))
                folders.push_back(entry.path());
    std::sort(folders.begin(), folders.end());
    if (folders.empty())
        throw InputError(
            fmt::format("{}: has no cases/NAME/campaign.toml; draw cases first", folder.string()));
    return folders;
}

//! Calibrates and diagnoses a case as any campaign; what a folder of cases holds is all that it sees.
bool diagnose_case(fs::path const& folder)
{
    auto const file = folder / "campaign.h5";
    on_root(MPI_COMM_WORLD, [&] { make_or_accept(folder / "campaign.toml", file); });
    ensemble::Session session(MPI_COMM_WORLD, file);
    auto const end = tao_calib::calibrate(session);
    if (end == tao_calib::CalibrationEnd::drained)
        return false;
    if (end == tao_calib::CalibrationEnd::finished && gap::diagnose(session) == ensemble::WaveEnd::drained)
        return false;
    on_root(MPI_COMM_WORLD, [&] {
        json answer = {{"failure", session.campaign().ended}};
        if (end == tao_calib::CalibrationEnd::finished)
            answer = gap::gap_document(session.campaign());
        write(folder / "answer.json", answer.dump(1) + "\n");
        fmt::print("{}: {}\n", folder.filename().string(),
                   answer.contains("which") ? answer["which"]["verdict"].get<std::string>()
                                            : "could not be calibrated");
    });
    return true;
}

int diagnose(fs::path const& folder)
{
    tao_calib::PetscSession const petsc; // of all cases
    for (auto const& one : case_folders(folder))
        if (!fs::exists(one / "answer.json") && !diagnose_case(one))
            return drained;
    return success;
}

int score(fs::path const& folder)
{
    std::vector<gap::AnsweredCase> cases;
    auto const seals = read_json(folder / "seals.json");
    int failed = 0, unanswered = 0;
    for (auto const& one : case_folders(folder)) {
        auto const name = one.filename().string();
        if (!fs::exists(one / "answer.json")) { // stays sealed
            ++unanswered;
            continue;
        }
        auto const sealed = read_json(folder / "truth" / (name + ".json"));
        auto const truth = gap::truth_of(sealed.at("truth"));
        if (gap::seal_of(sealed.at("salt"), truth) != seals.at(name).get<std::string>())
            throw InputError(fmt::format("{}: its truth is not the one that was sealed", name));
        auto document = read_json(one / "answer.json");
        if (!document.contains("which")) {
            ++failed;
            continue;
        }
        std::string acts;
        for (std::size_t k = 0; k < truth.effects.size(); ++k)
            acts += fmt::format("{}{} x {:g}", k ? ", " : "", truth.effects[k], truth.strengths[k]);
        gap::CaseAnswer answer(std::move(document));
        fmt::print("{:<8} {:<8} {:<44} {:<24} {:.2f}  {}\n", name, word_for(truth.kind), acts, answer.first(),
                   *std::max_element(answer.probabilities().begin(), answer.probabilities().end()),
                   answer.verdict());
        cases.push_back({truth, std::move(answer)});
    }
    if (cases.empty() && failed == 0)
        throw InputError(fmt::format("{}: no case has an answer yet; diagnose them first", folder.string()));
    fmt::print("\n{}\n{}", gap::confusion_text(cases), gap::score_text(cases));
    if (failed > 0)
        fmt::print("{} cases could not be calibrated and are not counted\n", failed);
    if (unanswered > 0)
        fmt::print("{} cases have no answer yet; they stay sealed and are not counted\n", unanswered);
    return success;
}

} // namespace

void add_rehearse(CLI::App& gap, Action& action)
{
    struct Options
    {
        std::string toml, folder;
        std::vector<std::string> outside;
        int cases = 12, repeats = 3;
    };
    auto options = std::make_shared<Options>();
    auto* command = gap.add_subcommand(
        "rehearse",
        "cases whose cause is known, on one's own rigs: draw and seal, diagnose without it, score");
    command->require_subcommand(1);
    auto* drawn = command->add_subcommand(
        "draw", "draw effects, strengths and factors, seal them, simulate what is measured; under mpirun");
    drawn->add_option("FILE.toml", options->toml, "campaign with [gap]; its measured values are replaced")
        ->required();
    drawn->add_option("-o,--output", options->folder, "folder for the cases; goes on with it")->required();
    drawn->add_option("--cases", options->cases, "how many")->check(CLI::Range(1, 999));
    drawn->add_option("--repeats", options->repeats, "measurements of each experiment")
        ->check(CLI::Range(1, 1000));
    drawn
        ->add_option(
            "--outside", options->outside,
            "what is drawn that [gap] effects does not list, with commas: NAME or NAME=AMPLITUDE, the "
            "typical one; default all that the rigs allow")
        ->delimiter(',');
    drawn->callback([options, &action] {
        action = [options] {
            return on_all_ranks([&] {
                return draw(options->toml, options->folder, options->cases, options->repeats,
                            options->outside);
            });
        };
    });
    auto* diagnosed = command->add_subcommand("diagnose", "diagnose the cases of a folder; under mpirun");
    diagnosed->add_option("FOLDER", options->folder, "of cases")->required();
    diagnosed->callback([options, &action] {
        action = [options] { return on_all_ranks([&] { return diagnose(options->folder); }); };
    });
    auto* scored = command->add_subcommand("score", "open the seals and score the answers");
    scored->add_option("FOLDER", options->folder, "of cases with their truths")->required();
    scored->callback([options, &action] { action = [options] { return score(options->folder); }; });
}

} // namespace demens::cli
