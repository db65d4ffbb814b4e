#include "src/dem/record_fit.hpp"

#include "demens/dem/record_fields.hpp"

namespace demens::dem {
namespace {

//! What two simulations must have in common, so that one can go on where the other was.
struct Fit
{
    static constexpr std::size_t with_added = 256; //!< beside the place of the cohesion law

    double time_step, skin;
    Vector3 gravity;
    std::vector<double> periods; //!< lower and upper, of x and y
    bool ledger;
    std::string materials;           //!< names, a line each
    std::vector<std::uint32_t> laws; //!< of each law set
    std::vector<std::uint32_t> interaction;
    std::vector<double> surroundings; //!< their numbers; empty: none

    explicit Fit(Params const& params)
        : time_step(params.options.time_step), skin(params.options.skin),
          gravity(params.options.gravity), periods{params.options.periodic.x.lower,
                                                   params.options.periodic.x.upper,
                                                   params.options.periodic.y.lower,
                                                   params.options.periodic.y.upper},
          ledger(params.options.energy_ledger), interaction(params.interaction)
    {
        if (auto const& around = params.options.surroundings; around.is_any())
            surroundings = {around.viscosity,   around.density,     around.vibration.x,
                            around.vibration.y, around.vibration.z, around.frequency};
        for (auto const& material : params.materials)
            materials += material.name + '\n';
        for (auto const& at : params.places)
            for (auto const place :
                 {at.normal, at.tangential, at.rolling, at.cohesion + with_added * at.added})
                laws.push_back(static_cast<std::uint32_t>(place));
    }
};

std::string in_words(bool on)
{
    return on ? "on" : "off";
}
std::string in_words(double number)
{
    return fmt::format("{:.17g}", number);
}
std::string in_words(Vector3 const& v)
{
    return fmt::format("({:.17g}, {:.17g}, {:.17g})", v.x, v.y, v.z);
}

template <class T>
void check_fit(StateRecord const& record, std::string const& array, char const* what, T const& here)
{
    T there;
    RecordReader read(record);
    read(array, there);
    if (!(there == here))
        throw InputError(fmt::format("the state record is of a simulation with {} {}, this one has {}; they "
                                     "must be the same",
                                     what, in_words(there), in_words(here)));
}

template <class T>
void check_same(std::vector<T> const& there, std::vector<T> const& here, char const* what)
{
    if (there != here)
        throw InputError(
            fmt::format("the state record is of a simulation with other {}; they must be the same", what));
}

} // namespace

void write_fit(StateRecord& record, Params const& params)
{
    Fit const fit(params);
    RecordWriter write(record);
    write("fit/time_step", fit.time_step), write("fit/skin", fit.skin), write("fit/gravity", fit.gravity);
    write("fit/periods", fit.periods), write("fit/ledger", fit.ledger);
    write("fit/materials", fit.materials), write("fit/laws", fit.laws),
        write("fit/interaction", fit.interaction);
    if (!fit.surroundings.empty())
        write("fit/surroundings", fit.surroundings);
}

void check_fit(StateRecord const& record, Params const& params)
{
    Fit const here(params);
    check_fit(record, "fit/time_step", "the time step [s]", here.time_step);
    check_fit(record, "fit/skin", "the skin [m]", here.skin);
    check_fit(record, "fit/gravity", "gravity [m/s^2]", here.gravity);
    check_fit(record, "fit/ledger", "the energy ledger", here.ledger);
    check_same(record.get<double>("fit/periods"), here.periods, "periodic directions");
    check_same(record.has("fit/surroundings") ? record.get<double>("fit/surroundings")
                                              : std::vector<double>{},
               here.surroundings, "surroundings");
    std::string materials;
    RecordReader const read(record);
    read("fit/materials", materials);
    if (materials != here.materials)
        throw InputError(fmt::format("the state record is of a simulation with other materials; they must be "
                                     "the same, in the same order:\n{}",
                                     materials));
    check_same(record.get<std::uint32_t>("fit/laws"), here.laws, "contact laws");
    check_same(record.get<std::uint32_t>("fit/interaction"), here.interaction, "pairs of materials");
}

} // namespace demens::dem
