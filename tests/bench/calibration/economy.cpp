// How many evaluations until a point is within 1 % of the optimum: demens side by side with NLopt's solvers
// and with a plain Latin hypercube and polynomial. Writes a table in Markdown.
//   economy AUGER_TABLE.csv [SEEDS] [[SOLVER] KIND OF SURROGATE...]
#include "tests/bench/calibration/test_functions.hpp"
#include "tests/bench/calibration/with_petsc.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include "tao_calib/design/latin_hypercube.hpp"
#include "tao_calib/surrogate/polynomial.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlopt.hpp>

namespace demens::bench {
namespace {

using Eigen::VectorXd;
using namespace tao_calib;

constexpr int most = 200; // evaluations; more count as not found

//! Counts evaluations until one is good enough.
class Counter
{
  public:
    Counter(TestFunction const& function, double enough) : function_(function), enough_(enough) {}
    double operator()(VectorXd const& unit)
    {
        ++evaluations_;
        double const distance = function_.distance(unit);
        if (distance <= enough_ && found_ == 0)
            found_ = evaluations_;
        return distance;
    }
    bool done() const { return found_ > 0 || evaluations_ >= most; }
    int result() const { return found_ > 0 ? found_ : most; }

  private:
    TestFunction const& function_;
    double enough_;
    int evaluations_ = 0, found_ = 0;
};

VectorXd random_point(int factors, RandomStream& random)
{
    VectorXd unit(factors);
    for (double& x : unit)
        x = random.uniform();
    return unit;
}

//! NLopt on the sum of squares from random starts, again and again.
int with_nlopt(nlopt::algorithm algorithm, TestFunction const& function, double enough, std::uint64_t seed)
{
    Counter counter(function, enough);
    RandomStream random(seed);
    nlopt::srand(seed);
    auto const call = [](std::vector<double> const& x, std::vector<double>&, void* pointer) {
        auto& count = *static_cast<Counter*>(pointer);
        if (count.done())
            throw nlopt::forced_stop();
        return std::pow(count(VectorXd::Map(x.data(), static_cast<Eigen::Index>(x.size()))), 2);
    };
    while (!counter.done()) {
        nlopt::opt optimiser(algorithm, static_cast<unsigned>(function.factors));
        optimiser.set_min_objective(call, &counter);
        optimiser.set_lower_bounds(0.0);
        optimiser.set_upper_bounds(1.0);
        optimiser.set_initial_step(0.25);
        optimiser.set_xtol_abs(1e-5);
        optimiser.set_maxeval(most);
        VectorXd const start = random_point(function.factors, random);
        std::vector<double> x(start.begin(), start.end());
        double value = 0;
        try {
            optimiser.optimize(x, value);
        } catch (std::exception const&) {
        }
    }
    return counter.result();
}

//! A Latin hypercube, one quadratic for each response, and a run at the predicted optimum: the smallest
//! design for which that run is good enough.
int with_polynomial(TestFunction const& function, double enough, std::uint64_t seed)
{
    int const k = function.factors;
    UnitCube const cube(std::vector<ensemble::Factor>(static_cast<std::size_t>(k), {"x", "x", 0.0, 1.0}), {});
    constexpr int largest = 60; // what more points do not improve is beyond a quadratic
    for (int n = Polynomial::terms(SurrogateKind::quadratic, k) + 1; n <= largest;
         n = std::max(n + 2, n * 5 / 4)) {
        Samples samples;
        samples.points = (maximin_latin_hypercube(n, k, derive_seed(seed, static_cast<std::uint64_t>(n)))
                              .cast<double>()
                              .array() +
                          0.5) /
                         n;
        samples.weights = VectorXd::Ones(n);
        std::vector<std::unique_ptr<Surrogate>> fits;
        for (int t = 0; t < function.size(); ++t) {
            samples.values.resize(n);
            for (int i = 0; i < n; ++i)
                samples.values[i] = function.responses(samples.points.row(i).transpose())[t];
            fits.push_back(fit_surrogate(tao_calib::SurrogateChoice::quadratic, samples));
        }
        LeastSquaresProblem const problem{k, function.size(), [&](VectorXd const& unit) {
                                              VectorXd values(function.size());
                                              for (int t = 0; t < function.size(); ++t)
                                                  values[t] = fits[static_cast<std::size_t>(t)]->value(unit);
                                              return VectorXd(
                                                  (values - function.targets).cwiseQuotient(function.scales));
                                          }};
        auto const minima =
            distinct_minima(pounders(), problem, cube, spread_points(cube, 10, {}, seed), 0.05);
        if (function.distance(minima.front().point) <= enough)
            return n + 1;
    }
    return most;
}

//! A campaign as a user would write it, all defaults but these.
int with_demens(std::string const& way, std::string const& surrogate, TestFunction const& function,
                double enough, std::uint64_t seed)
{
    static std::map<int, rig::RigInfo> rigs;
    std::vector<std::string> names;
    for (int t = 0; t < function.size(); ++t)
        names.push_back(fmt::format("y{}", t));
    auto const& rig = rigs.try_emplace(function.size(), response_names(names)).first->second;
    Counter counter(function, enough);
    StandIn stand_in(
        [&](std::vector<double> const& f, int) {
            VectorXd const unit = VectorXd::Map(f.data(), function.factors);
            counter(unit);
            VectorXd const values = function.responses(unit);
            return std::vector<double>(values.begin(), values.end());
        },
        std::vector<double>(static_cast<std::size_t>(function.size()), 0.0));
    auto& input = stand_in.campaign.input;
    input.seed = seed;
    for (int k = 0; k < function.factors; ++k)
        input.factors.push_back({fmt::format("x{}", k), fmt::format("x{}", k), 0.0, 1.0});
    ensemble::Experiment experiment;
    experiment.name = "bench";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    double const none = std::numeric_limits<double>::quiet_NaN();
    for (int t = 0; t < function.size(); ++t)
        experiment.targets.push_back(
            {names[static_cast<std::size_t>(t)], t, function.targets[t], function.scales[t], none, none});
    input.experiments = {experiment};
    // A way of choosing points, or a solver on the surrogates.
    if (auto const* search = find_word<ensemble::SearchKind>(way))
        input.search.kind = *search;
    else
        input.solver.kind = *find_word<ensemble::SolverKind>(way);
    if (!surrogate.empty())
        input.surrogate.kind = *find_word<ensemble::SurrogateChoice>(surrogate);
    input.stop.runs = most;
    input.stop.waves = 1000;
    input.stop.no_improvement_waves = 1000;
    auto const solver = surrogate_solver(input.solver.kind, *PetscEnvironment::session());
    while (!counter.done()) {
        Assessment const assessment(stand_in.campaign, *solver);
        auto const step = plan_next_wave(stand_in.campaign, assessment);
        if (step.kind != NextStep::Kind::simulate)
            break;
        stand_in.simulate(step);
    }
    return counter.result();
}

double median(std::vector<int> values)
{
    std::sort(values.begin(), values.end());
    auto const n = values.size();
    return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

using Method = std::function<int(TestFunction const&, double, std::uint64_t)>;

std::vector<std::pair<std::string, Method>> competitors()
{
    std::vector<std::pair<std::string, Method>> methods;
    for (auto const& [name, algorithm] :
         {std::pair("BOBYQA", nlopt::LN_BOBYQA), std::pair("COBYLA", nlopt::LN_COBYLA),
          std::pair("Nelder-Mead", nlopt::LN_NELDERMEAD), std::pair("Subplex", nlopt::LN_SBPLX),
          std::pair("PRAXIS", nlopt::LN_PRAXIS), std::pair("DIRECT-L", nlopt::GN_DIRECT_L),
          std::pair("CRS2", nlopt::GN_CRS2_LM)})
        methods.push_back({name, [algorithm](TestFunction const& f, double enough, std::uint64_t seed) {
                               return with_nlopt(algorithm, f, enough, seed);
                           }});
    methods.push_back({"LHS + quadratic", with_polynomial});
    return methods;
}

int main(std::vector<std::string> const& arguments)
{
    int const seeds = arguments.size() > 1 ? std::stoi(arguments[1]) : 11;
    auto methods = competitors();
    std::size_t const others = methods.size();
    std::vector<std::string> kinds(
        arguments.begin() + std::min<std::ptrdiff_t>(2, static_cast<std::ptrdiff_t>(arguments.size())),
        arguments.end());
    if (kinds.empty())
        kinds = {"pounders:"};
    for (auto const& kind : kinds) {
        auto const colon = kind.find(':');
        auto const solver = kind.substr(0, colon), surrogate = kind.substr(colon + 1);
        methods.push_back({"demens" + (kind == "pounders:" ? "" : " " + kind),
                           [=](TestFunction const& f, double enough, std::uint64_t seed) {
                               return with_demens(solver, surrogate, f, enough, seed);
                           }});
    }
    fmt::print("| function | factors | responses |");
    for (auto const& [name, method] : methods)
        fmt::print(" {} |", name);
    fmt::print(" demens / best other |\n|---|---|---|");
    for (std::size_t i = 0; i <= methods.size(); ++i)
        fmt::print("---|");
    fmt::print("\n");
    for (auto const& function : test_functions(arguments.at(0))) {
        double const enough = found_at(function);
        fmt::print("| {} | {} | {} |", function.name, function.factors, function.size());
        double best_other = most, ours = 0;
        for (std::size_t i = 0; i < methods.size(); ++i) {
            std::vector<int> counts;
            for (int seed = 1; seed <= seeds; ++seed)
                counts.push_back(methods[i].second(function, enough, static_cast<std::uint64_t>(seed)));
            double const middle = median(counts);
            if (i < others)
                best_other = std::min(best_other, middle);
            else if (i == others)
                ours = middle;
            fmt::print(" {} |", middle >= most ? fmt::format("> {}", most) : fmt::format("{:g}", middle));
            std::fflush(stdout);
        }
        fmt::print(" {:.2f} |\n", ours / best_other);
        std::fflush(stdout);
    }
    return 0;
}

} // namespace
} // namespace demens::bench

int main(int argc, char** argv)
{
    return demens::bench::with_petsc(argc, argv, [&] {
        return demens::bench::main({argv + 1, argv + argc});
    });
}
