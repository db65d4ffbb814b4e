#pragma once

#include "gap/statistics/evidence.hpp"

#include <cstdint>

namespace demens::gap {

//! Made-up residuals whose cause is known. Twin i is a function of the seed and i alone: however the work is
//! shared out, it is the same.
class Twins
{
  public:
    //! \param floor Sigma_F [n x n]
    Twins(Evidence const& evidence, Eigen::MatrixXd const& floor, std::uint64_t seed);

    //! y - m0 where the base model is right: N(0, Sigma_F), factors from their prior [n, response units].
    Eigen::VectorXd base(std::uint64_t twin) const;
    //! Where effects act with these amplitudes. Their signatures are off by their own form error, and by the
    //! error of the regression that gave them.
    Eigen::VectorXd with(std::vector<Signature> const& effects, Eigen::VectorXd const& amplitudes,
                         std::uint64_t twin) const;
    //! Where something acts that no effect describes: smooth over conditions, `strength` of the response's
    //! scale.
    Eigen::VectorXd unknown(double strength, std::uint64_t twin) const;
    //! One amplitude from its prior [own unit].
    double amplitude(Signature const& effect, std::uint64_t twin) const;

  private:
    Evidence const& evidence_;
    Eigen::MatrixXd floor_root_, prior_root_, form_root_;
    std::uint64_t seed_;
};

} // namespace demens::gap
