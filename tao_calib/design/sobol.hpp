#pragma once

#include <Eigen/Core>

namespace demens::tao_calib {

constexpr int max_sobol_dimensions = 10;

//! Sobol's sequence in the unit cube, one point after the other, from the origin on.
class SobolSequence
{
  public:
    //! \throws InputError for more dimensions than there are direction numbers.
    explicit SobolSequence(int dimensions);
    Eigen::VectorXd next();

  private:
    static constexpr int bits = 32;
    Eigen::Matrix<std::uint32_t, Eigen::Dynamic, bits> directions_; //!< [dimensions x bits]
    Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 1> state_;
    std::uint32_t index_ = 0;
};

} // namespace demens::tao_calib
