#include "tao_calib/design/sobol.hpp"

#include "demens/base/error.hpp"

#include <array>
#include <bit>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

struct Direction
{
    int degree;                       //!< of the primitive polynomial
    std::uint32_t coefficients;       //!< its inner coefficients as bits
    std::array<std::uint32_t, 5> odd; //!< first direction numbers m_1 ... m_degree
};

// Second dimension on, from Joe and Kuo (2008, SIAM J. Sci. Comput. 30:2635), table new-joe-kuo-6.21201.
constexpr std::array<Direction, max_sobol_dimensions - 1> joe_kuo{{{1, 0, {1}},
                                                                   {2, 1, {1, 3}},
                                                                   {3, 1, {1, 3, 1}},
                                                                   {3, 2, {1, 1, 1}},
                                                                   {4, 1, {1, 1, 3, 3}},
                                                                   {4, 4, {1, 3, 5, 13}},
                                                                   {5, 2, {1, 1, 5, 5, 17}},
                                                                   {5, 4, {1, 1, 5, 5, 5}},
                                                                   {5, 7, {1, 1, 7, 11, 19}}}};

} // namespace

SobolSequence::SobolSequence(int dimensions) : directions_(dimensions, bits), state_(dimensions)
{
    if (dimensions > max_sobol_dimensions)
        throw InputError(fmt::format("a Sobol design is for up to {} factors, not {}: take latin_hypercube",
                                     max_sobol_dimensions, dimensions));
    state_.setZero();
    for (int bit = 0; bit < bits; ++bit)
        directions_(0, bit) = 1u << (bits - 1 - bit);
    for (int k = 1; k < dimensions; ++k) {
        auto const& [degree, coefficients, odd] = joe_kuo[k - 1];
        for (int bit = 0; bit < bits; ++bit) {
            if (bit < degree) {
                directions_(k, bit) = odd[bit] << (bits - 1 - bit);
                continue;
            }
            std::uint32_t value = directions_(k, bit - degree) ^ (directions_(k, bit - degree) >> degree);
            for (int inner = 1; inner < degree; ++inner)
                if (coefficients >> (degree - 1 - inner) & 1u)
                    value ^= directions_(k, bit - inner);
            directions_(k, bit) = value;
        }
    }
}

// In Gray code order one bit changes from a point to the next (Antonov and Saleev 1979).
Eigen::VectorXd SobolSequence::next()
{
    Eigen::VectorXd const point = state_.cast<double>() * 0x1.0p-32;
    int const changing = std::countr_one(index_++);
    state_ = state_.binaryExpr(directions_.col(changing), [](auto a, auto b) { return a ^ b; });
    return point;
}

} // namespace demens::tao_calib
