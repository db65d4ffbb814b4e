#pragma once

#include "tao_calib/wave/assessment.hpp"

#include <string>
#include <vector>

namespace demens::tao_calib {

//! Collects arrays; a dimensionless one has units "1", one whose entries differ "mixed".
class Arrays
{
  public:
    void number(std::string path, double value, std::string units, std::string doc)
    {
        arrays_.push_back({std::move(path), {1}, {value}, std::move(units), std::move(doc)});
    }
    void vector(std::string path, Eigen::VectorXd const& values, std::string units, std::string doc)
    {
        arrays_.push_back({std::move(path),
                           {static_cast<std::size_t>(values.size())},
                           {values.begin(), values.end()},
                           std::move(units),
                           std::move(doc)});
    }
    void matrix(std::string path, Eigen::MatrixXd const& values, std::string units, std::string doc)
    {
        ensemble::NamedArray array{
            std::move(path),
            {static_cast<std::size_t>(values.rows()), static_cast<std::size_t>(values.cols())},
            {},
            std::move(units),
            std::move(doc)};
        for (Eigen::Index i = 0; i < values.rows(); ++i)
            for (Eigen::Index j = 0; j < values.cols(); ++j)
                array.data.push_back(values(i, j));
        arrays_.push_back(std::move(array));
    }
    void add(ensemble::NamedArray array) { arrays_.push_back(std::move(array)); }
    std::vector<ensemble::NamedArray> take() { return std::move(arrays_); }

  private:
    std::vector<ensemble::NamedArray> arrays_;
};

//! How well factors are known, where the targets can be met, what trades off, which targets are out of reach.
void add_knowledge(Arrays& arrays, ensemble::Campaign const& campaign, Assessment const& assessment);
//! Effects and p values of the screening wave.
void add_screening(Arrays& arrays, Screening const& screening);

} // namespace demens::tao_calib
