#include "report/handover/handover.hpp"

#include "demens/base/error.hpp"
#include "report/handover/card.hpp"
#include "report/handover/parameters.hpp"
#include "report/handover/scene.hpp"

#include <fmt/format.h>

namespace demens::report {
namespace {

namespace stored = ensemble::stored;

//! Writes the decks of one experiment; why not, where they cannot be.
void write_decks(Folder& folder, ensemble::Experiment const& experiment, rig::RunInput const& input,
                 std::vector<WrittenDeck>& decks)
{
    auto const absent = [&](Code code, std::string const& reason) {
        decks.push_back({experiment.name, code, {}, reason});
    };
    if (!experiment.rig->describe) {
        for (Code const code : {Code::liggghts, Code::lammps})
            absent(code, "its rig is not described");
        return;
    }
    auto const scene = scene_of(*experiment.rig, input);
    auto const fault = fault_of(scene);
    for (Code const code : {Code::liggghts, Code::lammps}) {
        bool const is_liggghts = code == Code::liggghts;
        if (!fault.empty() || !has_all_laws(mapped(code, scene.model))) {
            absent(code, !fault.empty() ? fault : "a law has no counterpart there, see mapping.csv");
            continue;
        }
        auto const below = std::string(is_liggghts ? "liggghts/" : "lammps/");
        folder.write(below + experiment.name + ".in", is_liggghts ? liggghts_deck(scene, experiment.name)
                                                                  : lammps_deck(scene, experiment.name));
        folder.write(below + experiment.name + ".data", data_file(scene));
        auto const& walls = scene.walls;
        for (std::size_t k = 0; is_liggghts && k < walls.size(); ++k)
            if (is_written(walls[k]))
                folder.write(fmt::format("{}{}.wall{}.stl", below, experiment.name, k + 1),
                             stl_file(scene, walls[k], fmt::format("wall{}", k + 1)));
        decks.push_back({experiment.name, code, below + experiment.name + ".in", {}});
    }
}

} // namespace

void hand_over(Folder& folder, ensemble::Campaign const& campaign, Analysis const& analysis)
{
    auto const& best = analysis.find(stored::optimum::best_point)->data;
    auto const& experiments = campaign.input.experiments;
    std::vector<WrittenDeck> decks;
    std::optional<contact::Model> model;
    for (std::size_t e = 0; e < experiments.size(); ++e) {
        auto const input = campaign.input.run_input(best, 0, static_cast<int>(e), 0);
        if (!model)
            model = input.model;
        write_decks(folder, experiments[e], input, decks);
    }
    if (model && !model->pairs.empty()) {
        folder.write("mapping.csv", mapping_table(*model));
        folder.write("liggghts/parameters.in", liggghts_parameters(*model));
        folder.write("lammps/parameters.in", lammps_parameters(*model));
        folder.write("mfix/parameters.dat", mfix_parameters(*model));
        folder.write("edem.csv", parameter_table(Code::edem, *model));
        folder.write("rocky.csv", parameter_table(Code::rocky, *model));
    }
    folder.write("card.json",
                 material_card(campaign, analysis, model.value_or(contact::Model{}), decks).dump(1) + "\n");
}

} // namespace demens::report
