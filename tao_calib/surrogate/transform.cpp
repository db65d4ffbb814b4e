#include "tao_calib/surrogate/transform.hpp"

#include <algorithm>
#include <cmath>

namespace demens::tao_calib {
namespace {

constexpr double outermost = 1e-3; // of the scale or the range

} // namespace

using Eigen::VectorXd;

std::vector<std::string> const& Transform::kinds()
{
    static std::vector<std::string> const words = {"none", "log", "logit", "asinh"};
    return words;
}

Transform Transform::logarithm(double scale)
{
    return {Kind::log, outermost * scale, 0};
}

Transform Transform::logit(double lower, double upper)
{
    return {Kind::logit, lower, upper};
}

Transform Transform::area_sine(double centre, double scale)
{
    return {Kind::asinh, centre, scale};
}

double Transform::operator()(double response) const
{
    switch (kind_) {
    case Kind::none:
        return response;
    case Kind::log:
        return std::log(std::max(response, first_));
    case Kind::logit: {
        double const share = std::clamp((response - first_) / (second_ - first_), outermost, 1 - outermost);
        return std::log(share / (1 - share));
    }
    case Kind::asinh:
        return std::asinh((response - first_) / second_);
    }
    return response;
}

double Transform::inverse(double transformed) const
{
    switch (kind_) {
    case Kind::none:
        return transformed;
    case Kind::log:
        return std::exp(std::min(transformed, 700.0));
    case Kind::logit:
        return first_ + (second_ - first_) / (1 + std::exp(-transformed));
    case Kind::asinh:
        return first_ + second_ * std::sinh(std::clamp(transformed, -700.0, 700.0));
    }
    return transformed;
}

double Transform::inverse_slope(double transformed) const
{
    switch (kind_) {
    case Kind::none:
        return 1;
    case Kind::log:
        return inverse(transformed);
    case Kind::logit: {
        double const share = 1 / (1 + std::exp(-transformed));
        return (second_ - first_) * share * (1 - share);
    }
    case Kind::asinh:
        return second_ * std::cosh(std::clamp(transformed, -700.0, 700.0));
    }
    return 1;
}

double Transform::slope(double response) const
{
    return 1 / inverse_slope((*this)(response));
}

Samples transformed(Transform const& transform, Samples const& samples)
{
    Samples result = samples;
    for (Eigen::Index i = 0; i < result.values.size(); ++i) {
        result.values[i] = transform(samples.values[i]);
        if (result.squared_deviations.size() > 0)
            result.squared_deviations[i] *= std::pow(transform.slope(samples.values[i]), 2);
    }
    return result;
}

TransformedSurrogate::TransformedSurrogate(Transform transform, std::unique_ptr<Surrogate> inner,
                                           Samples const& samples)
    : transform_(transform), inner_(std::move(inner)), leave_one_out_(samples.values.size())
{
    for (Eigen::Index i = 0; i < leave_one_out_.size(); ++i) {
        double const predicted = transform_(samples.values[i]) - inner_->leave_one_out_errors()[i];
        leave_one_out_[i] = samples.values[i] - transform_.inverse(predicted);
    }
}

double TransformedSurrogate::value(VectorXd const& point) const
{
    return transform_.inverse(inner_->value(point));
}

VectorXd TransformedSurrogate::gradient(VectorXd const& point) const
{
    return transform_.inverse_slope(inner_->value(point)) * inner_->gradient(point);
}

double TransformedSurrogate::standard_deviation(VectorXd const& point) const
{
    return transform_.inverse_slope(inner_->value(point)) * inner_->standard_deviation(point);
}

double TransformedSurrogate::supported_deviation(VectorXd const& point) const
{
    return transform_.inverse_slope(inner_->value(point)) * inner_->supported_deviation(point);
}

} // namespace demens::tao_calib
