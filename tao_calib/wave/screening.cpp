#include "tao_calib/wave/screening.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/design/design.hpp"
#include "tao_calib/design/factor_space.hpp"
#include "tao_calib/regression/analysis.hpp"
#include "tao_calib/regression/distributions.hpp"
#include "tao_calib/unit_cube.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int enough_degrees = 3; // of freedom, to take the error from repeated runs

//! The screening wave, or null while there is none that is complete.
ensemble::Wave const* screening_wave(ensemble::Campaign const& campaign)
{
    for (auto const& wave : campaign.waves)
        if (wave.purpose == ensemble::WavePurpose::screening) {
            bool const waiting = std::any_of(wave.runs.begin(), wave.runs.end(), [](auto const& run) {
                return run.status == rig::RunStatus::not_run;
            });
            return waiting ? nullptr : &wave;
        }
    return nullptr;
}

//! Every finished run of the wave with a value for the target; a replicate is a row of its own.
RegressionData data_of(ensemble::Campaign const& campaign, ensemble::Wave const& wave,
                       CampaignTarget const& target)
{
    FactorSpace const space(campaign.input.factors, {});
    RegressionData data;
    for (auto const& factor : campaign.input.factors)
        data.factors.push_back(factor.name);
    data.response = target.name;
    std::vector<VectorXd> rows;
    std::vector<double> values;
    for (auto const& run : wave.runs) {
        if (run.status != rig::RunStatus::finished || run.experiment != target.experiment)
            continue;
        double const value = run.responses.at(static_cast<std::size_t>(target.target.response_index));
        if (!std::isfinite(value))
            continue;
        rows.push_back(space.coded(VectorXd::Map(run.factors.data(), space.size())));
        values.push_back(value);
    }
    data.coded.resize(static_cast<Index>(rows.size()), space.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        data.coded.row(static_cast<Index>(i)) = rows[i].transpose();
    data.values = VectorXd::Map(values.data(), static_cast<Index>(values.size()));
    return data;
}

//! Mean square of an error and its degrees of freedom.
struct ErrorEstimate
{
    double mean_square;
    int degrees;
    bool from_replicates;
};

ErrorEstimate error_of(Regression const& main_effects)
{
    for (auto const& row : analysis_of_variance(main_effects))
        if (row.source == "pure error" && row.degrees_of_freedom >= enough_degrees)
            return {row.mean_square, row.degrees_of_freedom, true};
    int const degrees = main_effects.residual_degrees_of_freedom();
    return {degrees > 0 ? main_effects.residual_sum_of_squares() / degrees : unknown, degrees, false};
}

double inactive_value(ensemble::Factor const& factor)
{
    if (!std::isnan(factor.inactive_value))
        return factor.inactive_value;
    if (!factor.levels.empty())
        return factor.levels[factor.levels.size() / 2];
    return factor.log_scale ? std::sqrt(factor.lower * factor.upper) : 0.5 * (factor.lower + factor.upper);
}

Screening all_active(ensemble::Campaign const& campaign, Objective const& objective, std::string note)
{
    auto const k = static_cast<Index>(campaign.input.factors.size());
    Screening result;
    result.effects = result.p_values = Eigen::MatrixXd::Constant(objective.size(), k, unknown);
    result.error_sd = result.error_degrees = VectorXd::Constant(objective.size(), unknown);
    result.active.assign(static_cast<std::size_t>(k), true);
    result.fixed_values = VectorXd::Constant(k, unknown);
    result.note = std::move(note);
    return result;
}

//! Fixes the inactive factors, or leaves all free where that cannot be.
void fix_inactive(ensemble::Campaign const& campaign, Screening& screening)
{
    auto const& factors = campaign.input.factors;
    auto keep_all = [&](std::string note) {
        screening.active.assign(factors.size(), true);
        screening.fixed_values.setConstant(unknown);
        screening.note = std::move(note);
    };
    if (std::none_of(screening.active.begin(), screening.active.end(), [](bool active) { return active; }))
        return keep_all(fmt::format("no factor is active at a significance of {:g}, so that all stay free",
                                    campaign.input.screening.significance));
    for (std::size_t f = 0; f < factors.size(); ++f)
        if (!screening.active[f])
            screening.fixed_values[static_cast<Index>(f)] = inactive_value(factors[f]);
    try {
        UnitCube const cube(factors, campaign.input.constraints, screening.fixed());
    } catch (InputError const& error) {
        keep_all(
            fmt::format("all factors stay free, since the inactive ones cannot be fixed: {}", error.what()));
    }
}

} // namespace

bool has_screening(ensemble::CampaignInput const& input)
{
    return input.screening.points > 0;
}

Eigen::MatrixXd screening_points(ensemble::CampaignInput const& input)
{
    ensemble::DesignOptions options;
    options.kind = ensemble::DesignKind::fractional_factorial;
    options.points = input.screening.points;
    options.generators = input.screening.generators;
    options.centre_repetitions = input.screening.centre_repetitions;
    return make_design(options, input.factors, input.constraints, input.seed);
}

//! Main effects are tested one by one; in a fraction of resolution IV no product of two factors is mixed up
//! with them. The 5 % level lets one in twenty inactive factors pass for every target: that costs runs, while
//! a factor fixed by mistake would cost the answer.
Screening screen(ensemble::Campaign const& campaign, Objective const& objective)
{
    auto const* wave = screening_wave(campaign);
    if (!wave)
        return all_active(campaign, objective, "");
    auto const k = static_cast<int>(campaign.input.factors.size());
    auto screening = all_active(campaign, objective, "");
    screening.active.assign(static_cast<std::size_t>(k), false);
    for (int t = 0; t < objective.size(); ++t) {
        auto const data = data_of(campaign, *wave, objective.targets()[t]);
        try {
            Regression const main_effects(data, polynomial_terms(PolynomialModel::linear, k));
            auto const error = error_of(main_effects);
            if (error.degrees < 1)
                throw InputError(
                    fmt::format("response `{}`: no run is left to test effects against", data.response));
            screening.error_sd[t] = std::sqrt(error.mean_square);
            screening.error_degrees[t] = error.degrees;
            screening.from_replicates = error.from_replicates;
            double const residual_sd = main_effects.residual_standard_deviation();
            for (int f = 0; f < k; ++f) {
                auto const& coefficient = main_effects.coefficients()[static_cast<std::size_t>(f) + 1];
                double const standard_error =
                    coefficient.standard_error * screening.error_sd[t] / residual_sd;
                screening.effects(t, f) = 2 * coefficient.value;
                screening.p_values(t, f) =
                    student_t_p_value(coefficient.value / standard_error, error.degrees);
                if (screening.p_values(t, f) <= campaign.input.screening.significance)
                    screening.active[static_cast<std::size_t>(f)] = true;
            }
        } catch (InputError const& problem) {
            return all_active(
                campaign, objective,
                fmt::format("all factors stay free, since the screening says nothing: {}", problem.what()));
        }
    }
    fix_inactive(campaign, screening);
    return screening;
}

} // namespace demens::tao_calib
