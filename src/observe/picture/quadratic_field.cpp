#include "src/observe/picture/quadratic_field.hpp"

#include <algorithm>
#include <cmath>

namespace demens::observe {
namespace {

std::array<double, 6> terms_at(double u, double v)
{
    return {1, u, v, u * u, u * v, v * v};
}

} // namespace

void QuadraticField::add(double u, double v, double value, double weight)
{
    auto const t = terms_at(u, v);
    for (std::size_t i = 0; i < terms; ++i) {
        for (std::size_t k = 0; k <= i; ++k)
            matrix_[i][k] += weight * t[i] * t[k];
        right_[i] += weight * t[i] * value;
    }
}

// Cholesky's factorisation; a term that the ones before it explain is left out.
void QuadraticField::fit()
{
    auto factor = matrix_;
    std::array<double, terms> half{};
    std::array<bool, terms> used{};
    for (std::size_t i = 0; i < terms; ++i) {
        double right = right_[i], diagonal = matrix_[i][i];
        for (std::size_t k = 0; k < i; ++k) {
            double sum = matrix_[i][k];
            for (std::size_t j = 0; j < k; ++j)
                sum -= factor[i][j] * factor[k][j];
            factor[i][k] = used[k] ? sum / factor[k][k] : 0;
            diagonal -= factor[i][k] * factor[i][k], right -= factor[i][k] * half[k];
        }
        used[i] = diagonal > 1e-8 * matrix_[i][i];
        factor[i][i] = used[i] ? std::sqrt(diagonal) : 1;
        half[i] = used[i] ? right / factor[i][i] : 0;
    }
    for (std::size_t i = terms; i-- > 0;) {
        double value = half[i];
        for (std::size_t k = i + 1; k < terms; ++k)
            value -= factor[k][i] * coefficients_[k];
        coefficients_[i] = used[i] ? value / factor[i][i] : 0;
    }
}

double QuadraticField::operator()(double u, double v) const
{
    auto const t = terms_at(u, v);
    double value = 0;
    for (std::size_t i = 0; i < terms; ++i)
        value += coefficients_[i] * t[i];
    return value;
}

} // namespace demens::observe
