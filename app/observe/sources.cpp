// Files become pictures, and pictures are read.
#include "app/observe/sources.hpp"

#include "demens/observe/frame_file.hpp"
#include "demens/observe/picture/occupancy.hpp"
#include "demens/picture_file/picture_file.hpp"

#include <fmt/format.h>

namespace demens::cli {
namespace {

using observe::GreyImage;
using observe::PictureFrame;

//! A picture that is still to be read.
struct Source
{
    enum class Kind
    {
        photograph,
        frames
    } kind;
    std::string name;
    GreyImage picture;
};

//! Says which file an error is about.
template <class Action>
auto about(std::string const& name, Action const& action)
{
    try {
        return action();
    } catch (InputError const& error) {
        std::string const what = error.what();
        throw InputError(what.rfind(name, 0) == 0 ? what : name + ": " + what);
    }
}

bool is_photograph(std::string const& file)
{
    if (picture_file::is_picture_file(file))
        return true;
    if (!observe::is_frame_file(file))
        throw InputError(
            fmt::format("{}: its name tells no kind of file that is read; photographs end in .png, .jpg, "
                        ".jpeg or .bmp, frames in .dump, .lammpstrj, .liggghts, .txt, .vtk, .vtp, .vtu, "
                        ".pvd, .csv or a number",
                        file));
    return false;
}

//! Spheres as the rig has them: the drum's axis is y, z is up, the bed climbs towards +x.
std::vector<dem::Place> in_rig_frame(observe::SphereFrame const& frame, ObserveArguments const& arguments)
{
    double const mirrored = arguments.frames_rotation == observe::Rotation::clockwise ? -1 : 1;
    std::array<double, 3> const middle = {arguments.centre.x, arguments.centre.y, arguments.centre.z};
    std::vector<dem::Place> places;
    std::size_t inside = 0;
    double furthest = 0; // from the axis [m]
    for (auto const& sphere : frame.spheres) {
        std::array<double, 3> const at = {sphere.x - middle[0], sphere.y - middle[1], sphere.z - middle[2]};
        auto const& [right, along, up] = arguments.axis;
        places.push_back({mirrored * arguments.sense * at[right], at[along], at[up], sphere.radius});
        auto const& p = places.back();
        double const from_axis = std::hypot(p.x, p.z);
        inside += from_axis < arguments.radius && p.radius < arguments.radius ? 1 : 0;
        furthest = std::max(furthest, from_axis + p.radius);
    }
    // A bed rests on the drum: most spheres are inside, and some are near its wall.
    if (2 * inside <= places.size() || furthest < 0.5 * arguments.radius)
        throw InputError(fmt::format(
            "{}: of {} spheres {} lie in the drum of {:.6g} mm about ({:.6g}, {:.6g}, {:.6g}) mm, and the "
            "furthest reaches {:.4g} mm from its axis: this is no bed in it; look at --radius-mm, "
            "--frames-unit, --centre-mm and --axis",
            frame.origin, places.size(), inside, 1e3 * arguments.radius, 1e3 * middle[0], 1e3 * middle[1],
            1e3 * middle[2], 1e3 * furthest));
    return places;
}

Source mean_source(Source::Kind kind, std::vector<std::string> const& files, GreyImage picture)
{
    return {kind, files.size() == 1 ? files.front() : fmt::format("mean of {} files", files.size()),
            std::move(picture)};
}

std::vector<Source> photographs(std::vector<std::string> const& files, bool mean)
{
    std::vector<Source> sources;
    std::vector<GreyImage> images;
    for (auto const& file : files) {
        images.push_back(picture_file::read_picture(file));
        if (!mean)
            sources.push_back({Source::Kind::photograph, file, std::move(images.back())});
    }
    if (mean && !files.empty())
        sources.push_back(mean_source(Source::Kind::photograph, files, observe::mean_of(images)));
    return sources;
}

std::vector<Source> simulated(std::vector<std::string> const& files, bool mean, PictureFrame const& raster,
                              ObserveArguments const& arguments)
{
    std::vector<Source> sources;
    observe::Occupancy all(raster);
    for (auto const& file : files)
        for (auto const& frame : observe::read_frames(file, arguments.unit)) {
            auto const places = in_rig_frame(frame, arguments);
            all.add(places);
            if (!mean) {
                observe::Occupancy one(raster);
                one.add(places);
                sources.push_back({Source::Kind::frames, frame.origin, one.mean()});
            }
        }
    if (mean && !files.empty())
        sources.push_back(mean_source(Source::Kind::frames, files, all.mean()));
    return sources;
}

//! Photographs first: frames are drawn on their raster.
struct Files
{
    explicit Files(std::vector<std::string> const& names)
    {
        for (auto const& name : names)
            (is_photograph(name) ? photographs : frames).push_back(name);
    }
    std::vector<std::string> photographs, frames;
};

PictureFrame frame_for(GreyImage const& picture, ObserveArguments const& arguments)
{
    return {.columns = picture.columns,
            .rows = picture.rows,
            .circle = arguments.circle.value_or(observe::largest_circle(picture.columns, picture.rows)),
            .radius = arguments.radius,
            .rotation = arguments.rotation};
}

Observed read(Source source, ObserveArguments const& arguments)
{
    auto const frame = frame_for(source.picture, arguments);
    return about(source.name, [&]() -> Observed {
        if (source.kind == Source::Kind::frames) {
            auto cut = observe::cut_through(source.picture, arguments.occupancy);
            auto bed = observe::read_bed(cut, frame, arguments.photograph.bed);
            observe::require_climb(bed, frame.rotation);
            return {source.name, std::move(source.picture), frame, std::move(cut), std::move(bed), 1};
        }
        auto picture = arguments.turned_deg == 0
                           ? std::move(source.picture)
                           : observe::turned(source.picture, frame.circle, arguments.turned_deg);
        auto [cut, bed, smoothing] = observe::read_photograph(picture, frame, arguments.photograph);
        return {source.name, std::move(picture), frame, std::move(cut), std::move(bed), smoothing};
    });
}

} // namespace

Observations observe_files(ObserveArguments const& arguments)
{
    Files const files(arguments.files), references(arguments.references);
    if (!references.photographs.empty() && !references.frames.empty())
        throw InputError("--reference: photographs and frames have no mean; give files of one kind");
    auto sources = photographs(files.photographs, arguments.take == Take::mean);
    auto reference = photographs(references.photographs, true);
    auto raster = observe::square_frame(arguments.radius, arguments.pixels);
    raster.rotation = arguments.rotation;
    if (!sources.empty() || !reference.empty())
        raster = frame_for((sources.empty() ? reference : sources).front().picture, arguments);
    else if (arguments.circle)
        throw InputError("--circle-px: there is no photograph that it could be the circle of; leave it out");
    observe::require_whole(raster.circle, raster.columns, raster.rows);
    for (auto& source : simulated(files.frames, arguments.take != Take::each, raster, arguments))
        sources.push_back(std::move(source));
    for (auto& source : simulated(references.frames, true, raster, arguments))
        reference.push_back(std::move(source));

    Observations observations;
    for (auto& source : sources)
        observations.pictures.push_back(read(std::move(source), arguments));
    if (!reference.empty())
        observations.reference = read(std::move(reference.front()), arguments);
    return observations;
}

} // namespace demens::cli
