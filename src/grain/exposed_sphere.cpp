#include "src/grain/exposed_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::grain {
namespace {

using std::numbers::pi;

//! Gauss-Legendre's rule of ten points: the five nodes above 0 and their weights (Abramowitz & Stegun, 25.4).
constexpr std::array<std::pair<double, double>, 5> gauss = {{{0.1488743389816312, 0.2955242247147529},
                                                             {0.4333953941292472, 0.2692667193099963},
                                                             {0.6794095682990244, 0.2190863625159820},
                                                             {0.8650633666889845, 0.1494513491505806},
                                                             {0.9739065285171717, 0.0666713443086881}}};

//! Integrals over arcs of a circle of cos^a sin^b, for a + b <= 3, by a + b and a.
using ArcMoments = std::array<std::array<double, 4>, 4>;

//! Adds an arc, from one angle to another [rad].
void add_arc(ArcMoments& sums, double from, double to)
{
    double const s0 = std::sin(from), c0 = std::cos(from), s1 = std::sin(to), c1 = std::cos(to);
    auto const difference = [](double a, double b) { return b - a; };
    double const ds = s1 - s0, dc = c1 - c0;
    double const dsc = difference(s0 * c0, s1 * c1);
    double const ds2 = difference(s0 * s0, s1 * s1);
    double const ds3 = difference(s0 * s0 * s0, s1 * s1 * s1);
    double const dc3 = difference(c0 * c0 * c0, c1 * c1 * c1);
    sums[0][0] += to - from;
    sums[1][1] += ds;
    sums[1][0] -= dc;
    sums[2][2] += 0.5 * (to - from + dsc);
    sums[2][1] += 0.5 * ds2;
    sums[2][0] += 0.5 * (to - from - dsc);
    sums[3][3] += ds - ds3 / 3;
    sums[3][2] -= dc3 / 3;
    sums[3][1] += ds3 / 3;
    sums[3][0] += dc3 / 3 - dc;
}

//! What caps leave of circles of latitude.
class Latitudes
{
  public:
    explicit Latitudes(std::vector<Cap> const& caps)
    {
        for (Cap const& cap : caps)
            bands_.push_back({cap.axis.z, std::hypot(cap.axis.x, cap.axis.y), cap.level,
                              std::atan2(cap.axis.y, cap.axis.x)});
    }

    //! Per unit of height, at the height u = n_z.
    NormalMoments operator()(double u)
    {
        NormalMoments moments;
        double const radius = std::sqrt(std::max(0.0, 1 - u * u));
        if (!cover(u, radius))
            return moments;
        ArcMoments arcs{};
        double at = -pi;
        for (auto const& [from, to] : covered_) {
            if (from > at)
                add_arc(arcs, at, from);
            at = std::max(at, to);
        }
        if (pi > at)
            add_arc(arcs, at, pi);
        double scale = 1;
        for (int ab = 0; ab <= 3; ++ab, scale *= radius)
            for (int a = 0; a <= ab; ++a) {
                double height = scale * arcs[static_cast<std::size_t>(ab)][static_cast<std::size_t>(a)];
                for (int c = 0; c + ab <= 3; ++c, height *= u)
                    moments.at(a, ab - a, c) = height;
            }
        return moments;
    }

  private:
    struct Band
    {
        double along, across, level, azimuth; //!< parts of the axis; that of the cap; angle of the axis [rad]
    };

    //! Finds the covered arcs within -pi and pi, sorted; false where all of the circle is.
    bool cover(double u, double radius)
    {
        covered_.clear();
        for (Band const& band : bands_) {
            double const needed = band.level - u * band.along, reach = radius * band.across;
            if (needed >= reach)
                continue;
            if (needed <= -reach)
                return false;
            double const half = std::acos(needed / reach);
            double const from = band.azimuth - half, to = band.azimuth + half;
            covered_.emplace_back(std::max(from, -pi), std::min(to, pi));
            if (from < -pi)
                covered_.emplace_back(from + 2 * pi, pi);
            if (to > pi)
                covered_.emplace_back(-pi, to - 2 * pi);
        }
        std::sort(covered_.begin(), covered_.end());
        return true;
    }

    std::vector<Band> bands_;
    std::vector<std::pair<double, double>> covered_;
};

//! Whether the first cap lies within the second: their angle and the first's half angle are within the other.
bool lies_within(Cap const& a, Cap const& b)
{
    double const between = std::atan2(norm(cross(a.axis, b.axis)), dot(a.axis, b.axis));
    return between + std::acos(a.level) <= std::acos(b.level);
}

void drop_hidden(std::vector<Cap>& caps)
{
    std::vector<Cap> kept;
    std::stable_sort(caps.begin(), caps.end(), [](Cap const& a, Cap const& b) { return a.level < b.level; });
    for (Cap const& cap : caps)
        if (std::none_of(kept.begin(), kept.end(), [&](Cap const& k) { return lies_within(cap, k); }))
            kept.push_back(cap);
    caps = std::move(kept);
}

//! Heights where what is exposed changes its form: the ends of caps, and where the borders of two cross.
std::vector<double> breaks(std::vector<Cap> const& caps)
{
    std::vector<double> heights = {-1, 1};
    for (Cap const& cap : caps) {
        double const polar = std::acos(std::clamp(cap.axis.z, -1.0, 1.0)), half = std::acos(cap.level);
        heights.push_back(std::cos(polar - half));
        heights.push_back(std::cos(polar + half));
    }
    constexpr double little = 1e-12; // a crossing on the border of a third cap stays a break
    auto const is_exposed = [&](Vector3 const& n) {
        return std::none_of(caps.begin(), caps.end(),
                            [&](Cap const& cap) { return dot(n, cap.axis) > cap.level + little; });
    };
    for (std::size_t i = 0; i < caps.size(); ++i)
        for (std::size_t j = i + 1; j < caps.size(); ++j) {
            Vector3 const across = cross(caps[i].axis, caps[j].axis);
            double const sine2 = norm_squared(across), cosine = dot(caps[i].axis, caps[j].axis);
            if (sine2 < 1e-28)
                continue; // concentric circles
            Vector3 const middle = ((caps[i].level - cosine * caps[j].level) / sine2) * caps[i].axis +
                                   ((caps[j].level - cosine * caps[i].level) / sine2) * caps[j].axis;
            double const rest = 1 - norm_squared(middle);
            if (rest < 0)
                continue;
            Vector3 const offset = std::sqrt(rest / sine2) * across;
            for (Vector3 const& n : {middle + offset, middle - offset})
                if (is_exposed(n))
                    heights.push_back(std::clamp(n.z, -1.0, 1.0));
        }
    std::sort(heights.begin(), heights.end());
    return heights;
}

//! Integrates over an interval of heights, which is halved until halves and whole agree.
class HeightIntegral
{
  public:
    explicit HeightIntegral(std::vector<Cap> const& caps) : latitudes_(caps) {}

    void add(double from, double to)
    {
        from_ = from;
        width_ = to - from;
        refine(0, 1, rule(0, 1), 0);
    }
    NormalMoments total;

  private:
    static constexpr int deepest = 24;
    static constexpr double tolerance = 1e-11; // of the sphere's 4 pi: absolute

    //! Gauss' rule between two values of t, with heights u(t) = from + width (3 t^2 - 2 t^3): roots of the
    //! distance from an end, as an arc has where a cap begins, become smooth.
    NormalMoments rule(double from, double to)
    {
        NormalMoments sum;
        double const middle = 0.5 * (from + to), half = 0.5 * (to - from);
        for (auto const& [node, weight] : gauss)
            for (double const t : {middle - half * node, middle + half * node}) {
                NormalMoments const here = latitudes_(from_ + width_ * t * t * (3 - 2 * t));
                double const factor = weight * half * width_ * 6 * t * (1 - t);
                for (std::size_t k = 0; k < sum.values.size(); ++k)
                    sum.values[k] += factor * here.values[k];
            }
        return sum;
    }
    void refine(double from, double to, NormalMoments const& whole, int depth)
    {
        double const middle = 0.5 * (from + to);
        NormalMoments const left = rule(from, middle), right = rule(middle, to);
        double error = 0;
        for (std::size_t k = 0; k < whole.values.size(); ++k)
            error = std::max(error, std::abs(left.values[k] + right.values[k] - whole.values[k]));
        if (error <= tolerance * (to - from) || depth == deepest) {
            for (std::size_t k = 0; k < whole.values.size(); ++k)
                total.values[k] += left.values[k] + right.values[k];
            return;
        }
        refine(from, middle, left, depth + 1);
        refine(middle, to, right, depth + 1);
    }

    Latitudes latitudes_;
    double from_ = 0, width_ = 0;
};

} // namespace

NormalMoments exposed_moments(std::vector<Cap> caps)
{
    drop_hidden(caps);
    std::vector<double> const heights = breaks(caps);
    HeightIntegral integral(caps);
    for (std::size_t k = 0; k + 1 < heights.size(); ++k)
        if (heights[k + 1] > heights[k])
            integral.add(heights[k], heights[k + 1]);
    return integral.total;
}

} // namespace demens::grain
