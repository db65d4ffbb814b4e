#pragma once

#include "tao_calib/design/factor_space.hpp"
#include "tao_calib/fit_table/fit_input.hpp"
#include "tao_calib/regression/own_units.hpp"

namespace demens::tao_calib {

//! Level of each factor; -1 of those that are continuous or blocks [factors].
using Levels = std::vector<int>;

//! The factors of a table as the columns of a regression: a continuous one is a column from -1 to 1; one of L
//! levels has L - 1, each 1 at its level and -1 at the first one (effect coding), so that 0 is the mean of
//! levels.
class FitSpace
{
  public:
    //! \param input with bounds and levels complete \throws InputError
    explicit FitSpace(FitInput const& input);

    std::vector<std::string> const& names() const { return names_; }       //!< of the columns
    std::vector<int> const& factor_of() const { return factor_of_; }       //!< [columns]
    std::vector<TermColumn> const& term_columns() const { return terms_; } //!< what each can take part in
    std::vector<Coding> const& codings() const { return codings_; }
    //! Columns of values: numbers, levels from 0 on, NaN for a block of no known level [factors].
    Eigen::VectorXd coded(Eigen::VectorXd const& values) const;

    //! Continuous factors that are not fixed, in the order of the input, with the constraints that are left
    //! for them; nothing where there are none.
    std::optional<FactorSpace> const& free() const { return free_; }
    //! All combinations of the levels that are not fixed.
    std::vector<Levels> const& choices() const { return choices_; }
    //! Values of all factors at values of the free ones.
    Eigen::VectorXd all_values(Eigen::VectorXd const& free_values, Levels const& levels) const;

  private:
    void add_columns(FitInput const& input);
    void make_free(FitInput const& input);
    void make_choices(FitInput const& input);

    std::vector<FitFactor> factors_;
    std::vector<std::string> names_;
    std::vector<int> factor_of_, level_of_; //!< [columns]; level -1: continuous
    std::vector<TermColumn> terms_;
    std::vector<Coding> codings_;
    std::optional<FactorSpace> continuous_, free_;
    std::vector<Levels> choices_;
};

//! The terms of the model less those to leave out. \throws InputError for a name that is no term
std::vector<Term> terms_of(FitInput const& input, FitSpace const& space);

} // namespace demens::tao_calib
