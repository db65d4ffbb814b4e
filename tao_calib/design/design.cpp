#include "tao_calib/design/design.hpp"

#include "demens/base/error.hpp"
#include "tao_calib/design/latin_hypercube.hpp"

#include <fmt/format.h>
#include <map>

namespace demens::tao_calib {
namespace {

using ensemble::DesignOptions;

//! Enough for a full quadratic and two checks.
int default_points(int factors) { return (factors + 1) * (factors + 2) / 2 + 2; }

int points_of(DesignOptions const& options, int factors)
{
    return options.points > 0 ? options.points : default_points(factors);
}

Design latin_hypercube(DesignOptions const& options, FactorSpace const& space, std::uint64_t seed)
{
    int const points = points_of(options, space.size());
    if (!space.constrained()) {
        Eigen::MatrixXi const places = maximin_latin_hypercube(points, space.size(), seed);
        return {space.own_units_of_rows((places.cast<double>().array() + 0.5) / points), {}};
    }
    auto const chosen = constrained_latin_hypercube(space, points, seed);
    Design design{space.own_units_of_rows(chosen.unit), {}};
    if (chosen.empty_strata > 0)
        design.notes.push_back(fmt::format("the constraints leave {} of {} strata of the Latin hypercube without "
                                           "a point",
                                           chosen.empty_strata, points * space.size()));
    return design;
}

using Maker = Design (*)(DesignOptions const&, FactorSpace const&, std::uint64_t);
std::map<std::string, Maker> const makers = {
    {"latin_hypercube", latin_hypercube},
};

} // namespace

Design plan_design(DesignOptions const& options, std::vector<ensemble::Factor> const& factors,
                   std::vector<ensemble::LinearConstraint> const& constraints, std::uint64_t seed)
{
    auto const maker = makers.find(options.kind);
    if (maker == makers.end()) {
        std::string known;
        for (auto const& [kind, unused] : makers)
            known += (known.empty() ? "" : ", ") + kind;
        throw InputError(fmt::format("[design] kind = \"{}\" is not known; known are {}", options.kind, known));
    }
    return maker->second(options, FactorSpace(factors, constraints), seed);
}

Eigen::MatrixXd make_design(DesignOptions const& options, std::vector<ensemble::Factor> const& factors,
                            std::vector<ensemble::LinearConstraint> const& constraints, std::uint64_t seed)
{
    return plan_design(options, factors, constraints, seed).points;
}

} // namespace demens::tao_calib
