#include "demens/observe/picture/occupancy.hpp"

namespace demens::observe {

void Occupancy::add(std::span<dem::Place const> places)
{
    view_.draw(places);
    auto const mask = view_.mask();
    for (std::size_t k = 0; k < mask.covered.size(); ++k)
        sum_.darkness[k] += static_cast<float>(mask.covered[k]);
    ++frames_;
}

GreyImage Occupancy::mean() const
{
    GreyImage mean = sum_;
    for (float& share : mean.darkness)
        share /= static_cast<float>(frames_);
    return mean;
}

} // namespace demens::observe
