// What the ranks of a team store of a simulation that they share.
#include "demens/dem/record_fields.hpp"
#include "src/dem/cpu/decomposition/decomposition.hpp"

namespace demens::dem {
namespace {

std::string part_name(std::size_t rank)
{
    return fmt::format("rank/{}", rank);
}

} // namespace

StateRecord Decomposition::join(StateRecord&& mine)
{
    StateRecord whole;
    auto const parts = team_.gather(mine.to_bytes());
    RecordWriter write(whole);
    write(ranks_name, parts.size());
    for (std::size_t rank = 0; rank < parts.size(); ++rank)
        whole.put(part_name(rank), std::span<std::byte const>(parts[rank]));
    return whole;
}

StateRecord Decomposition::part_of(StateRecord const& record)
{
    if (!record.has(ranks_name))
        throw InputError("the state record is of a simulation in one process; go on without a team");
    RecordReader read(record);
    std::size_t ranks = 0;
    read(ranks_name, ranks);
    if (ranks != static_cast<std::size_t>(team_.size()))
        throw InputError(fmt::format("the state record is of a team of {} ranks, this one has {}; go on with "
                                     "as many",
                                     ranks, team_.size()));
    return StateRecord::from_bytes(record.get<std::byte>(part_name(static_cast<std::size_t>(team_.rank()))));
}

void Decomposition::save(StateRecord& record) const
{
    RecordWriter write(record);
    auto const cuts = boxes_.cuts();
    auto const routes = ghosts_.routes();
    write("boxes/numbers", cuts.numbers), write("boxes/borders", cuts.borders);
    write("ghosts/sent", routes.sent), write("ghosts/received", routes.received);
    write("ghosts/links", routes.links), write("ghosts/ids", ghost_ids_);
    write("ghosts/owned", owned_), write("ghosts/are_fresh", is_fresh_), write("boxes/are_cut", is_cut_);
}

ContactNumbers Decomposition::restore(StateRecord const& record, State const& state)
{
    RecordReader read(record);
    Bisection::Cuts cuts;
    GhostExchange::Routes routes;
    read("boxes/numbers", cuts.numbers), read("boxes/borders", cuts.borders);
    read("ghosts/sent", routes.sent), read("ghosts/received", routes.received);
    read("ghosts/links", routes.links), read("ghosts/ids", ghost_ids_);
    read("ghosts/owned", owned_), read("ghosts/are_fresh", is_fresh_), read("boxes/are_cut", is_cut_);
    expect_fit(owned_ <= state.particles.owned(), "a rank has fewer particles than its contacts name");
    std::size_t const known = owned_ + ghost_ids_.size();
    boxes_.restore(cuts);
    ghosts_.restore(routes, team_, known, state.particles.has_hulls);
    all_.reset();
    return numbers();
}

void Decomposition::agree(std::function<void()> const& part)
{
    std::string fault;
    try {
        part();
    } catch (InputError const& error) {
        fault = error.what();
    }
    bool const fails_somewhere = team_.any(!fault.empty());
    if (!fault.empty())
        throw InputError(fault);
    if (fails_somewhere)
        throw InputError("the part of the state record of another rank of the team cannot be used");
}

} // namespace demens::dem
