#include "tests/bench/calibration/test_functions.hpp"

#include "demens/base/random.hpp"
#include "tao_calib/regression/regression.hpp"
#include "tao_calib/regression/table_column.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace demens::bench {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;
using tao_calib::PolynomialModel;
using tao_calib::Regression;
using tao_calib::RegressionData;

//! A function whose targets are its own responses at a point, so that the optimum is 0 there.
TestFunction with_answer(std::string name, std::string origin, VectorXd const& answer, VectorXd const& scales,
                         std::function<VectorXd(VectorXd const&)> responses)
{
    VectorXd const targets = responses(answer);
    return {std::move(name),
            std::move(origin),
            static_cast<int>(answer.size()),
            targets,
            scales,
            std::move(responses),
            0};
}

TestFunction draw_down()
{
    return with_answer("draw down", "formula of the size of the published responses",
                       VectorXd{{0.73, 0.45, 0.42}}, VectorXd{{2, 2, 0.3, 0.5}}, [](VectorXd const& u) {
                           double const s = 0.1 + 1.1 * u[0], k = 0.1 + 1.1 * u[1], r = 0.6 * u[2];
                           return VectorXd{{12 + 14 * std::sqrt(s) + 20 * r - 8 * r * r - 4 * r * s,
                                            36 + 12 * k - 4 * k * k + 5 * r + 2 * s,
                                            7.5 - 2.6 * k + 0.8 * k * k - 1.5 * r,
                                            5.5 + 1.2 * k + 1.0 * r * s + 0.4 * s}};
                       });
}

//! Full quadratics through the 20 simulations of El Kassem et al. 2021, at 800 rev/min.
TestFunction auger(std::string const& file)
{
    auto const table = demens::text::CsvTable::from_file(file);
    std::vector<std::string> const factors = {"speed", "mu_s_pp", "mu_s_pw", "mu_r_pp"};
    RegressionData data;
    data.factors = factors;
    data.coded.resize(table.rows(), 4);
    for (int k = 0; k < 4; ++k) {
        VectorXd const column = tao_calib::column_values(table, factors[static_cast<std::size_t>(k)]);
        double const lower = column.minCoeff(), upper = column.maxCoeff();
        data.coded.col(k) = (2 * (column.array() - lower) / (upper - lower) - 1).matrix();
    }
    auto fits = std::make_shared<std::vector<Regression>>();
    for (char const* response : {"aor", "bulk_density", "mass_flow", "na_tke"}) {
        data.response = response;
        data.values = tao_calib::column_values(table, response);
        fits->push_back(
            tao_calib::eliminate_backward(data, tao_calib::polynomial_terms(PolynomialModel::quadratic, 4))
                .regression);
    }
    return with_answer("auger", "regressions of 20 recorded DEM runs (El Kassem et al. 2021)",
                       VectorXd{{0.35, 0.82, 0.2}}, VectorXd{{0.5, 0.003, 0.01, 0.004}},
                       [fits](VectorXd const& u) {
                           VectorXd const coded{{1, 2 * u[0] - 1, 2 * u[1] - 1, 2 * u[2] - 1}};
                           VectorXd values(4);
                           for (int t = 0; t < 4; ++t)
                               values[t] = (*fits)[static_cast<std::size_t>(t)].predict(coded);
                           return values;
                       });
}

//! Friction and cohesion raise the bed until it slides as a whole: saturating, with a product.
TestFunction drum()
{
    return with_answer("drum", "saturating formula of break, rest and avalanche energy",
                       VectorXd{{0.7, 0.25, 0.8}}, VectorXd{{0.3, 0.3, 0.1}}, [](VectorXd const& u) {
                           double const rise = std::tanh(2.2 * u[0]) + 0.5 * std::tanh(4 * u[1]);
                           double const stick = 1 - std::exp(-1.5 * u[2] * (0.4 + u[1]));
                           return VectorXd{{20 + 7 * rise + 2 * stick, 19 + 6.5 * rise + 0.8 * stick,
                                            1 + 0.5 * rise + 1.2 * stick}};
                       });
}

//! Flow stops at high friction and cohesion; the angle goes on rising.
TestFunction jam()
{
    return with_answer(
        "jam", "a flow that stops where friction and cohesion are high", VectorXd{{0.42, 0.3}},
        VectorXd{{0.2, 1.0}}, [](VectorXd const& u) {
            double const free = std::max(0.0, 1 - 0.9 * u[0] - 0.7 * u[1] * u[1]);
            return VectorXd{{4 * std::pow(free, 1.5), 20 + 18 * std::sqrt(u[0] + 0.05) + 6 * u[1]}};
        });
}

TestFunction decay()
{
    return with_answer("decay", "six samples of a decaying flow, three factors (as Chwirut1)",
                       VectorXd{{0.35, 0.6, 0.5}}, VectorXd::Constant(6, 0.5), [](VectorXd const& u) {
                           VectorXd values(6);
                           for (int i = 0; i < 6; ++i) {
                               double const t = 0.5 + i;
                               values[i] = 20 * std::exp(-(0.1 + 0.5 * u[0]) * t) /
                                           (0.5 + u[1] + (0.05 + 0.5 * u[2]) * t);
                           }
                           return values;
                       });
}

//! Residuals (10 (y - x^2), 1.3 - x): the optimum is in a corner, at a distance of 0.3.
TestFunction rosenbrock()
{
    return {"rosenbrock",
            "residuals with a target out of reach, a curved valley",
            2,
            VectorXd{{0, 1.3}},
            VectorXd::Ones(2),
            [](VectorXd const& u) {
                return VectorXd{{10 * (u[1] - u[0] * u[0]), u[0]}};
            },
            0.3};
}

//! Branin's sum of squares as its two parts; three optima.
TestFunction branin()
{
    return {"branin",
            "the two parts of Branin's function, three optima",
            2,
            VectorXd{{0, 0}},
            VectorXd{{1, 1}},
            [](VectorXd const& u) {
                double const x = 15 * u[0] - 5, y = 15 * u[1];
                double const q = y - 5.1 / (4 * pi * pi) * x * x + 5 / pi * x - 6;
                return VectorXd{{q, std::sqrt(10 * (1 - 1 / (8 * pi)) * (std::cos(x) + 1))}};
            },
            0};
}

} // namespace

double TestFunction::distance(VectorXd const& unit) const
{
    return (responses(unit) - targets).cwiseQuotient(scales).norm();
}

std::vector<TestFunction> test_functions(std::string const& auger_table)
{
    return {draw_down(), auger(auger_table), drum(), jam(), decay(), rosenbrock(), branin()};
}

double found_at(TestFunction const& function)
{
    RandomStream random(1);
    std::vector<double> distances(1001);
    for (double& distance : distances) {
        VectorXd unit(function.factors);
        for (double& x : unit)
            x = random.uniform();
        distance = function.distance(unit);
    }
    std::nth_element(distances.begin(), distances.begin() + 500, distances.end());
    return function.best + 0.01 * (distances[500] - function.best);
}

} // namespace demens::bench
