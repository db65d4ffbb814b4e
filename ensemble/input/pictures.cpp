#include "ensemble/input/pictures.hpp"

#include "demens/base/text/number.hpp"
#include "demens/picture_file/picture_file.hpp"
#include "demens/rig/programme/programme.hpp"
#include "ensemble/input/input_options.hpp"

#include <cmath>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

constexpr char const *keeps_picture = "keep_picture",
                     *raster = "image_pixels"; // keys of rigs that have a picture

//! What a darkness is said as; none: `auto`.
std::optional<double> threshold_of(InputTable const& table, OptionValues const& given)
{
    auto const& text = given.text("threshold");
    if (text == "auto")
        return {};
    auto const number = text::number_of(text);
    if (!number || !(*number > 0 && *number < 255))
        throw table.error("threshold", "must be \"auto\" or a darkness between 0 and 255, such as \"30\"");
    return *number / 255;
}

std::vector<std::string> file_names(InputTable const& table, OptionValues const& given)
{
    auto files = table.words("files");
    if (files.empty() == given.text("file").empty())
        throw table.error(
            "give either file = \"PICTURE.png\" or files = [\"...\", ...], of which the mean is taken");
    if (files.empty())
        files.push_back(given.text("file"));
    return files;
}

//! The frame of a photograph of a drum of that radius [m].
observe::PictureFrame frame_of(InputTable const& table, PictureTarget const& target,
                               observe::GreyImage const& image, double radius)
{
    auto const& c = target.circle;
    if (!c.empty() && c.size() != 3)
        throw table.error(
            "circle_px",
            "must be three numbers: x and y of the drum's axis, from the upper left corner, and the "
            "radius of its inner circle");
    return {.columns = image.columns,
            .rows = image.rows,
            .circle = c.empty() ? observe::largest_circle(image.columns, image.rows)
                                : observe::Circle{c[0], c[1], c[2]},
            .radius = radius,
            .rotation = *find_word<observe::Rotation>(target.given.text("rotation"))};
}

//! Standard deviation between the photographs of the height of a segment [m]; 0: fewer than three.
double scatter_of(std::vector<observe::BedPicture> const& beds, std::size_t segment)
{
    double sum = 0, squares = 0, count = 0;
    for (auto const& bed : beds)
        if (double const z = bed.profile.z[segment]; !std::isnan(z)) {
            sum += z;
            squares += z * z;
            ++count;
        }
    return count < 3 ? 0 : std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1) / count);
}

} // namespace

std::vector<std::string> read_picture_target(InputTable const& table, InputTable const& experiment_table,
                                             FileSource const& source, BaseInput& base,
                                             Experiment& experiment)
{
    auto& rig_values = base.experiments.back();
    if (!rig_values.has(keeps_picture))
        throw table.error(fmt::format("the rig {} makes no picture; a rotating drum does: rig = \"drum\"",
                                      experiment.rig->name));
    rig_values.set(keeps_picture, true);
    PictureTarget target;
    target.given = table.read(picture_options(), keys_of(picture_lists()));
    target.circle = table.numbers("circle_px");
    target.files = file_names(table, target.given);
    target.simulated_cut = target.given.number("simulated_cut");
    target.reading = {.closing = static_cast<int>(target.given.integer("closing_px")),
                      .segments = static_cast<int>(target.given.integer("segments")),
                      .inside_radius = target.given.number("inside_radius")};
    if (target.reading.closing % 2 == 0)
        throw table.error("closing_px", "must be odd, so that the closing has a middle");
    auto const picture_of_rig = [&] {
        return experiment.rig
            ->describe(make_run_input(base, {}, static_cast<int>(base.experiments.size()) - 1, 1))
            .picture;
    };
    //! What is wrong with a photograph is said beside its key.
    auto const of_files = [&](auto const& read) {
        try {
            return read();
        } catch (InputError const& error) {
            throw table.error(table.has("files") ? "files" : "file", error.what());
        }
    };
    std::vector<observe::GreyImage> images;
    auto const mean = of_files([&] {
        for (auto const& file : target.files) {
            if (!base.files.count(file))
                base.files.emplace(file, std::make_shared<std::string const>(source(file)));
            images.push_back(picture_file::read_picture(*base.files.at(file), file));
        }
        return mean_of(images);
    });
    target.frame = frame_of(table, target, mean, picture_of_rig()->radius);
    observe::PhotographReading const reading{.threshold = threshold_of(table, target.given),
                                             .trust_circle = target.given.flag("trust_circle"),
                                             .bed = target.reading};
    auto const bed_of = [&](observe::GreyImage const& image) {
        return of_files([&] { return read_photograph(image, target.frame, reading).bed; });
    };
    target.bed = bed_of(mean);
    std::vector<observe::BedPicture> beds;
    for (auto const& image : images)
        if (images.size() > 2)
            beds.push_back(bed_of(image));
    if (!experiment_table.has(raster)) // as fine as the photograph
        rig_values.set(raster, std::int64_t{2} * std::llround(target.frame.circle.radius));
    target.simulated = *picture_of_rig();

    auto const& profile = target.bed.profile;
    for (std::size_t k = 0; k < profile.x.size(); ++k)
        if (!std::isnan(profile.z[k]) &&
            std::hypot(profile.x[k], profile.z[k]) < target.reading.inside_radius * target.frame.radius)
            target.segments.push_back(k);
    if (target.segments.empty())
        throw table.error("no segment of the photograph has a surface inside inside_radius; take fewer "
                          "segments or a larger radius");
    auto const responses = responses_of(target);
    auto const first = experiment.responses.size();
    double const scale =
        target.given.number("scale_mm") * std::sqrt(static_cast<double>(target.segments.size()));
    double const half_pixel = 0.5e3 * target.frame.pixel_size(), said = target.given.number("sd_mm");
    for (std::size_t s = 0; s < target.segments.size(); ++s) {
        double const seen = 1e3 * scatter_of(beds, target.segments[s]);
        // All segments together count as one target.
        experiment.targets.push_back({.response = responses[picture_numbers + s].name,
                                      .response_index = static_cast<int>(first + picture_numbers + s),
                                      .value = 1e3 * profile.z[target.segments[s]],
                                      .scale = scale,
                                      .sd = std::isnan(said) ? std::max(half_pixel, seen) : said,
                                      .tolerance = target.given.number("tolerance_mm"),
                                      .comes_of = TargetSource::picture});
    }
    experiment.responses.insert(experiment.responses.end(), responses.begin(), responses.end());
    auto const said_of =
        fmt::format("experiment.{}: target.picture: the bed covers {:.4g} % of the drum and climbs at {:.4g} "
                    "deg (r2 {:.4g}); {} of {} segments are "
                    "compared, and the rig's picture has {} pixels across",
                    experiment.name, 100 * target.bed.fill, target.bed.angle_deg, target.bed.straightness,
                    target.segments.size(), profile.x.size(), target.simulated.columns);
    experiment.picture = std::move(target);
    return {said_of};
}

} // namespace demens::ensemble::input
