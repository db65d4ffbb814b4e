#pragma once

#include "tao_calib/design/factor_space.hpp"
#include "tao_calib/fit_table/fit_input.hpp"
#include "tao_calib/regression/table_column.hpp"

namespace demens::tao_calib {

//! A polynomial for every response of a table.
class TableFit
{
  public:
    //! \throws InputError when the table lacks a column or cannot carry the model.
    TableFit(FitInput input, text::CsvTable const& table);

    FitInput const& input() const { return input_; }                     //!< bounds and scales complete
    std::vector<ReducedRegression> const& fits() const { return fits_; } //!< one a response
    //! What the author should know of the table: rows left out, targets beyond all runs.
    std::vector<std::string> const& warnings() const { return warnings_; }

    //! Factors that are not fixed, in the order of the input, with the constraints that are left for them.
    FactorSpace const& free_space() const { return *free_space_; }
    //! Values of all factors, own units, at values of the free ones.
    Eigen::VectorXd all_values(Eigen::VectorXd const& free_values) const;
    //! Predicted responses at values of the free factors [responses].
    Eigen::VectorXd predict(Eigen::VectorXd const& free_values) const;

  private:
    void complete_bounds(text::CsvTable const& table);
    std::vector<int> usable_rows(text::CsvTable const& table);
    void fit(text::CsvTable const& table, std::vector<int> const& rows);
    void warn_of_target_out_of_reach(FitResponse const& response, Eigen::VectorXd const& values);
    void make_spaces();

    FitInput input_;
    std::optional<FactorSpace> space_, free_space_;
    std::vector<ReducedRegression> fits_;
    std::vector<std::string> warnings_;
};

} // namespace demens::tao_calib
