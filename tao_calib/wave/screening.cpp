#include "tao_calib/wave/screening.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "tao_calib/design/design.hpp"
#include "tao_calib/design/factor_space.hpp"
#include "tao_calib/regression/distributions.hpp"
#include "tao_calib/regression/regression.hpp"
#include "tao_calib/unit_cube.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int enough_degrees = 3; // of freedom, to take the error from repeated runs

//! The screening wave, or null while there is none that is complete.
ensemble::Wave const* complete_screening(ensemble::Campaign const& campaign)
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
    double mean_square = 0;
    int degrees = 0;
    bool from_replicates = false;
};

//! Main effects and curvature by least squares. A simulation without chance has no error at all, so that
//! nothing here divides by an error that may be 0.
class ScreeningFit
{
  public:
    explicit ScreeningFit(RegressionData const& data) : data_(data)
    {
        Index const n = data.coded.rows(), k = data.coded.cols();
        Eigen::MatrixXd rows(n, k + 1);
        rows << VectorXd::Ones(n), data.coded;
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> const qr(rows);
        if (qr.rank() < rows.cols())
            throw InputError(fmt::format("response `{}`: {} runs cannot determine {} coefficients",
                                         data.response, n, rows.cols()));
        coefficients_ = qr.solve(data.values);
        inverse_ = (rows.transpose() * rows).inverse();
        residual_squares_ = (data.values - rows * coefficients_).squaredNorm();
        rounding_ = std::pow(1e-10 * data.values.cwiseAbs().maxCoeff(), 2);
        find_pure_error();
        fit_curvature(rows);
    }

    double effect(int factor) const { return 2 * coefficients_[factor + 1]; }
    //! Of no effect, with the runs' error.
    double p_value(int factor, ErrorEstimate const& error) const
    {
        double const variance = error.mean_square * inverse_(factor + 1, factor + 1);
        return f_p_value(std::pow(coefficients_[factor + 1], 2) / variance, 1, error.degrees);
    }
    //! Of a run: from repeated ones where they are many, else from what main effects leave over.
    ErrorEstimate error() const
    {
        if (pure_.degrees >= enough_degrees)
            return pure_;
        int const degrees = static_cast<int>(data_.coded.rows() - coefficients_.size());
        return {degrees > 0 ? std::max(residual_squares_ / degrees, rounding_) : 0, degrees, false};
    }

    //! Response at the centre less what main effects make of the corners; NaN where the runs do not tell.
    double curvature() const { return curvature_; }
    //! Of no curvature (Montgomery, Design and Analysis of Experiments, section 6.8), tested against repeated
    //! runs, else against what main effects and curvature leave over; NaN where nothing is left.
    double curvature_p() const
    {
        auto const error = pure_.degrees > 0 ? pure_ : beside_curvature_;
        return std::isfinite(curvature_) && error.degrees > 0
                   ? f_p_value(std::pow(curvature_, 2) / (error.mean_square * curvature_variance_), 1,
                               error.degrees)
                   : not_a_number;
    }

  private:
    //! One term more that is 1 at the centre and 0 at the corners; points that constraints have moved lie
    //! between.
    void fit_curvature(Eigen::MatrixXd const& rows)
    {
        Index const n = rows.rows(), terms = rows.cols() + 1;
        Eigen::MatrixXd curved(n, terms);
        curved << rows,
            1 - data_.coded.rowwise().squaredNorm().array() / static_cast<double>(data_.coded.cols());
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> const qr(curved);
        if (qr.rank() < terms)
            return;
        VectorXd const coefficients = qr.solve(data_.values);
        curvature_ = coefficients[terms - 1];
        curvature_variance_ = (curved.transpose() * curved).inverse()(terms - 1, terms - 1);
        auto const degrees = static_cast<int>(n - terms);
        beside_curvature_ = {
            std::max((data_.values - curved * coefficients).squaredNorm() / std::max(degrees, 1), rounding_),
            degrees, false};
    }

    void find_pure_error()
    {
        std::vector<bool> counted(static_cast<std::size_t>(data_.values.size()));
        double squares = 0;
        for (Index i = 0; i < data_.values.size(); ++i) {
            if (counted[static_cast<std::size_t>(i)])
                continue;
            double runs = 0, mean = 0;
            for (Index j = i; j < data_.values.size(); ++j)
                if (data_.coded.row(i) == data_.coded.row(j)) {
                    counted[static_cast<std::size_t>(j)] = true;
                    double const before = data_.values[j] - mean;
                    mean += before / ++runs;
                    squares += before * (data_.values[j] - mean);
                }
            pure_.degrees += static_cast<int>(runs) - 1;
        }
        if (pure_.degrees > 0)
            pure_.mean_square = std::max(squares / pure_.degrees, rounding_);
        pure_.from_replicates = true;
    }

    RegressionData const& data_;
    VectorXd coefficients_;
    Eigen::MatrixXd inverse_; //!< (X'X)^-1
    double residual_squares_ = 0;
    double rounding_ = 0; //!< variance that rounding alone may leave
    ErrorEstimate pure_;  //!< of repeated runs
    ErrorEstimate beside_curvature_;
    double curvature_ = not_a_number, curvature_variance_ = 0; //!< the latter for runs of variance one
};

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
    result.effects = result.p_values = Eigen::MatrixXd::Constant(objective.size(), k, not_a_number);
    result.error_sd = result.error_degrees = VectorXd::Constant(objective.size(), not_a_number);
    result.curvature = result.curvature_p = VectorXd::Constant(objective.size(), not_a_number);
    result.curved.assign(static_cast<std::size_t>(objective.size()), false);
    result.active.assign(static_cast<std::size_t>(k), true);
    result.fixed_values = VectorXd::Constant(k, not_a_number);
    result.note = std::move(note);
    return result;
}

void keep_all(Screening& screening, std::string note)
{
    screening.active.assign(screening.active.size(), true);
    screening.fixed_values.setConstant(not_a_number);
    screening.note = std::move(note);
}

//! Fixes the inactive factors, or leaves all free where that cannot be.
void fix_inactive(ensemble::Campaign const& campaign, Screening& screening)
{
    auto const& factors = campaign.input.factors;
    if (std::none_of(screening.active.begin(), screening.active.end(), [](bool active) { return active; }))
        return keep_all(screening,
                        fmt::format("no factor is active at a significance of {:g}, so that all stay free",
                                    campaign.input.screening.significance));
    for (std::size_t f = 0; f < factors.size(); ++f)
        if (!screening.active[f])
            screening.fixed_values[static_cast<Index>(f)] = inactive_value(factors[f]);
    try {
        UnitCube const cube(factors, campaign.input.constraints, screening.fixed());
    } catch (InputError const& error) {
        keep_all(screening, fmt::format("all factors stay free, since the inactive ones cannot be fixed: {}",
                                        error.what()));
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
//! a factor fixed by mistake would cost the answer. Two levels do not show a factor that acts by its square:
//! where the centre points tell of one, nothing is fixed. A curvature below the sd of the target cannot
//! matter.
Screening screen(ensemble::Campaign const& campaign, Objective const& objective)
{
    auto const* wave = complete_screening(campaign);
    if (!wave)
        return all_active(campaign, objective, "");
    auto const k = static_cast<int>(campaign.input.factors.size());
    auto screening = all_active(campaign, objective, "");
    screening.active.assign(static_cast<std::size_t>(k), false);
    for (int t = 0; t < objective.size(); ++t) {
        auto const data = data_of(campaign, *wave, objective.targets()[t]);
        try {
            ScreeningFit const fit(data);
            auto const error = fit.error();
            if (error.degrees < 1)
                throw InputError(
                    fmt::format("response `{}`: no run is left to test effects against", data.response));
            screening.error_sd[t] = std::sqrt(error.mean_square);
            screening.error_degrees[t] = error.degrees;
            screening.from_replicates = error.from_replicates;
            for (int f = 0; f < k; ++f) {
                screening.effects(t, f) = fit.effect(f);
                screening.p_values(t, f) = fit.p_value(f, error);
                if (screening.p_values(t, f) <= campaign.input.screening.significance)
                    screening.active[static_cast<std::size_t>(f)] = true;
            }
            screening.curvature[t] = fit.curvature();
            screening.curvature_p[t] = fit.curvature_p();
            screening.curved[static_cast<std::size_t>(t)] =
                std::abs(screening.curvature[t]) > objective.measurement_sd()[t] &&
                !(screening.curvature_p[t] > campaign.input.screening.significance);
        } catch (InputError const& problem) {
            return all_active(
                campaign, objective,
                fmt::format("all factors stay free, since the screening says nothing: {}", problem.what()));
        }
    }
    if (auto const curved = std::find(screening.curved.begin(), screening.curved.end(), true);
        curved != screening.curved.end())
        keep_all(screening,
                 fmt::format(
                     "all factors stay free, since {} is curved at the centre",
                     objective.targets()[static_cast<std::size_t>(curved - screening.curved.begin())].name));
    else
        fix_inactive(campaign, screening);
    return screening;
}

} // namespace demens::tao_calib
