#pragma once

#include "tao_calib/design/fractional_factorial.hpp"
#include "tao_calib/regression/analysis.hpp"

#include <string>
#include <vector>

//! Data of tests of the regression.
namespace demens::tao_calib::testing {

//! Data of a design in factors A, B, C, ...
inline RegressionData data_of(Eigen::MatrixXd const& coded, std::vector<double> const& values)
{
    RegressionData data{{}, "y", coded, Eigen::VectorXd::Map(values.data(), static_cast<int>(values.size()))};
    for (int k = 0; k < coded.cols(); ++k)
        data.factors.push_back(std::string(1, factor_letter(k)));
    return data;
}

//! Constant and the products named by letters, e.g. "AB".
inline std::vector<Term> terms_of(int factors, std::vector<std::string> const& names)
{
    std::vector<Term> terms{{std::vector<int>(factors, 0)}};
    for (auto const& name : names) {
        terms.push_back(terms.front());
        for (char letter : name)
            ++terms.back().exponents[letter - 'A'];
    }
    return terms;
}

//! Montgomery's central composite design with axial points at 1.414, first factor changing first.
inline RegressionData central_composite_data()
{
    Eigen::MatrixXd x(13, 2);
    x << -1, -1, -1, 1, 1, -1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1.414, 0, -1.414, 0, 0, 1.414, 0, -1.414;
    return data_of(x, {76.5, 77, 78, 79.5, 79.9, 80.3, 80, 79.7, 79.8, 78.4, 75.6, 78.5, 77});
}

} // namespace demens::tao_calib::testing
