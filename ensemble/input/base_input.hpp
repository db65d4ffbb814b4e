#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "ensemble/input/input_table.hpp"

#include <functional>
#include <string>
#include <vector>

namespace demens::ensemble::input {

//! Checked table of one material.
struct MaterialTable
{
    std::string name;
    OptionValues values;
};

//! Checked table of one pair of materials.
struct PairTable
{
    std::string first, second; //!< in the order of the table's heading
    OptionValues values;

    std::string name() const { return first + "_" + second; }
};

//! One `[shape.NAME]`.
struct ShapeTable
{
    std::string name;
    grain::SizeMeasure measure;
    grain::Clump spheres = {};          //!< as its author wrote them; none: a polyhedron
    std::vector<Vector3> vertices = {}; //!< its corners, sharp, in the author's unit
    double rounding = 0;                //!< of its edges, over the diameter of the sphere of its volume
    std::string note = {};              //!< what is to be said of where it came from
    grain::GrainShape shape = {};
};

//! A shape in a size distribution.
struct ShapeShare
{
    std::string name; //!< of its table, or "sphere"
    double share;
};

//! Lists of one size distribution, as its author wrote them.
struct SizeTable
{
    std::string name;
    bool classes;                        //!< discrete classes rather than a cumulative curve
    std::vector<double> diameters;       //!< [mm]
    std::vector<double> fractions;       //!< of the mass
    std::vector<ShapeShare> shapes = {}; //!< none: spheres
    grain::ShareOf share_of = grain::ShareOf::mass;
};

//! Where a number of the base input is kept.
struct ScalarPlace
{
    enum class Table
    {
        material,
        pair,
        experiment
    } table;
    std::size_t index; //!< of the material, pair or experiment
    std::vector<std::pair<std::string, std::size_t>> inside =
        {}; //!< tables in the experiment: key and number
    std::string key = {};
    int component = -1; //!< of a vector: 0, 1, 2

    friend bool operator==(ScalarPlace const&, ScalarPlace const&) = default;
};

//! The resolved input that runs are made from: the base model, the conditions, and what the factors replace.
struct BaseInput
{
    std::vector<MaterialTable> materials;
    std::vector<PairTable> pairs;
    std::vector<ShapeTable> shapes;
    std::vector<SizeTable> size_distributions;
    std::vector<OptionValues> experiments;               //!< options of the rig, one entry an experiment
    std::vector<std::vector<ScalarPlace>> factor_places; //!< one entry a factor

    rig::Files files; //!< that the experiments name
    rig::EngineChoice engine = rig::EngineChoice::cpu;

    OptionValue value(ScalarPlace const& place) const;
    //! \param value a number where the place is a component of a vector
    void set(ScalarPlace const& place, OptionValue const& value);
    std::vector<std::string> material_names() const;
    std::vector<std::string> size_distribution_names() const;
};

//! Reads `[material.NAME]`, `[contact.A_B]`, `[shape.NAME]` and `[size_distribution.NAME]`.
BaseInput read_base_model(InputTable const& file, FileSource const& files);
//! Reads one `[size_distribution.NAME]`.
SizeTable read_size_distribution(InputTable const& table, std::string const& name,
                                 std::vector<ShapeTable> const& shapes = {});
//! Reads `[[experiment]]`; the options of their rigs go to `base`. \return also the tables, for later
//! messages
struct ReadExperiments
{
    std::vector<Experiment> experiments;
    std::vector<InputTable> tables;
    std::vector<std::string> notes; //!< what is said of their targets
};
ReadExperiments read_experiments(InputTable const& file, BaseInput& base,
                                 std::vector<rig::RigInfo> const& rigs, FileSource const& files);
//! Reads `[[factor]]`; what they replace goes to `base`.
std::vector<Factor> read_factors(InputTable const& file, BaseInput& base,
                                 std::vector<Experiment> const& experiments);
//! Reads `[[constraint]]`.
std::vector<LinearConstraint> read_constraints(InputTable const& file, BaseInput const& base,
                                               std::vector<Experiment> const& experiments,
                                               std::vector<Factor> const& factors);
//! What a dotted path names, in the form in which it is stored; no places when it names nothing.
struct ResolvedPath
{
    std::string path;
    std::vector<ScalarPlace> places;
    OptionSpec spec; //!< of the number
};
ResolvedPath resolve_path(std::string const& path, BaseInput const& base,
                          std::vector<Experiment> const& experiments);
//! What is called with a value's path inside its experiment, its place and what it means.
using VisitValue =
    std::function<void(std::string const& path, ScalarPlace const& place, OptionSpec const& spec)>;
//! Visits every value of an experiment; vectors by their components.
void for_each_value(BaseInput const& base, std::vector<Experiment> const& experiments, std::size_t experiment,
                    VisitValue const& visit);
//! What a run of an experiment is made from: its rig's values, and those of the materials, pairs and size
//! distributions that it names.
std::vector<ModelValue> model_values(BaseInput const& base, std::vector<Experiment> const& experiments,
                                     std::size_t experiment);
//! Where experiments name a material.
std::vector<NamedMaterial> named_materials(BaseInput const& base, std::vector<Experiment> const& experiments);
//! All paths that a factor may have.
std::vector<std::string> all_paths(BaseInput const& base, std::vector<Experiment> const& experiments);

//! Size distribution [m] from its lists. \throws InputError without a place
shape::SizeDistribution make_size_distribution(SizeTable const& table);
//! Puts factor values in the place of the base values.
void set_factors(BaseInput& base, std::vector<double> const& factor_values);
//! The input of a run as the base values say.
rig::RunInput make_run_input(BaseInput const& base, int experiment, std::uint64_t seed);
//! The same with factor values in their place.
rig::RunInput make_run_input(BaseInput base, std::vector<double> const& factor_values, int experiment,
                             std::uint64_t seed);

//! A name that can be part of a dotted path. \throws InputError otherwise
void check_name(InputTable const& table, std::string const& key, std::string const& name);

} // namespace demens::ensemble::input

namespace demens::ensemble {

struct CampaignInput::Tree : input::BaseInput
{
};

} // namespace demens::ensemble
