#include "tao_calib/design/response_surface.hpp"

#include "demens/base/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace demens::tao_calib {

Eigen::MatrixXi full_factorial(std::vector<int> const& levels)
{
    constexpr double max_points = 1e5;
    double count = 1;
    for (int level : levels)
        count *= level;
    if (count > max_points)
        throw InputError(
            fmt::format("a full factorial of these {} factors has {:.3g} points, more than {:.0g}: take "
                        "fewer levels or another design",
                        levels.size(), count, max_points));
    Eigen::MatrixXi places(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(levels.size()));
    for (int i = 0; i < places.rows(); ++i) {
        int rest = i;
        for (std::size_t k = 0; k < levels.size(); ++k) {
            places(i, static_cast<Eigen::Index>(k)) = rest % levels[k];
            rest /= levels[k];
        }
    }
    return places;
}

double rotatable_axial_distance(int cube_points)
{
    return std::pow(cube_points, 0.25);
}

Eigen::MatrixXd central_composite(FractionalFactorial const& cube, double axial_distance)
{
    int const factors = cube.factors(), corners = cube.runs();
    Eigen::MatrixXd points = Eigen::MatrixXd::Zero(corners + 2 * factors, factors);
    points.topRows(corners) = cube.coded();
    for (int k = 0; k < factors; ++k) {
        points(corners + 2 * k, k) = -axial_distance;
        points(corners + 2 * k + 1, k) = axial_distance;
    }
    return points;
}

Eigen::MatrixXd box_behnken(int factors)
{
    // Blocks of factors that vary together while the others rest (Box and Behnken 1960, Technometrics 2:455).
    std::vector<std::vector<int>> blocks;
    if (factors >= 3 && factors <= 5) {
        for (int i = 0; i < factors; ++i)
            for (int j = i + 1; j < factors; ++j)
                blocks.push_back({i, j});
    } else if (factors == 6)
        blocks = {{0, 1, 3}, {1, 2, 4}, {2, 3, 5}, {0, 3, 4}, {1, 4, 5}, {0, 2, 5}};
    else if (factors == 7)
        blocks = {{3, 4, 5}, {0, 5, 6}, {1, 4, 6}, {0, 1, 3}, {2, 3, 6}, {0, 2, 4}, {1, 2, 5}};
    else
        throw InputError(
            fmt::format("a Box-Behnken design is for 3 to 7 factors, not {}: take central_composite or "
                        "d_optimal",
                        factors));

    auto const signs_per_block = 1 << blocks.front().size();
    Eigen::MatrixXd points =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(blocks.size()) * signs_per_block, factors);
    int row = 0;
    for (auto const& block : blocks)
        for (int signs = 0; signs < signs_per_block; ++signs, ++row)
            for (std::size_t k = 0; k < block.size(); ++k)
                points(row, block[k]) = signs >> k & 1 ? 1 : -1;
    return points;
}

} // namespace demens::tao_calib
