#include "tao_calib/regression/terms.hpp"

#include <fmt/format.h>
#include <numeric>

namespace demens::tao_calib {

int Term::degree() const
{
    return std::accumulate(exponents.begin(), exponents.end(), 0);
}

bool Term::marginal_to(Term const& other) const
{
    for (std::size_t k = 0; k < exponents.size(); ++k)
        if (exponents[k] > other.exponents[k])
            return false;
    return true;
}

double Term::value(Eigen::VectorXd const& coded) const
{
    double product = 1;
    for (std::size_t k = 0; k < exponents.size(); ++k)
        for (int power = 0; power < exponents[k]; ++power)
            product *= coded[static_cast<Eigen::Index>(k)];
    return product;
}

std::string Term::name(std::vector<std::string> const& factors) const
{
    std::string text;
    for (std::size_t k = 0; k < exponents.size(); ++k) {
        if (exponents[k] == 0)
            continue;
        text += (text.empty() ? "" : "*") + factors[k];
        if (exponents[k] > 1)
            text += fmt::format("^{}", exponents[k]);
    }
    return text.empty() ? "constant" : text;
}

std::vector<Term> polynomial_terms(PolynomialModel model, int factors)
{
    return polynomial_terms(
        model, columns_of_factors(std::vector<std::size_t>(static_cast<std::size_t>(factors), 0)));
}

std::vector<TermColumn> columns_of_factors(std::vector<std::size_t> const& levels)
{
    std::vector<TermColumn> columns;
    for (std::size_t k = 0; k < levels.size(); ++k)
        columns.push_back({static_cast<int>(k), levels[k] == 0 || levels[k] > 2});
    return columns;
}

std::vector<Term> polynomial_terms(PolynomialModel model, std::vector<TermColumn> const& columns)
{
    int const factors = static_cast<int>(columns.size());
    auto product = [&](std::initializer_list<int> places) {
        Term term{std::vector<int>(factors, 0)};
        for (int k : places)
            ++term.exponents[k];
        return term;
    };
    std::vector<Term> terms{product({})};
    for (int k = 0; k < factors; ++k)
        terms.push_back(product({k}));
    if (model == PolynomialModel::linear)
        return terms;
    for (int i = 0; i < factors; ++i)
        for (int j = i + 1; j < factors; ++j)
            if (columns[i].factor != columns[j].factor && columns[i].interacts && columns[j].interacts)
                terms.push_back(product({i, j}));
    if (model == PolynomialModel::interaction)
        return terms;
    for (int k = 0; k < factors; ++k)
        if (columns[k].squared)
            terms.push_back(product({k, k}));
    return terms;
}

Eigen::MatrixXd model_matrix(std::vector<Term> const& terms, Eigen::MatrixXd const& coded)
{
    Eigen::MatrixXd matrix(coded.rows(), static_cast<Eigen::Index>(terms.size()));
    for (Eigen::Index i = 0; i < coded.rows(); ++i)
        for (std::size_t t = 0; t < terms.size(); ++t)
            matrix(i, static_cast<Eigen::Index>(t)) = terms[t].value(coded.row(i).transpose());
    return matrix;
}

} // namespace demens::tao_calib
