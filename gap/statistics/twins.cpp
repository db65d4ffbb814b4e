#include "gap/statistics/twins.hpp"

#include "gap/statistics/floor.hpp"
#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/refit.hpp"

#include <cmath>

namespace demens::gap {
namespace {

//! What a stream of random numbers is for.
enum class Draw : std::uint64_t
{
    noise,
    factors,
    form,
    amplitude
};

RandomStream stream(std::uint64_t seed, std::uint64_t twin, Draw draw)
{
    return RandomStream(derive_seed(derive_seed(seed, twin), static_cast<std::uint64_t>(draw)));
}

} // namespace

Twins::Twins(Evidence const& evidence, Eigen::MatrixXd const& floor, std::uint64_t seed)
    : evidence_(evidence), floor_root_(square_root(floor)), prior_root_(square_root(evidence.nuisance_prior)),
      form_root_(square_root(form_correlation(evidence.cells, evidence.cells, evidence.correlation_length))),
      seed_(seed)
{
}

Eigen::VectorXd Twins::base(std::uint64_t twin) const
{
    return with({}, {}, twin);
}

Eigen::VectorXd Twins::with(std::vector<Signature> const& effects, Eigen::VectorXd const& amplitudes,
                            std::uint64_t twin) const
{
    auto noise = stream(seed_, twin, Draw::noise), factors = stream(seed_, twin, Draw::factors),
         form = stream(seed_, twin, Draw::form);
    auto const n = evidence_.size();
    Eigen::VectorXd const d = prior_root_ * standard_normals(evidence_.factors(), factors);
    Eigen::VectorXd sum =
        floor_root_ * standard_normals(n, noise) + change(evidence_, effects, amplitudes, d);
    for (std::size_t k = 0; k < effects.size(); ++k) {
        auto const& effect = effects[k];
        Eigen::VectorXd off =
            effect.form_error * effect.first.cwiseProduct(form_root_ * standard_normals(n, form));
        if (effect.first_variance.size() > 0)
            off += effect.first_variance.cwiseSqrt().cwiseProduct(standard_normals(n, form));
        sum += amplitudes[static_cast<int>(k)] * off;
    }
    return sum;
}

Eigen::VectorXd Twins::unknown(double strength, std::uint64_t twin) const
{
    auto form = stream(seed_, twin, Draw::form);
    Eigen::VectorXd const shape = form_root_ * standard_normals(evidence_.size(), form);
    return base(twin) + strength * scales(evidence_.cells).cwiseProduct(shape);
}

double Twins::amplitude(Signature const& effect, std::uint64_t twin) const
{
    auto random = stream(seed_, twin, Draw::amplitude);
    double const u = standard_normal(random);
    switch (effect.sign) {
    case Sign::positive:
        return effect.typical * std::abs(u);
    case Sign::negative:
        return -effect.typical * std::abs(u);
    case Sign::either:
        break;
    }
    return effect.typical * u;
}

} // namespace demens::gap
