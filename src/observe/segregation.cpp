#include "demens/observe/segregation.hpp"

#include <cmath>
#include <limits>

namespace demens::observe {

void Segregation::add(Vector3 const& place, double mass, bool first_kind)
{
    auto const along = [&](double x) { return static_cast<long>(std::floor(x / cell_)); };
    auto& masses = cells_[{along(place.x), along(place.y), along(place.z)}];
    masses.all += mass;
    if (first_kind)
        masses.first += mass;
}

double Segregation::intensity() const
{
    Masses total;
    for (auto const& [cell, masses] : cells_) {
        total.first += masses.first;
        total.all += masses.all;
    }
    double const share = total.first / total.all;
    if (!(share > 0 && share < 1))
        return std::numeric_limits<double>::quiet_NaN();
    double variance = 0;
    for (auto const& [cell, masses] : cells_) {
        double const deviation = masses.first / masses.all - share;
        variance += masses.all / total.all * deviation * deviation;
    }
    return variance / (share * (1 - share));
}

} // namespace demens::observe
