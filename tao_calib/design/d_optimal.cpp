#include "tao_calib/design/d_optimal.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/regression/regression.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double ridge = 1e-8; //!< keeps a singular start invertible
constexpr int max_passes = 100;

//! Exchange of one coordinate of one point at a time (Meyer and Nachtsheim 1995, Technometrics 37:60).
class CoordinateExchange
{
  public:
    CoordinateExchange(FactorSpace const& space, std::vector<Term> const& model,
                       DOptimalOptions const& options)
        : space_(space), model_(model), levels_(options.levels),
          kept_information_(MatrixXd::Identity(terms(), terms()) * ridge)
    {
        for (Eigen::Index i = 0; i < options.kept.rows(); ++i) {
            VectorXd const row = row_of_values(options.kept.row(i).transpose());
            kept_information_ += row * row.transpose();
        }
    }

    //! Improves points of the unit cube in place and returns log det(X'X).
    double improve(MatrixXd& unit)
    {
        rows_.resize(unit.rows(), terms());
        for (Eigen::Index i = 0; i < unit.rows(); ++i)
            rows_.row(i) = row_of(unit.row(i).transpose()).transpose();
        invert();
        for (int pass = 0; pass < max_passes; ++pass) {
            bool better = false;
            for (Eigen::Index i = 0; i < unit.rows(); ++i)
                for (int k = 0; k < space_.size(); ++k)
                    better |= exchange(unit, i, k, pass == 0);
            if (!better && pass > 0)
                break;
        }
        return log_determinant_;
    }

  private:
    Eigen::Index terms() const { return static_cast<Eigen::Index>(model_.size()); }

    VectorXd row_of_values(VectorXd const& values) const
    {
        return model_matrix(model_, space_.coded(values).transpose()).transpose();
    }
    VectorXd row_of(VectorXd const& unit) const { return row_of_values(space_.own_units(unit)); }

    void invert()
    {
        Eigen::LLT<MatrixXd> const factor(kept_information_ + rows_.transpose() * rows_);
        inverse_ = factor.solve(MatrixXd::Identity(terms(), terms()));
        log_determinant_ = 2 * factor.matrixLLT().diagonal().array().log().sum();
    }

    //! Places that one coordinate of a feasible point may take.
    std::vector<double> places(VectorXd const& point, int factor) const
    {
        auto const& discrete = space_.factors()[factor].levels;
        int const count = discrete.empty() ? levels_ : static_cast<int>(discrete.size());
        auto feasible = [&](double place) {
            VectorXd moved = point;
            moved[factor] = place;
            return space_.feasible(space_.own_units(moved));
        };
        std::vector<double> result;
        for (int level = 0; level < count; ++level) {
            double const place =
                discrete.empty() ? static_cast<double>(level) / (count - 1) : (level + 0.5) / count;
            if (feasible(place))
                result.push_back(place);
        }
        if (!space_.constrained() || !discrete.empty())
            return result;
        for (double end : {0.0, 1.0}) {
            if (feasible(end))
                continue;
            double inside = point[factor], outside = end;
            while (std::abs(outside - inside) > 1e-12) {
                double const half = 0.5 * (inside + outside);
                (feasible(half) ? inside : outside) = half;
            }
            result.push_back(inside);
        }
        return result;
    }

    //! Puts a coordinate on its best place; at first also when that is worse than a start off the levels.
    bool exchange(MatrixXd& unit, Eigen::Index point, int factor, bool always)
    {
        VectorXd const old_row = rows_.row(point).transpose();
        VectorXd const old_solved = inverse_ * old_row;
        double const old_variance = old_row.dot(old_solved);

        VectorXd moved = unit.row(point).transpose();
        double best_ratio = always ? 0 : 1 + 1e-9, best_place = moved[factor];
        for (double place : places(unit.row(point).transpose(), factor)) {
            moved[factor] = place;
            VectorXd const row = row_of(moved);
            double const variance = row.dot(inverse_ * row), covariance = row.dot(old_solved);
            // det(M - old old' + row row') / det(M)
            double const ratio = (1 + variance) * (1 - old_variance) + covariance * covariance;
            if (ratio > best_ratio) {
                best_ratio = ratio;
                best_place = place;
            }
        }
        if (best_place == unit(point, factor))
            return false;
        unit(point, factor) = best_place;
        rows_.row(point) = row_of(unit.row(point).transpose()).transpose();
        invert();
        return true;
    }

    FactorSpace const& space_;
    std::vector<Term> const& model_;
    int levels_;
    MatrixXd kept_information_, rows_, inverse_;
    double log_determinant_ = 0;
};

} // namespace

double information(FactorSpace const& space, std::vector<Term> const& model, MatrixXd const& points)
{
    MatrixXd coded(points.rows(), points.cols());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        coded.row(i) = space.coded(points.row(i).transpose()).transpose();
    MatrixXd const matrix = model_matrix(model, coded);
    return (matrix.transpose() * matrix).determinant();
}

namespace {

//! Which terms alias at these points, as " (B^2 = constant)"; empty when it is a matter of rounding.
std::string aliases_of(FactorSpace const& space, std::vector<Term> const& model, MatrixXd const& points)
{
    RegressionData data;
    for (auto const& factor : space.factors())
        data.factors.push_back(factor.name);
    data.coded.resize(points.rows(), points.cols());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        data.coded.row(i) = space.coded(points.row(i).transpose()).transpose();
    auto const aliases = aliased_terms(data, model);
    return aliases.empty() ? "" : fmt::format(" ({})", fmt::join(aliases, "; "));
}

} // namespace

MatrixXd d_optimal(FactorSpace const& space, std::vector<Term> const& model, DOptimalOptions const& options,
                   std::uint64_t seed)
{
    auto const points = options.runs + options.kept.rows();
    auto const terms = static_cast<Eigen::Index>(model.size());
    if (points < terms)
        throw InputError(
            fmt::format("a D-optimal design for a model of {} terms needs at least as many points, not {}",
                        terms, points));
    if (options.runs < 1)
        throw InputError(
            fmt::format("a D-optimal design of {} points, of which {} are already there, has none to add",
                        points, options.kept.rows()));
    RandomStream random(seed);
    CoordinateExchange search(space, model, options);
    MatrixXd best;
    double best_value = -std::numeric_limits<double>::infinity();
    for (int start = 0; start < options.starts; ++start) {
        MatrixXd unit(options.runs, space.size());
        for (int i = 0; i < options.runs; ++i)
            unit.row(i) = space.sample(random).transpose();
        double const value = search.improve(unit);
        if (value > best_value + 1e-9) {
            best_value = value;
            best = unit;
        }
    }

    MatrixXd added = space.own_units_of_rows(best);
    MatrixXd all(points, space.size());
    if (options.kept.rows() > 0)
        all.topRows(options.kept.rows()) = options.kept;
    all.bottomRows(options.runs) = added;
    // Terms are at most 1 in size, so that this is small only when some term is (almost) a sum of others.
    if (!(std::pow(information(space, model, all), 1.0 / static_cast<double>(terms)) > 1e-4))
        throw InputError(
            fmt::format("no {} points on {} levels can tell the {} terms of the model apart{}: a quadratic "
                        "model needs three levels of every factor",
                        points, options.levels, terms, aliases_of(space, model, all)));
    return added;
}

} // namespace demens::tao_calib
