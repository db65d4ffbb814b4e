#include "src/rig/one_grain.hpp"

#include "demens/base/error.hpp"
#include "demens/base/words.hpp"
#include "src/rig/option_specs.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig {
namespace {

enum class Stands
{
    as_given,
    at_random
};
constexpr std::array<Word<Stands>, 2> stands_words = {
    {{Stands::as_given, "as_given"}, {Stands::at_random, "random"}}};

} // namespace

OptionSpecs shape_options()
{
    return {entry("shape", "shape", "what the grain is; empty: a sphere"),
            choice("orientation", texts_of(stands_words),
                   "how it stands: as its [shape.NAME] is given, or any way, as the run's seed decides")};
}

OptionSpec turn_option()
{
    return vector("turn_deg", {},
                  "turned from as it is given, about the direction of this by its length, counter-clockwise "
                  "seen against it [deg]");
}

grain::GrainShape shape_of(RunInput const& input, OptionValues const& options)
{
    auto const& name = options.text("shape");
    if (name.empty() || name == "sphere")
        return {"sphere", nullptr, 1};
    auto const found = input.shapes.find(name);
    if (found == input.shapes.end())
        throw InputError(fmt::format("there is no [shape.{}]", name));
    if (found->second.is_hull())
        check_laws_of_hulls(input);
    return found->second;
}

double radius_of(grain::GrainShape const& shape, double size)
{
    return 0.5 * shape.equivalent_per_size * size;
}

bool stands_at_random(OptionValues const& options, grain::GrainShape const& shape)
{
    if (read_word(stands_words, options.text("orientation")) == Stands::as_given)
        return false;
    if (shape.is_sphere())
        throw InputError(
            "orientation says how a grain stands that has a shape, and this one is a sphere; give "
            "shape, or leave it out");
    return true;
}

Quaternion turned(grain::GrainShape const& shape, Quaternion const& from_as_given)
{
    return shape.is_sphere() ? Quaternion{} : (from_as_given * shape.shape->as_given).normalized();
}

Quaternion orientation_of(OptionValues const& options, grain::GrainShape const& shape, std::uint64_t seed)
{
    Vector3 const& turn = options.vector("turn_deg");
    bool const at_random = stands_at_random(options, shape), turns = norm(turn) > 0;
    if (shape.is_sphere() && turns)
        throw InputError("turn_deg turns a grain that has a shape, and this one is a sphere; give shape, or "
                         "leave it out");
    if (at_random && turns)
        throw InputError("turn_deg turns a grain from as it is given, and orientation = \"random\" says that "
                         "it stands any way; leave one of them out");
    if (at_random) {
        RandomStream random(seed);
        return shape::random_orientation(random);
    }
    return turned(shape, quaternion_about(std::numbers::pi / 180 * turn));
}

double reach_along(grain::BodyShape const* shape, double radius, Quaternion const& orientation,
                   Vector3 const& direction)
{
    return shape ? radius * shape->reach(orientation.inverse(direction)) : radius;
}

} // namespace demens::rig
