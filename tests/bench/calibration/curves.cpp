//! Whether the windows of a measured curve, or the segments of a photograph, are better predicted one by one
//! or by their principal components: leave-one-out errors of both on finished campaigns.
//!
//! usage: calibration_curves CAMPAIGN.h5...
#include "ensemble/session.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tao_calib/wave/assessment.hpp"
#include "tests/bench/calibration/with_petsc.hpp"

#include <Eigen/SVD>

#include <fmt/format.h>

namespace {

using namespace demens;
using Eigen::MatrixXd;
using Eigen::VectorXd;

//! Targets of one curve or picture of an experiment: numbers among all targets.
struct Group
{
    std::string name;
    std::vector<int> targets;
};

std::vector<Group> groups_of(ensemble::CampaignInput const& input)
{
    std::vector<Group> groups;
    int number = 0;
    for (auto const& experiment : input.experiments)
        for (auto const& target : experiment.targets) {
            auto const name = fmt::format("{}.{}", experiment.name,
                                          target.comes_of == ensemble::TargetSource::picture
                                              ? "picture"
                                              : target.response.substr(0, target.response.rfind('_')));
            if (target.comes_of != ensemble::TargetSource::value) {
                if (groups.empty() || groups.back().name != name)
                    groups.push_back({name, {}});
                groups.back().targets.push_back(number);
            }
            ++number;
        }
    return groups;
}

double rms(MatrixXd const& errors)
{
    return std::sqrt(errors.squaredNorm() / static_cast<double>(errors.size()));
}

//! Leave-one-out errors of the first so many principal components, as errors of the windows [n x m]. The
//! components are those of all locations, which favours them: a place that is left out has helped to choose
//! them.
MatrixXd by_components(MatrixXd const& values, tao_calib::Samples samples, ensemble::SurrogateChoice kind,
                       int components)
{
    Eigen::RowVectorXd const mean = values.colwise().mean();
    MatrixXd const centred = values.rowwise() - mean;
    Eigen::JacobiSVD<MatrixXd> const svd(centred, Eigen::ComputeThinU | Eigen::ComputeThinV);
    MatrixXd const basis = svd.matrixV().leftCols(components);
    MatrixXd const scores = centred * basis;
    MatrixXd errors = centred - scores * basis.transpose(); // of what the components leave out
    for (int c = 0; c < components; ++c) {
        samples.values = scores.col(c);
        errors += fit_surrogate(kind, samples)->leave_one_out_errors() * basis.col(c).transpose();
    }
    return errors;
}

void compare(std::string const& file, tao_calib::PetscSession const& petsc)
{
    auto const campaign = ensemble::read_campaign_file(file);
    tao_calib::Pounders const solver(petsc);
    tao_calib::Assessment const assessment(campaign, solver);
    if (!assessment.fitted()) {
        fmt::print("{}: too few runs\n", file);
        return;
    }
    auto const kind = campaign.input.surrogate.kind;
    for (auto const& [name, targets] : groups_of(campaign.input)) {
        auto const m = static_cast<Eigen::Index>(targets.size());
        auto samples = assessment.samples(targets.front());
        MatrixXd values(samples.values.size(), m), direct(samples.values.size(), m);
        for (Eigen::Index w = 0; w < m; ++w) {
            auto const target = targets[static_cast<std::size_t>(w)];
            values.col(w) = assessment.samples(target).values;
            direct.col(w) = assessment.surrogate(target).leave_one_out_errors();
        }
        samples.squared_deviations = {};
        MatrixXd const spread = values.rowwise() - values.colwise().mean();
        fmt::print("| {} {} | {} | {} | {:.4g} | {:.4g} |", file, name, samples.values.size(), m, rms(spread),
                   rms(direct));
        for (int components = 1; components <= 5; ++components)
            if (components <= m)
                fmt::print(" {:.4g} |", rms(by_components(values, samples, kind, components)));
            else
                fmt::print(" |");
        fmt::print("\n");
    }
}

} // namespace

int main(int count, char** arguments)
{
    return bench::with_petsc(count, arguments, [&] {
        fmt::print(
            "Root mean square error of a window, each location left out in turn:\n\n"
            "| campaign, curve | locations | windows | of the mean of all | one by one | 1 component | 2 "
            "| 3 | 4 | 5 |\n"
            "|---|---|---|---|---|---|---|---|---|---|\n");
        for (int k = 1; k < count; ++k)
            compare(arguments[k], *tao_calib::PetscEnvironment::session());
        return 0;
    });
}
