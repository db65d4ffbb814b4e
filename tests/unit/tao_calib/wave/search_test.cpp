#include "tao_calib/solver/solver_choice.hpp"
#include "tao_calib/wave/direct_search.hpp"
#include "tao_calib/wave/feasibility.hpp"
#include "tao_calib/wave/improvement.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

using ensemble::SearchKind;
using ensemble::SolverKind;

struct Way
{
    SearchKind search;
    SolverKind solver;
};

class EveryWay : public ::testing::TestWithParam<Way>
{
};

Way of(SolverKind solver)
{
    return {SearchKind::surrogate_minima, solver};
}
Way of(SearchKind search)
{
    return {search, SolverKind::pounders};
}

INSTANTIATE_TEST_SUITE_P(Search, EveryWay,
                         ::testing::Values(of(SolverKind::quasi_newton), of(SolverKind::bobyqa),
                                           of(SolverKind::simplex), of(SolverKind::genetic),
                                           of(SearchKind::rbf_distance), of(SearchKind::response_surface),
                                           of(SearchKind::expected_improvement),
                                           of(SearchKind::pounders_direct)),
                         [](auto const& info) {
                             return info.param.search == SearchKind::surrogate_minima
                                        ? word_for(info.param.solver)
                                        : word_for(info.param.search);
                         });

TEST_P(EveryWay, FindsKnownFrictionFromScatteringRuns)
{
    // A published calibration of three frictions took 600 runs to a mean square residual of 1.4.
    auto stand_in = draw_down_campaign({0.9, 0.6, 0.25}, {0.5, -0.5, 0.3, 0.8}, 1);
    stand_in.campaign.input.search.kind = GetParam().search;
    stand_in.campaign.input.solver.kind = GetParam().solver;
    stand_in.campaign.input.solver.starts = 5;
    stand_in.run_to_the_end();
    EXPECT_LE(stand_in.runs(), 60);
    EXPECT_LT(stand_in.stored("optimum/mean_square_residual").front(), 0.2) << stand_in.campaign.ended;
    for (auto const& wave : stand_in.campaign.waves)
        for (auto const& run : wave.runs)
            EXPECT_LE(run.factors[1], run.factors[0]); // the constraint
}

TEST(DirectSearch, AsksForAllInterpolationPointsAtOnceAndComesToAnEnd)
{
    // Two linear responses without scatter: (a + b, a - b) = (1.1, 0.3) at (0.7, 0.4).
    static auto const rig = response_names({"sum", "difference"});
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{f[0] + f[1], f[0] - f[1]};
        },
        {0.0, 0.0});
    auto& input = stand_in.campaign.input;
    input.factors = {{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}};
    ensemble::Experiment experiment;
    experiment.name = "bench";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    double const none = std::numeric_limits<double>::quiet_NaN();
    experiment.targets = {{"sum", 0, 1.1, 0.1, none, none}, {"difference", 1, 0.3, 0.1, none, none}};
    input.experiments = {experiment};
    input.design.points = 6;
    input.search.kind = SearchKind::pounders_direct;
    input.stop.runs = 80;
    ASSERT_TRUE(stand_in.advance());
    ASSERT_TRUE(stand_in.advance());
    // Two interpolation points about the best location, and more that the solver will probably ask for.
    EXPECT_GE(stand_in.campaign.waves.back().runs.size(), 2u);
    stand_in.run_to_the_end();
    EXPECT_NE(stand_in.campaign.ended.find("POUNDERS"), std::string::npos) << stand_in.campaign.ended;
    EXPECT_NEAR(stand_in.stored("optimum/best_point")[0], 0.7, 1e-3);
    EXPECT_NEAR(stand_in.stored("optimum/best_point")[1], 0.4, 1e-3);
    EXPECT_LT(stand_in.runs(), 40);
}

TEST(ExpectedImprovement, HasTheValuesOfTheClosedForm)
{
    EXPECT_NEAR(expected_improvement(0, 1, 0), 0.3989422804, 1e-10);
    EXPECT_NEAR(expected_improvement(1, 1, 0), 0.0833154706, 1e-10);
    EXPECT_NEAR(expected_improvement(0.5, 2, 0.2), 0.6568439695, 1e-10);
    EXPECT_EQ(expected_improvement(0.5, 0, 0.2), 0);
}

TEST(ExpectedImprovement, OfSquaresIsThatOfDraws)
{
    // A sum of squares of normal residuals by Monte Carlo with 200000 draws.
    VectorXd const means{{0.5, -1.0, 0.2}}, sds{{0.3, 0.8, 0.5}};
    RandomStream random(3);
    double sum = 0;
    constexpr int draws = 200000;
    for (int i = 0; i < draws; ++i) {
        double squares = 0;
        for (int t = 0; t < 3; ++t) {
            double normal = -6;
            for (int n = 0; n < 12; ++n)
                normal += random.uniform();
            squares += std::pow(means[t] + sds[t] * normal, 2);
        }
        sum += std::max(1.5 - squares, 0.0);
    }
    EXPECT_NEAR(expected_improvement_of_squares(means, sds, 1.5), sum / draws, 0.02);
    // One residual that is known for sure.
    EXPECT_NEAR(expected_improvement_of_squares(VectorXd{{0.5}}, VectorXd{{0.0}}, 1.0), 0.75, 1e-12);
    // Chi-square with two degrees of freedom is exponential of mean 2: 1 - 2 (1 - exp(-1/2)).
    EXPECT_NEAR(expected_improvement_of_squares(VectorXd::Zero(2), VectorXd::Ones(2), 1.0),
                1 - 2 * (1 - std::exp(-0.5)), 1e-12);
}

//! Runs fail where the second factor is above one half.
Locations half_failing(Objective const& objective, UnitCube const& cube)
{
    Locations locations(objective, cube);
    int next = 0;
    for (double a : {0.1, 0.5, 0.9})
        for (double b : {0.05, 0.3, 0.7, 0.95}) {
            ensemble::RunRecord run;
            run.run = run.point = next++;
            run.factors = {a, b};
            run.status = b > 0.5 ? rig::RunStatus::escaped : rig::RunStatus::finished;
            run.responses = {a};
            locations.add(run);
        }
    return locations;
}

TEST(Feasibility, IsLearntFromWhereRunsFail)
{
    double const none = std::numeric_limits<double>::quiet_NaN();
    ensemble::Target const target{"y", 0, 0, 1, none, none};
    Objective const objective({{0, target, "e.y", ""}});
    UnitCube const cube({{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}}, {});
    Feasibility const feasibility(half_failing(objective, cube));
    EXPECT_GT(feasibility.chance(VectorXd{{0.5, 0.2}}), 0.85);
    EXPECT_LT(feasibility.chance(VectorXd{{0.5, 0.85}}), 0.15);
    EXPECT_NEAR(feasibility.chance(VectorXd{{0.5, 0.5}}), 0.5, 0.1);
    EXPECT_EQ(Feasibility(Locations(objective, cube)).chance(VectorXd{{0.5, 0.5}}), 1);
}

TEST(Feasibility, SpendsNoRunsWhereRunsFailOnceTheRestIsUsedUp)
{
    // Runs blow up beyond a quarter of the range, and no target can be met: what is left apart from them is
    // soon simulated, and then the search must end, not go back.
    static auto const rig = response_names({"height"});
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            if (f[0] < -5)
                throw std::runtime_error("overlap beyond the limit");
            return std::vector<double>{0.006 + 0.0001 * f[0] * f[0]};
        },
        {0.0});
    auto& input = stand_in.campaign.input;
    input.factors = {{"vz", "vz", -20.0, 0.0}};
    ensemble::Experiment experiment;
    experiment.name = "box";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    double const none = std::numeric_limits<double>::quiet_NaN();
    experiment.targets = {{"height", 0, 0.0052, 0.0005, none, none}};
    input.experiments = {experiment};
    input.design.points = 12;
    input.stop.waves = 12;
    input.stop.runs = 100;
    input.stop.no_improvement_waves = 0;
    stand_in.run_to_the_end();
    int failed = 0, searched = 0;
    for (auto const& wave : stand_in.campaign.waves)
        for (auto const& run : wave.runs)
            if (wave.purpose == ensemble::WavePurpose::search) {
                ++searched;
                failed += run.status != rig::RunStatus::finished;
            }
    EXPECT_GT(searched, 3);
    EXPECT_LE(failed, 2);
    EXPECT_EQ(stand_in.campaign.ended.find("levels"), std::string::npos) << stand_in.campaign.ended;
}

class SearchKinds : public ::testing::TestWithParam<SearchKind>
{
};

INSTANTIATE_TEST_SUITE_P(Search, SearchKinds,
                         ::testing::Values(SearchKind::surrogate_minima, SearchKind::rbf_distance,
                                           SearchKind::response_surface, SearchKind::expected_improvement),
                         [](auto const& info) { return word_for(info.param); });

TEST_P(SearchKinds, MeetsNarrowTolerancesOfASmoothSimulation)
{
    // Rebound, contact time and overlap of a ball, closed forms of restitution, friction and stiffness, the
    // latter over three decades; targets to be met within half a per cent, without scatter.
    static auto const rig = response_names({"tangential", "normal", "time", "overlap"});
    auto const formula = [](std::vector<double> const& f, int) {
        double const mu = f[0], e = f[1], stiffness = f[2] / 1e8;
        return std::vector<double>{1 - mu * (1 + e) * 0.2679, e,
                                   413 * std::pow(stiffness, -0.4) * (1 + 0.1 * (1 - e)),
                                   32 * std::pow(stiffness, -0.4) * (0.9 + 0.1 * e)};
    };
    for (auto const& truth :
         {std::vector{0.2, 0.73, 2.5e7}, std::vector{0.31, 0.52, 3e8}, std::vector{0.12, 0.85, 4e6}}) {
        StandIn stand_in(formula, {0, 0, 0, 0});
        auto& input = stand_in.campaign.input;
        input.factors = {{"mu", "mu", 0.05, 0.5}, {"e", "e", 0.3, 0.95}, {"E", "E", 1e6, 1e9, true}};
        ensemble::Experiment experiment;
        experiment.name = "ob";
        experiment.rig = &rig;
        experiment.responses = rig.responses;
        auto const values = formula(truth, 0);
        for (int t = 0; t < 4; ++t) {
            double const value = values[static_cast<std::size_t>(t)];
            experiment.targets.push_back({rig.responses[static_cast<std::size_t>(t)].name, t, value,
                                          0.02 * value, std::numeric_limits<double>::quiet_NaN(),
                                          0.005 * value});
        }
        input.experiments = {experiment};
        input.search.kind = GetParam();
        input.stop.runs = 150;
        input.stop.no_improvement_waves = 50;
        input.stop.confirmation = 0;
        stand_in.run_to_the_end();
        EXPECT_LE(stand_in.runs(), 60) << stand_in.campaign.ended;
        EXPECT_NE(stand_in.campaign.ended.find("tolerance is met"), std::string::npos)
            << stand_in.campaign.ended;
    }
}

TEST(Feasibility, KeepsTheSearchOutOfWhereRunsFail)
{
    // The optimum is at (0.3, 0.45) beside a region b > 0.5 where nothing flows; after the design, most
    // points of the search must be good.
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            if (f[1] > 0.5)
                throw std::runtime_error("an arch");
            return std::vector<double>{f[0] + f[1], f[0] - f[1]};
        },
        {0.01, 0.01});
    static auto const rig = response_names({"sum", "difference"});
    auto& input = stand_in.campaign.input;
    input.factors = {{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}};
    ensemble::Experiment experiment;
    experiment.name = "bench";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    double const none = std::numeric_limits<double>::quiet_NaN();
    experiment.targets = {{"sum", 0, 0.75, 0.05, none, none}, {"difference", 1, -0.15, 0.05, none, none}};
    input.experiments = {experiment};
    input.design.points = 12;
    input.stop.runs = 50;
    input.stop.no_improvement_waves = 0; // it is known after some eight runs
    stand_in.run_to_the_end();
    int searched = 0, failed = 0;
    for (auto const& wave : stand_in.campaign.waves)
        for (auto const& run : wave.runs)
            if (wave.purpose == ensemble::WavePurpose::search) {
                ++searched;
                failed += run.status != rig::RunStatus::finished;
            }
    EXPECT_GT(searched, 10);
    EXPECT_LT(failed, searched / 4);
    EXPECT_LT(stand_in.stored("optimum/mean_square_residual").front(), 0.1);
}

} // namespace
} // namespace demens::tao_calib
