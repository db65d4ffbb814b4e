#include "tao_calib/wave/target_surrogate.hpp"

#include "tao_calib/surrogate/transform.hpp"

namespace demens::tao_calib {
namespace {

Transform transform_of(ensemble::Target const& target)
{
    using enum ensemble::TransformKind;
    switch (target.transform) {
    case log:
        return Transform::logarithm(target.scale);
    case logit:
        return Transform::logit(target.lower, target.upper);
    case asinh:
        return Transform::area_sine(target.value, target.scale);
    case none:
        break;
    }
    return {};
}

} // namespace

std::unique_ptr<Surrogate> fit_target(SurrogateChoice choice, ensemble::Target const& target,
                                      Samples const& samples)
{
    auto const transform = transform_of(target);
    if (transform.is_identity())
        return fit_surrogate(choice, samples);
    return std::make_unique<TransformedSurrogate>(
        transform, fit_surrogate(choice, transformed(transform, samples)), samples);
}

} // namespace demens::tao_calib
