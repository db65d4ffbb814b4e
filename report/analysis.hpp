#pragma once

#include "ensemble/campaign.hpp"

#include <nlohmann/json.hpp>

namespace demens::report {

//! What the calibration stored with the last wave that it analysed; see tao_calib/ANALYSIS.md.
class Analysis
{
  public:
    explicit Analysis(ensemble::Campaign const& campaign);
    //! That of one wave, which must outlive it.
    explicit Analysis(ensemble::Wave const& wave) : wave_(&wave) {}

    //! Number of the wave, -1 when none was analysed yet.
    int wave() const { return wave_ ? wave_->number : -1; }
    //! The array of that name, or null.
    ensemble::NamedArray const* find(ensemble::stored::ArrayName const& name) const;
    //! Its data as nested lists of its shape; null when it is absent.
    nlohmann::json values(ensemble::stored::ArrayName const& name) const;
    //! The first value of the array; NaN when it is absent.
    double scalar(ensemble::stored::ArrayName const& name) const;
    //! Is there a best fit?
    bool has_best() const { return find(ensemble::stored::optimum::best_point) != nullptr; }

  private:
    ensemble::Wave const* wave_ = nullptr;
};

//! Best fit, intervals and correlations of the factors.
nlohmann::json optimum_of(Analysis const& analysis);
//! Where the targets can be met and which factors trade off.
nlohmann::json findings_of(Analysis const& analysis);
//! Which factors act, where a screening was asked for.
nlohmann::json screening_of(Analysis const& analysis);
//! Predictions along each factor through the optimum and how good they are.
nlohmann::json surrogate_of(Analysis const& analysis);

} // namespace demens::report
