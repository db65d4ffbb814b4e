#include "tao_calib/wave/direct_search.hpp"

#include "tao_calib/solver/multi_start.hpp"
#include "tao_calib/wave/feasibility.hpp"

#include <algorithm>
#include <map>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

constexpr double first_radius = 0.15, last_radius = 1e-3;

struct Enough
{
};

//! The runs before the first search: repetitions later on do not move the start.
Locations designed(ensemble::Campaign const& campaign, Assessment const& assessment)
{
    Locations locations(assessment.objective(), assessment.cube());
    for (auto const& wave : campaign.waves) {
        if (wave.purpose == ensemble::WavePurpose::search)
            break;
        for (auto const& run : wave.runs)
            locations.add(run);
    }
    return locations;
}

//! Answers from the runs, and collects what they do not answer.
class Answers
{
  public:
    Answers(Assessment const& assessment, int count)
        : assessment_(assessment), feasibility_(assessment.locations()), count_(count)
    {
        auto const ranked = assessment.locations().ranked();
        worst_ = ranked.back()->responses;
        for (auto const& location : assessment.locations().all()) {
            std::vector<double> const point(location.factors.begin(), location.factors.end());
            // Where runs failed, or probably fail, the solver sees the worst that there was.
            known_[point] = location.complete() ? location.responses : worst_;
        }
    }

    VectorXd responses(VectorXd const& unit)
    {
        auto const point = assessment_.cube().to_design_point(unit);
        if (auto const found = known_.find(point); found != known_.end())
            return found->second;
        if (feasibility_.chance(unit) <= 0.5)
            return worst_;
        if (std::find(missing_.begin(), missing_.end(), point) == missing_.end()) {
            if (static_cast<int>(missing_.size()) == count_)
                throw Enough();
            missing_.push_back(point);
        }
        return assessment_.predict(unit);
    }

    std::vector<std::vector<double>> const& missing() const { return missing_; }

  private:
    Assessment const& assessment_;
    Feasibility feasibility_;
    VectorXd worst_; //!< responses
    int count_;
    std::map<std::vector<double>, VectorXd> known_;
    std::vector<std::vector<double>> missing_;
};

} // namespace

std::vector<std::vector<double>> direct_points(ensemble::Campaign const& campaign,
                                               Assessment const& assessment, int count)
{
    auto const before = designed(campaign, assessment);
    auto const* start = before.best();
    if (!start || count < 1)
        return {};
    Answers answers(assessment, count);
    auto const& objective = assessment.objective();
    auto const& cube = assessment.cube();
    LeastSquaresProblem const problem{cube.size(), objective.residual_count(), [&](VectorXd const& unit) {
                                          return objective.search_residuals(
                                              answers.responses(cube.project(unit)));
                                      }};
    LeastSquaresSettings settings;
    settings.trust_radius = first_radius;
    settings.tolerance = last_radius;
    settings.evaluations = 10000;
    try {
        (void)minimum_from(assessment.solver(), problem, cube, start->unit, settings);
    } catch (Enough const&) {
    }
    return answers.missing();
}

} // namespace demens::tao_calib
