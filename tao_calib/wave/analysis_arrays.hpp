#pragma once

#include "tao_calib/wave/assessment.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace demens::tao_calib {

//! An array with zeros.
inline ensemble::NamedArray array_of(ensemble::stored::ArrayName const& name, std::vector<std::size_t> shape)
{
    std::size_t size = 1;
    for (auto const extent : shape)
        size *= extent;
    return {name.path, std::move(shape), std::vector<double>(size), name.units, name.doc};
}

//! Collects the arrays of a wave.
class Arrays
{
  public:
    using Name = ensemble::stored::ArrayName;

    void number(Name const& name, double value) { vector(name, Eigen::VectorXd::Constant(1, value)); }
    void vector(Name const& name, Eigen::VectorXd const& values) { matrix(name, values, {}); }
    void matrix(Name const& name, Eigen::MatrixXd const& values)
    {
        matrix(name, values, {static_cast<std::size_t>(values.cols())});
    }
    //! A number that is not finite is not known: it is stored as NaN.
    void add(ensemble::NamedArray array)
    {
        for (double& value : array.data)
            if (!std::isfinite(value))
                value = std::numeric_limits<double>::quiet_NaN();
        arrays_.push_back(std::move(array));
    }
    std::vector<ensemble::NamedArray> take() { return std::move(arrays_); }

  private:
    void matrix(Name const& name, Eigen::MatrixXd const& values, std::vector<std::size_t> columns)
    {
        columns.insert(columns.begin(), static_cast<std::size_t>(values.rows()));
        auto array = array_of(name, std::move(columns));
        Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            array.data.data(), values.rows(), values.cols()) = values;
        add(std::move(array));
    }

    std::vector<ensemble::NamedArray> arrays_;
};

//! How well factors are known, where the targets can be met, what trades off, which targets are out of reach.
void add_knowledge(Arrays& arrays, ensemble::Campaign const& campaign, Assessment const& assessment);
//! Effects and p values of the screening wave.
void add_screening(Arrays& arrays, Screening const& screening);

} // namespace demens::tao_calib
