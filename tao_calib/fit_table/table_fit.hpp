#pragma once

#include "demens/base/text/csv.hpp"
#include "tao_calib/fit_table/fit_space.hpp"

namespace demens::tao_calib {

//! The polynomial of one response, or why there is none.
struct ResponseFit
{
    std::optional<ReducedRegression> reduced;
    std::string failure;
    std::vector<int> lines; //!< of the table, one a run

    Regression const& regression() const { return reduced.value().regression; }
};

//! A polynomial for every response of a table.
class TableFit
{
  public:
    //! \throws InputError when the table lacks a column or cannot carry the model of any response.
    TableFit(FitInput input, text::CsvTable const& table);

    FitInput const& input() const { return input_; }               //!< bounds, levels and scales complete
    std::vector<ResponseFit> const& fits() const { return fits_; } //!< one a response
    //! What the author should know: rows left out, responses that cannot be fitted, numbers that are not
    //! defined, targets beyond all runs.
    std::vector<std::string> const& warnings() const { return warnings_; }
    //! Whether every response with a target has a fit.
    bool answers() const;

    FitSpace const& space() const { return *space_; }
    //! Continuous factors that are not fixed. There must be some.
    FactorSpace const& free_space() const { return space_->free().value(); }
    //! Predicted responses at values of the free factors, of the first levels if none are given; NaN without
    //! a fit [responses].
    Eigen::VectorXd predict(Eigen::VectorXd const& free_values) const;
    Eigen::VectorXd predict(Eigen::VectorXd const& free_values, Levels const& levels) const;

  private:
    struct Rows;

    Rows usable_rows(text::CsvTable const& table);
    void warn_of_repeated(text::CsvTable const& table, Rows& rows);
    void complete_factors(text::CsvTable const& table, Rows const& rows);
    Eigen::MatrixXd coded(text::CsvTable const& table, Rows const& rows) const;
    void fit(text::CsvTable const& table, Rows const& rows);
    ResponseFit fit_response(RegressionData const& data, std::vector<Term> const& terms) const;
    void warn_of_fit(ResponseFit const& fit);
    void warn_of_target_out_of_reach(FitResponse const& response, Eigen::VectorXd const& values);
    void complete_scales();

    FitInput input_;
    std::optional<FitSpace> space_;
    std::vector<ResponseFit> fits_;
    std::vector<std::string> warnings_;
};

} // namespace demens::tao_calib
