#pragma once

#include "tao_calib/surrogate/surrogate.hpp"

#include <string>

namespace demens::tao_calib {

//! A monotone function of a response, in which it is fitted. Values from outside its domain (a flow of
//! nothing has no logarithm) count as the nearest place inside, so that a jam stays one sample among others.
class Transform
{
  public:
    //! Words that may name one: "none", "log", "logit", "asinh".
    static std::vector<std::string> const& kinds();

    //! The identity.
    Transform() = default;
    //! Logarithm of a positive response; values below a thousandth of `scale` count as that.
    static Transform logarithm(double scale);
    //! Logarithm of (y - lower)/(upper - y); the outermost thousandths of the range count as one place each.
    static Transform logit(double lower, double upper);
    //! Area sine of (y - centre)/scale: linear within a scale of the centre, logarithmic far away.
    static Transform area_sine(double centre, double scale);

    bool is_identity() const { return kind_ == Kind::none; }
    double operator()(double response) const;
    double inverse(double transformed) const;
    //! Slope of the inverse.
    double inverse_slope(double transformed) const;
    //! Slope at a response.
    double slope(double response) const;

  private:
    enum class Kind
    {
        none,
        log,
        logit,
        asinh
    };
    Transform(Kind kind, double first, double second) : kind_(kind), first_(first), second_(second) {}

    Kind kind_ = Kind::none;
    double first_ = 0, second_ = 1;
};

//! Samples in the transformed response.
Samples transformed(Transform const& transform, Samples const& samples);

//! A surrogate of the transformed response, seen in the response's own unit.
class TransformedSurrogate : public Surrogate
{
  public:
    //! \param samples in the response's own unit, `inner` fitted to the transformed ones
    TransformedSurrogate(Transform transform, std::unique_ptr<Surrogate> inner, Samples const& samples);

    SurrogateKind kind() const override { return inner_->kind(); }
    //! The median response, where the transformed one is symmetric about its mean.
    double value(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd gradient(Eigen::VectorXd const& point) const override;
    double standard_deviation(Eigen::VectorXd const& point) const override;
    double supported_deviation(Eigen::VectorXd const& point) const override;
    Eigen::VectorXd const& leave_one_out_errors() const override { return leave_one_out_; }
    double degrees_of_freedom() const override { return inner_->degrees_of_freedom(); }
    double smoothing() const override { return inner_->smoothing(); }

  private:
    Transform transform_;
    std::unique_ptr<Surrogate> inner_;
    Eigen::VectorXd leave_one_out_;
};

} // namespace demens::tao_calib
