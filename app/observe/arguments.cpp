#include "app/observe/arguments.hpp"

#include "demens/base/text/number.hpp"

#include <array>
#include <fmt/format.h>

namespace demens::cli {
namespace {

constexpr std::array<Word<Take>, 3> take_words = {
    {{Take::usual, "usual"}, {Take::each, "each"}, {Take::mean, "mean"}}};
constexpr std::array<Word<std::size_t>, 3> axis_words = {{{0, "x"}, {1, "y"}, {2, "z"}}};

//! A length's unit by its word.
struct LengthUnit
{
    char const* text;
    double metres;
};
constexpr std::array<LengthUnit, 4> length_units = {{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}}};

[[noreturn]] void refuse(std::string const& option, std::string const& value, std::string const& right)
{
    throw InputError(fmt::format("{} {}: {}", option, value, right));
}

std::array<double, 3> three_numbers(std::string const& option, std::string const& text,
                                    std::string const& right)
{
    std::array<double, 3> numbers{};
    std::size_t from = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        std::size_t const end = k < 2 ? text.find(',', from) : text.size();
        auto const number = end == std::string::npos
                                ? std::nullopt
                                : text::number_of(std::string_view(text).substr(from, end - from));
        if (!number)
            refuse(option, text, right);
        numbers[k] = *number, from = end + 1;
    }
    return numbers;
}

double number_between(std::string const& option, double value, double from, double to,
                      std::string const& what)
{
    if (!(value >= from && value <= to))
        refuse(option, fmt::format("{:.6g}", value),
               fmt::format("{}; from {:.4g} to {:.4g}", what, from, to));
    return value;
}

std::optional<double> threshold_of(std::string const& text)
{
    if (text == "auto")
        return std::nullopt;
    auto const number = text::number_of(text);
    if (!number || *number < 0 || *number >= 255)
        refuse("--threshold", text,
               "give auto, or the darkness of the cut, which is 255 less grey, from 0 to less than 255");
    return *number / 255;
}

double unit_of(std::string const& text)
{
    for (auto const& unit : length_units)
        if (text == unit.text)
            return unit.metres;
    refuse("--frames-unit", text, "one of m, cm, mm, um");
}

template <class Enum, std::size_t count>
Enum word_of(std::string const& option, std::array<Word<Enum>, count> const& words, std::string const& text)
{
    try {
        return read_word(words, text);
    } catch (InputError const& error) {
        throw InputError(option + ": " + error.what());
    }
}

observe::Rotation rotation_of(std::string const& option, std::string const& text)
{
    auto const* rotation = find_word<observe::Rotation>(text);
    if (!rotation)
        refuse(option, text, "give clockwise or counterclockwise, as the camera sees the drum turn");
    return *rotation;
}

} // namespace

ObserveArguments::ObserveArguments(ObserveText const& text)
    : files(text.files), references(text.references),
      radius(1e-3 * number_between("--radius-mm", text.radius_mm, 1e-3, 1e6, "the drum's inner radius")),
      turned_deg(number_between("--turned-deg", text.turned_deg, -180, 180, "an angle")),
      rotation(rotation_of("--rotation", text.rotation)),
      frames_rotation(rotation_of("--frames-rotation", text.frames_rotation)),
      occupancy(number_between("--occupancy", text.occupancy, 0, 0.999, "a share of the frames")),
      unit(unit_of(text.frames_unit)),
      pixels(
          static_cast<int>(number_between("--pixels", text.pixels, 40, 20000, "pixels along the diameter"))),
      take(word_of("--take", take_words, text.take)), format(text.csv       ? ObserveFormat::csv
                                                             : text.json    ? ObserveFormat::json
                                                             : text.targets ? ObserveFormat::targets
                                                                            : ObserveFormat::text),
      folder(text.folder)
{
    if (!text.circle_px.empty()) {
        auto const [x, y, r] = three_numbers("--circle-px", text.circle_px,
                                             "give X,Y,R in pixels from the picture's upper left corner");
        circle = observe::Circle{x, y, r};
    }
    auto const& bed = text.bed;
    if (bed.closing < 1 || bed.closing % 2 == 0 || bed.closing > 101)
        refuse("--closing", fmt::format("{}", bed.closing), "an odd number of pixels from 1, none, to 101");
    number_between("--inside-radius", bed.inside_radius, 0.01, 1, "a share of the radius");
    number_between("--segments", bed.segments, 1, 10000, "a number of segments");
    number_between("--rim", bed.rim, 0, 0.5, "a share of the radius");
    photograph = {.threshold = threshold_of(text.threshold), .trust_circle = text.trust_circle, .bed = bed};

    auto const along = word_of("--axis", axis_words, text.axis), up = word_of("--up", axis_words, text.up);
    if (along == up)
        refuse("--up", text.up, "cannot be the drum's axis, too");
    axis[0] = 3 - along - up, axis[1] = along, axis[2] = up;
    sense = (along + 1) % 3 == up ? 1 : -1; // right = axis x up: the camera looks along the axis
    auto const [x, y, z] =
        three_numbers("--centre-mm", text.centre_mm, "give X,Y,Z of a point of the drum's axis");
    centre = {1e-3 * x, 1e-3 * y, 1e-3 * z};
}

void add_options(CLI::App& command, ObserveText& text)
{
    command.add_option("FILE", text.files, "photographs (PNG, JPEG, BMP), or frames: dumps, VTK, CSV")
        ->required();
    command.add_option("--radius-mm", text.radius_mm, "inner radius of the drum [mm]")->required();
    command.add_option("--reference", text.references, "photographs or frames to compare with; their mean");
    command.add_option(
        "--circle-px", text.circle_px,
        "X,Y,R of the drum's inner circle in the photographs, from the upper left corner; none: the "
        "largest that a picture holds");
    command.add_flag("--trust-circle", text.trust_circle, "even if the picture shows another rim");
    command.add_option(
        "--threshold", text.threshold,
        "darkness of 255 (255 less grey) above which a photograph shows grains; auto (default): "
        "midway between bed and light at each place");
    command.add_option(
        "--rotation", text.rotation,
        "how the camera sees the drum turn: counterclockwise (default; the bed climbs on the right) "
        "or clockwise");
    command.add_option("--turned-deg", text.turned_deg, "turn photographs counterclockwise first [deg]");
    command.add_option("--closing", text.bed.closing, "pixels of the mask's closing; 1: none; default 7");
    command.add_option("--inside-radius", text.bed.inside_radius,
                       "share of the radius within which areas are compared; default sqrt(0.6)");
    command.add_option("--segments", text.bed.segments, "of the diameter, for the profile; default 20");
    command.add_option("--rim", text.bed.rim, "outermost share of the radius not looked at; default 0.04");
    command.add_option(
        "--take", text.take,
        "each file or frame by itself, or their mean; usual (default): each photograph, the mean of "
        "the frames");
    command.add_option("--occupancy", text.occupancy,
                       "share of the frames that must cover a pixel for grains to be there; default 0.5");
    command.add_option("--axis", text.axis, "the drum's axis in frames, along which one looks; default y");
    command.add_option("--up", text.up, "up in frames; default z");
    command.add_option("--centre-mm", text.centre_mm,
                       "X,Y,Z of a point of the drum's axis in frames; default 0,0,0");
    command.add_option("--frames-unit", text.frames_unit, "of lengths in frames that carry none; default m");
    command.add_option(
        "--frames-rotation", text.frames_rotation,
        "how the drum of the frames turns, seen along its axis; default counterclockwise; mirrored "
        "where --rotation is the other");
    command.add_option("--pixels", text.pixels,
                       "along the diameter, where no photograph says it; default 400");
    command.add_option("--write", text.folder, "folder for masks, profiles and overlays");
    auto* csv = command.add_flag("--csv", text.csv, "print a table, a row a picture, with all digits");
    auto* json = command.add_flag("--json", text.json, "print a JSON document, with all digits");
    auto* targets =
        command.add_flag("--targets", text.targets, "print lines for a campaign, with the scatter");
    json->excludes(csv);
    targets->excludes(csv)->excludes(json);
}

} // namespace demens::cli
