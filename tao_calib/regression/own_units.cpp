#include "tao_calib/regression/own_units.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

//! By degree; products before squares; in the order of the factors.
struct Before
{
    bool operator()(Term const& a, Term const& b) const
    {
        auto const largest = [](Term const& t) {
            return *std::max_element(t.exponents.begin(), t.exponents.end());
        };
        if (a.degree() != b.degree())
            return a.degree() < b.degree();
        if (largest(a) != largest(b))
            return largest(a) < largest(b);
        return a.exponents > b.exponents;
    }
};

//! (offset + slope x)^power as coefficients of 1, x, x^2, ...
std::vector<double> expanded(Coding const& column, int power)
{
    std::vector<double> result(static_cast<std::size_t>(power) + 1);
    double binomial = 1;
    for (int i = 0; i <= power; ++i) {
        result[static_cast<std::size_t>(i)] =
            binomial * std::pow(column.offset, power - i) * std::pow(column.slope, i);
        binomial *= static_cast<double>(power - i) / (i + 1);
    }
    return result;
}

//! A coded term as a sum of terms in own units.
std::vector<std::pair<Term, double>> expanded(Term const& term, std::vector<Coding> const& columns)
{
    std::vector<std::pair<Term, double>> sum{{Term{std::vector<int>(columns.size(), 0)}, 1}};
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (term.exponents[k] == 0)
            continue;
        auto const powers = expanded(columns[k], term.exponents[k]);
        std::vector<std::pair<Term, double>> next;
        for (auto const& [part, factor] : sum)
            for (std::size_t i = 0; i < powers.size(); ++i) {
                if (powers[i] == 0)
                    continue;
                next.emplace_back(part, factor * powers[i]);
                next.back().first.exponents[k] = static_cast<int>(i);
            }
        sum = std::move(next);
    }
    return sum;
}

} // namespace

std::vector<OwnCoefficient> in_own_units(Regression const& regression, std::vector<Coding> const& columns)
{
    auto const count = static_cast<Index>(regression.coefficients().size());
    std::map<Term, VectorXd, Before> sums; // of the coded coefficients
    for (Index t = 0; t < count; ++t)
        for (auto const& [term, factor] : expanded(regression.coefficients()[t].term, columns)) {
            auto& shares = sums.try_emplace(term, VectorXd::Zero(count)).first->second;
            shares[t] += factor;
        }
    VectorXd coded(count);
    for (Index t = 0; t < count; ++t)
        coded[t] = regression.coefficients()[t].value;
    std::vector<std::string> names;
    for (auto const& column : columns)
        names.push_back(column.name);
    double const sigma = regression.residual_standard_deviation();
    std::vector<OwnCoefficient> result;
    for (auto const& [term, shares] : sums)
        result.push_back({term.name(names), shares.dot(coded),
                          sigma * VectorXd(regression.inverse_root().transpose() * shares).norm()});
    return result;
}

} // namespace demens::tao_calib
