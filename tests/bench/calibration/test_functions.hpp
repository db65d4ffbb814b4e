#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace demens::bench {

//! Responses of factors in the unit cube, with a target and a scale for each.
struct TestFunction
{
    std::string name, origin;
    int factors;
    Eigen::VectorXd targets, scales;
    std::function<Eigen::VectorXd(Eigen::VectorXd const& unit)> responses;
    double best = 0; //!< root of the sum of squared residuals at the optimum

    int size() const { return static_cast<int>(targets.size()); }
    //! Root of the sum of squares of (response - target)/scale.
    double distance(Eigen::VectorXd const& unit) const;
};

//! Analytic response functions, and the recorded simulations of an auger as regressions.
//! \param auger_table inputs/auger-table/auger_lactose_doe.csv
std::vector<TestFunction> test_functions(std::string const& auger_table);

//! Distance that counts as found: 1 % of the way from the optimum to the median over the cube.
double found_at(TestFunction const& function);

} // namespace demens::bench
