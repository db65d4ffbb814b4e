#pragma once

#include <array>

namespace demens::observe {

//! A polynomial of second order in the place, fitted to values by least squares: value = sum of coefficients
//! times 1, u, v, u^2, u v, v^2.
class QuadraticField
{
  public:
    //! Adds a value at a place, whose coordinates are about 1 or less, with a weight.
    void add(double u, double v, double value, double weight = 1);
    //! Fits to what was added: at least one value; where these lie on a line or fewer, a flatter polynomial.
    void fit();

    double operator()(double u, double v) const;

  private:
    static constexpr std::size_t terms = 6;

    std::array<std::array<double, terms>, terms> matrix_{};
    std::array<double, terms> right_{}, coefficients_{};
};

} // namespace demens::observe
