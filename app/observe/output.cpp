// What is printed: responses and profiles as a table, CSV, JSON or targets.
#include "app/observe/output.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <numeric>

namespace demens::cli {
namespace {

using Json = nlohmann::ordered_json;

//! A number read off a picture. Those of the rig `drum` have the names of its responses.
struct Response
{
    std::string name;
    bool is_of_rig;
    std::vector<double> values; //!< [pictures]
};

std::vector<Response> responses_of(Observations const& observations, ObserveArguments const& arguments)
{
    std::vector<Response> responses = {
        {"area_percent", true, {}}, {"angle_of_repose_deg", true, {}}, {"r2", true, {}}};
    if (observations.reference)
        responses.push_back({"mismatch_mm2", false, {}});
    for (auto const& observed : observations.pictures) {
        auto const& bed = observed.bed;
        responses[0].values.push_back(100 * bed.fill);
        responses[1].values.push_back(bed.angle_deg);
        responses[2].values.push_back(bed.straightness);
        if (observations.reference)
            responses[3].values.push_back(
                1e6 * observe::area_mismatch(bed.mask, observations.reference->bed.mask, observed.frame,
                                             arguments.photograph.bed.inside_radius));
    }
    return responses;
}

struct Scatter
{
    double mean, sd; //!< NaN with fewer than two values
};

Scatter scatter_of(std::vector<double> const& values)
{
    double const n = static_cast<double>(values.size()),
                 mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (double const value : values)
        squares += (value - mean) * (value - mean);
    return {mean, values.size() < 2 ? std::nan("") : std::sqrt(squares / (n - 1))};
}

//! Heights of all pictures over each segment, those without a surface left out.
std::vector<std::vector<double>> heights_of(Observations const& observations)
{
    std::vector<std::vector<double>> heights(observations.pictures.front().bed.profile.x.size());
    for (auto const& observed : observations.pictures)
        for (std::size_t k = 0; k < heights.size(); ++k)
            if (double const z = observed.bed.profile.z[k]; !std::isnan(z))
                heights[k].push_back(1e3 * z);
    return heights;
}

std::string text_of(double value)
{
    return std::isnan(value) ? "-" : fmt::format("{:.5g}", value);
}

std::string as_text(Observations const& observations, std::vector<Response> const& responses)
{
    auto const& pictures = observations.pictures;
    std::size_t width = std::string("standard deviation").size(); // of the names
    for (auto const& observed : pictures)
        width = std::max(width, observed.name.size());
    std::string out = fmt::format("{:<{}}", "", width);
    for (auto const& response : responses)
        out += fmt::format(" {:>20}", response.name);
    out += fmt::format(" {:>14}\n", "cut, of 255");
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        out += fmt::format("{:<{}}", pictures[k].name, width);
        for (auto const& response : responses)
            out += fmt::format(" {:>20}", text_of(response.values[k]));
        out += fmt::format(" {:>14}\n", text_of(255 * pictures[k].cut.level));
    }
    if (pictures.size() > 1)
        for (bool const is_mean : {true, false}) {
            out += fmt::format("{:<{}}", is_mean ? "mean" : "standard deviation", width);
            for (auto const& response : responses) {
                auto const scatter = scatter_of(response.values);
                out += fmt::format(" {:>20}", text_of(is_mean ? scatter.mean : scatter.sd));
            }
            out += '\n';
        }
    out += fmt::format("\n{:>10} {:>12} {:>12}   from the drum's axis; -: no surface there\n", "x_mm",
                       "height_mm", pictures.size() > 1 ? "sd_mm" : "");
    auto const heights = heights_of(observations);
    for (std::size_t k = 0; k < heights.size(); ++k) {
        auto const scatter =
            heights[k].empty() ? Scatter{std::nan(""), std::nan("")} : scatter_of(heights[k]);
        out += fmt::format("{:>10.3f} {:>12} {:>12}\n", 1e3 * pictures.front().bed.profile.x[k],
                           std::isnan(scatter.mean) ? "-" : fmt::format("{:.3f}", scatter.mean),
                           std::isnan(scatter.sd) ? "" : fmt::format("{:.3f}", scatter.sd));
    }
    return out;
}

std::string as_csv(Observations const& observations, std::vector<Response> const& responses)
{
    std::string out = "picture";
    for (auto const& response : responses)
        out += "," + response.name;
    out += ",cut_darkness";
    for (double const x : observations.pictures.front().bed.profile.x)
        out += fmt::format(",height_mm at {:.4f} mm", 1e3 * x);
    out += '\n';
    for (std::size_t k = 0; k < observations.pictures.size(); ++k) {
        auto const& observed = observations.pictures[k];
        std::string name;
        for (char const c : observed.name)
            name += c == '"' ? "\"\"" : std::string(1, c);
        out += '"' + name + '"';
        for (auto const& response : responses)
            out += fmt::format(",{}", response.values[k]);
        out += fmt::format(",{}", 255 * observed.cut.level);
        for (double const z : observed.bed.profile.z)
            out += fmt::format(",{}", 1e3 * z);
        out += '\n';
    }
    return out;
}

Json json_of(double value)
{
    return std::isnan(value) ? Json(nullptr) : Json(value);
}

std::string as_json(Observations const& observations, std::vector<Response> const& responses,
                    ObserveArguments const& arguments)
{
    auto const& reading = arguments.photograph.bed;
    Json document = {{"radius_mm", 1e3 * arguments.radius},    {"rotation", word_for(arguments.rotation)},
                     {"closing_px", reading.closing},          {"rim", reading.rim},
                     {"inside_radius", reading.inside_radius}, {"pictures", Json::array()}};
    if (observations.reference)
        document["reference"] = observations.reference->name;
    for (std::size_t k = 0; k < observations.pictures.size(); ++k) {
        auto const& [name, picture, frame, cut, bed, smoothing] = observations.pictures[k];
        Json entry = {{"name", name},
                      {"circle_px", {frame.circle.x, frame.circle.y, frame.circle.radius}},
                      {"pixels", {frame.columns, frame.rows}},
                      {"cut_darkness", 255 * cut.level},
                      {"smoothing_px", smoothing}};
        for (auto const& response : responses)
            entry[response.name] = json_of(response.values[k]);
        Json x = Json::array(), heights = Json::array();
        for (std::size_t segment = 0; segment < bed.profile.x.size(); ++segment) {
            x.push_back(1e3 * bed.profile.x[segment]);
            heights.push_back(json_of(1e3 * bed.profile.z[segment]));
        }
        entry["profile"] = {{"x_mm", x}, {"height_mm", heights}};
        document["pictures"].push_back(entry);
    }
    for (auto const& response : responses) {
        auto const scatter = scatter_of(response.values);
        document["mean"][response.name] = json_of(scatter.mean);
        document["sd"][response.name] = json_of(scatter.sd);
    }
    return document.dump(2) + "\n";
}

std::string as_targets(Observations const& observations, std::vector<Response> const& responses)
{
    std::size_t const count = observations.pictures.size();
    if (count < 2)
        throw InputError("--targets: one picture has no scatter to weigh it by; give several, or write "
                         "target.NAME = { value = ..., scale = ... } by hand");
    std::string out = fmt::format("# {} pictures; sd is that of one of them\n", count);
    for (auto const& response : responses) {
        if (!response.is_of_rig)
            continue;
        auto const scatter = scatter_of(response.values);
        if (scatter.sd > 0)
            out += fmt::format("target.{0} = {{ value = {1:.6g}, scale = {2:.3g}, sd = {2:.3g} }}\n",
                               response.name, scatter.mean, scatter.sd);
        else
            out +=
                fmt::format("# target.{}: no scatter, or no value in one of the pictures\n", response.name);
    }
    return out;
}

} // namespace

std::string output_of(Observations const& observations, ObserveArguments const& arguments)
{
    auto const responses = responses_of(observations, arguments);
    switch (arguments.format) {
    case ObserveFormat::csv:
        return as_csv(observations, responses);
    case ObserveFormat::json:
        return as_json(observations, responses, arguments);
    case ObserveFormat::targets:
        return as_targets(observations, responses);
    case ObserveFormat::text:
        break;
    }
    return as_text(observations, responses);
}

} // namespace demens::cli
