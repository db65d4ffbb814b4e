#include "gap/campaign/prediction.hpp"

#include "gap/campaign/campaign_cells.hpp"
#include "gap/campaign/simulated_points.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <numeric>

namespace demens::gap {

double Prediction::mean() const
{
    if (simulated.empty())
        return std::numeric_limits<double>::quiet_NaN();
    return std::accumulate(simulated.begin(), simulated.end(), 0.0) / static_cast<double>(simulated.size());
}

double Prediction::sd() const
{
    if (simulated.size() < 2)
        return std::numeric_limits<double>::quiet_NaN();
    double const middle = mean();
    double sum = 0;
    for (double const value : simulated)
        sum += (value - middle) * (value - middle);
    return std::sqrt(sum / static_cast<double>(simulated.size() - 1));
}

std::vector<Prediction> predictions(ensemble::Campaign const& campaign)
{
    auto const points = simulated_points(campaign, ensemble::WavePurpose::closure);
    // the estimate is planned before what a diagnosis adds to it
    auto const point =
        std::find_if(points.begin(), points.end(), [](auto const& one) { return one.effect.empty(); });
    std::vector<Prediction> all;
    if (point == points.end())
        return all;
    for (auto const& cell : cells_of(campaign.input, ensemble::ExperimentRole::hold_out)) {
        all.push_back({cell.cell.name, cell.shown.units, cell.target->value, cell.target->scale, {}});
        for (auto const& run : point->runs[static_cast<std::size_t>(cell.cell.experiment)])
            all.back().simulated.push_back(run[cell.target->response_index]);
    }
    return all;
}

std::string prediction_text(ensemble::Campaign const& campaign)
{
    auto const all = predictions(campaign);
    if (all.empty())
        return "";
    std::string text = "Predicted at the estimate, not fitted:\n";
    auto const to = std::back_inserter(text);
    for (auto const& one : all) {
        fmt::format_to(to, "  {:<44} measured {:.4g}, ", one.name, one.measured);
        if (one.simulated.empty()) {
            fmt::format_to(to, "no run finished\n");
            continue;
        }
        fmt::format_to(to, "simulated {:.4g}", one.mean());
        if (one.simulated.size() > 1)
            fmt::format_to(to, " +- {:.2g} over {} packings", one.sd(), one.simulated.size());
        fmt::format_to(to, ", {:+.2f} scales\n", (one.mean() - one.measured) / one.scale);
    }
    return text;
}

nlohmann::json prediction_document(ensemble::Campaign const& campaign)
{
    nlohmann::json list = nlohmann::json::array();
    for (auto const& one : predictions(campaign))
        list.push_back({{"cell", one.name},
                        {"units", one.units},
                        {"measured", one.measured},
                        {"scale", one.scale},
                        {"simulated", one.simulated},
                        {"mean", one.mean()},
                        {"sd", one.sd()}});
    return list;
}

} // namespace demens::gap
