#pragma once

#include "tao_calib/design/factor_space.hpp"
#include "tao_calib/regression/terms.hpp"

namespace demens::tao_calib {

struct DOptimalOptions
{
    int runs = 0;    //!< new points
    int levels = 3;  //!< of a continuous factor; constraints add the places where they cut a line of levels
    int starts = 50; //!< random designs that are improved; the best one wins
    Eigen::MatrixXd
        kept{}; //!< points already run, own units [points x factors]; they count, and stay as they are
};

//! New points, own units, that with the kept ones make det(X'X) of the model as large as can be found.
//! \throws InputError when there are fewer points than terms or the levels cannot carry the model.
Eigen::MatrixXd d_optimal(FactorSpace const& space, std::vector<Term> const& model,
                          DOptimalOptions const& options, std::uint64_t seed);

//! det(X'X) of the model at points in own units.
double information(FactorSpace const& space, std::vector<Term> const& model, Eigen::MatrixXd const& points);

} // namespace demens::tao_calib
