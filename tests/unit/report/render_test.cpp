//! The page in a real browser: no script error, every plot has marks. CHROMIUM names the program.

#include "report/document.hpp"
#include "report/page.hpp"
#include "tests/unit/report/sample_campaign.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <unistd.h>

namespace demens::report {

namespace {

//! A folder that goes with the object.
class TemporaryFolder
{
  public:
    TemporaryFolder()
    {
        std::string name = std::filesystem::temp_directory_path() / "demens-report-XXXXXX";
        path_ = mkdtemp(name.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path_); }
    std::filesystem::path const& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

//! The document object model of a campaign's page after its scripts ran.
std::string rendered(ensemble::Campaign const& campaign, DetailsOf const& details = test::sample_details,
                     Extras const& extras = {})
{
    TemporaryFolder const folder;
    auto const page = folder.path() / "page.html", result = folder.path() / "dom.html";
    std::ofstream(page) << page_of(document_of(campaign, details, extras), campaign.input.name);
    std::string const command =
        std::string("timeout 120 ") + CHROMIUM +
        " --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --disable-quic --no-first-run"
        " --disable-background-networking --disable-component-update --disable-sync --user-data-dir=" +
        (folder.path() / "profile").string() + " --virtual-time-budget=20000 --dump-dom file://" +
        page.string() + " > " + result.string() + " 2> /dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::stringstream text;
    text << std::ifstream(result).rdbuf();
    return text.str();
}

std::string body_tag(std::string const& page)
{
    std::smatch match;
    return std::regex_search(page, match, std::regex("<body[^>]*>")) ? match.str() : "";
}

//! Number of marks of each plot and picture.
std::map<std::string, int> marks_of(std::string const& page)
{
    std::map<std::string, int> marks;
    std::regex const container(R"re(data-plot="([^"]*)"([^>]*)>)re"), count(R"re(data-marks="(\d+)")re");
    for (std::sregex_iterator plot(page.begin(), page.end(), container), end; plot != end; ++plot) {
        std::string const attributes = (*plot)[2];
        std::smatch match;
        marks[(*plot)[1]] = std::regex_search(attributes, match, count) ? std::stoi(match[1]) : 0;
    }
    return marks;
}

void expect_no_error(std::string const& page)
{
    EXPECT_NE(body_tag(page).find("data-errors=\"0\""), std::string::npos) << body_tag(page);
    EXPECT_NE(body_tag(page).find("data-ready=\"yes\""), std::string::npos) << body_tag(page);
}

int count_of(std::string const& page, std::string const& piece)
{
    int count = 0;
    for (auto at = page.find(piece); at != std::string::npos; at = page.find(piece, at + 1))
        ++count;
    return count;
}

} // namespace

TEST(Render, finished_campaign)
{
    auto const page = rendered(test::sample_campaign());
    expect_no_error(page);
    auto const marks = marks_of(page);
    for (auto const& [plot, count] : marks)
        EXPECT_GT(count, 0) << plot;

    // 3 tolerance bands and 3 errors bars, 1 zero line, 6 single values (4 runs, 2 of them with two targets),
    // 3 diamonds, 3 means.
    EXPECT_EQ(marks.at("deviations"), 3 + 3 + 1 + 6 + 3 + 3);
    // 1 wave border, the stop line and its text, 5 points that did not fail, the line.
    EXPECT_EQ(marks.at("convergence"), 1 + 5 + 1);
    EXPECT_EQ(marks.at("intervals"), 6 * 3);
    EXPECT_EQ(marks.at("correlations"), 2 * 6);
    // Band, target, area, line, and the 12 runs of an experiment; one of the first experiment failed.
    EXPECT_EQ(marks.at("response-0-0-static_friction"), 4 + 11);
    EXPECT_EQ(marks.at("response-1-0-cohesion"), 4 + 12);
    EXPECT_EQ(marks.at("response-0-2-cohesion"), 11); // without a target
    EXPECT_EQ(marks.at("series-0-upper_mass_kg"), 1);
    EXPECT_EQ(marks.at("profile-0-heap"), 1);
    EXPECT_EQ(marks.at("timing"), 24 + 2);
    EXPECT_EQ(marks.at("picture-1-final"),
              600 + 3 +
                  2); // particles, two sides and the floor, two lines of a curved wall; the pane is not drawn
    // Four of the fit, two experiments with three responses against three factors, series,
    // profiles, timing, pictures; pairs, importance; the last pictures to be turned, and how a run failed.
    EXPECT_EQ(marks.size(), 4u + 2u * 3u * 3u + 2u + 2u + 1u + 4u + 3u + 1u + 2u + 1u);
    EXPECT_EQ(count_of(page, "<tr class=\"failed\""), 1);
    EXPECT_EQ(count_of(page, "<tr class=\"best\""), 4);
    EXPECT_NE(page.find("no better point in 4 waves"), std::string::npos);
    for (char const* finding :
         {"in 2 separate regions", "trade off (correlation", "measuring slow: porosity",
          "inactive, kept at 30", "by 0.4.", "radial basis functions, error", "fitted to 5 of 9 locations"})
        EXPECT_NE(page.find(finding), std::string::npos) << finding;
}

TEST(Render, says_in_words_what_no_run_supports)
{
    auto campaign = test::sample_campaign();
    for (auto& array : campaign.waves.back().analysis) {
        if (array.path == "optimum/factor_verdict")
            array.data = {5, 5, 5};
        if (array.path == "optimum/estimate")
            array.data.assign(3, std::numeric_limits<double>::quiet_NaN());
    }
    auto const page = rendered(campaign);
    expect_no_error(page);
    EXPECT_EQ(count_of(page, "not determined: extrapolated to where runs fail</td>"),
              6); // at the top and in the table
    EXPECT_NE(page.find("Whether the targets can be met is not known"), std::string::npos);
    EXPECT_EQ(marks_of(page).count("intervals"), 0u);
    EXPECT_EQ(page.find("can be met together"), std::string::npos);
}

TEST(Render, campaign_under_way)
{
    auto const page = rendered(test::campaign_under_way());
    expect_no_error(page);
    auto const marks = marks_of(page);
    for (auto const& [plot, count] : marks)
        EXPECT_GT(count, 0) << plot;
    EXPECT_EQ(marks.count("deviations"), 0u);
    EXPECT_EQ(marks.at("timing"), 5 + 1);
    // Band, target and the three runs of the first experiment that finished.
    EXPECT_EQ(marks.at("response-0-0-static_friction"), 2 + 3);
    EXPECT_EQ(count_of(page, "<tr class=\"waiting\""), 11);
}

TEST(Render, plots_of_many_runs_are_thinned_and_say_so)
{
    constexpr int drawn = 2000, replicates = 700, of_experiment = 4 * replicates;
    auto const page = rendered(test::campaign_of_many_runs(replicates));
    expect_no_error(page);
    auto const marks = marks_of(page);
    EXPECT_EQ(marks.at("timing"), drawn + 1);
    EXPECT_EQ(marks.at("response-0-0-static_friction"), 2 + drawn); // band and target besides
    EXPECT_EQ(marks.at("response-1-0-cohesion"), 2 + drawn);
    auto const note = [&](int runs) { return "2000 of " + std::to_string(runs) + " runs, evenly taken"; };
    EXPECT_EQ(count_of(page, note(of_experiment)), 2 * 3); // of three responses in two experiments
    EXPECT_EQ(count_of(page, note(2 * of_experiment)), 1); // of the timing
}

TEST(Render, measured_curves_and_photographs_stand_beside_the_run)
{
    auto campaign = test::campaign_under_way();
    auto& experiment = campaign.input.experiments[0];
    ensemble::CurveTarget curve{.name = "upper_mass_kg", .curve = {{0, 0.5, 1}, {10, 8, 5}}, .sd = 0.1};
    curve.windows = {{.name = "early", .from = 0, .to = 0.5, .first = 0, .end = 1},
                     {.name = "late", .from = 0.5, .to = 1, .first = 1, .end = 3}};
    auto const add_targets = [&](std::vector<rig::ResponseInfo> const& responses, std::size_t skipped,
                                 ensemble::TargetSource source) {
        for (std::size_t k = 0; k < responses.size(); ++k) {
            if (k >= skipped)
                experiment.targets.push_back(
                    {responses[k].name, static_cast<int>(experiment.responses.size()), 1, 1, 0.1, 0.1});
            experiment.responses.push_back(responses[k]);
        }
        experiment.targets.back().comes_of = source;
    };
    for (auto const& response : responses_of(curve, "s", "kg"))
        add_targets({response}, 0, ensemble::TargetSource::curve);
    experiment.curves = {curve};
    // Below the axis is bed in the photograph, below 1/4 of the radius above it in the simulation.
    auto const frame = observe::square_frame(0.1, 40);
    auto const bed_below = [&](double height) {
        observe::GreyImage image(40, 40);
        for (int row = 0; row < 40; ++row)
            for (int column = 0; column < 40; ++column)
                image.at(column, row) = frame.z(row) < height ? 1 : 0;
        return image;
    };
    ensemble::PictureTarget picture{
        .frame = frame, .simulated = frame, .reading = {.closing = 1, .segments = 4}};
    picture.bed = read_bed(cut_through(bed_below(0), 0.5), frame, picture.reading);
    picture.segments = {1, 2};
    add_targets(responses_of(picture), ensemble::picture_numbers, ensemble::TargetSource::picture);
    experiment.targets[experiment.targets.size() - 2].comes_of = ensemble::TargetSource::picture;
    experiment.picture = picture;
    auto const page = rendered(campaign, [&](int run) {
        auto details = test::sample_details(run);
        rig::Series pixels{{"pixel", "share"}, {"1", "1"}, {std::vector<double>(1600), {}}};
        for (float const share : bed_below(0.025).darkness)
            pixels.columns[1].push_back(static_cast<double>(share));
        details.profiles.push_back({"picture", "", pixels});
        return details;
    });
    expect_no_error(page);
    auto const marks = marks_of(page);
    EXPECT_EQ(marks.at("curve-0-upper_mass_kg"),
              1 + 1 + 1 + 1); // border, band, both lines; nothing is predicted yet
    EXPECT_EQ(marks.at("photograph-0"), 1600);
    EXPECT_EQ(marks.count("profile-0-picture"), 0u);
    EXPECT_NE(page.find("mm² differ"), std::string::npos);
}

TEST(Render, runs_that_somebody_asked_for_have_pictures_and_films)
{
    auto const moments = test::sample_details(0).snapshots;
    auto const page =
        rendered(test::sample_campaign(), test::sample_details, {{{3, moments}}, {{4, moments}}});
    expect_no_error(page);
    auto const marks = marks_of(page);
    EXPECT_GE(marks.at("asked-3-" + moments.front().name), 600);
    EXPECT_GE(marks.at("asked-3-" + moments.back().name), 600);
    EXPECT_GE(marks.at("film-4"), 600);
    EXPECT_EQ(count_of(page, "type=\"range\" min=\"0\" max=\"1\""), 1);
    EXPECT_EQ(count_of(page, ">play</button>"), 1);
}

TEST(Render, new_campaign)
{
    auto const page = rendered(test::new_campaign());
    expect_no_error(page);
    EXPECT_TRUE(marks_of(page).empty());
}

} // namespace demens::report
