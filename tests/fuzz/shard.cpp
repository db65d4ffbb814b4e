// The shard of a run, of which bytes are changed and whose journal has the check sum of the changed ones:
// cases are lists of (offset, byte).
#include "ensemble/file/parts.hpp"
#include "ensemble/run/execute.hpp"
#include "tests/fuzz/accepts.hpp"
#include "tests/fuzz/changed_bytes.hpp"
#include "tests/fuzz/scratch.hpp"
#include "tests/mpi/formula_rig.hpp"

#include <fstream>

namespace {

using namespace demens;
using namespace demens::ensemble;

struct WrittenShard
{
    WrittenShard() : campaign(test::scratch_path("shard.h5")), parts(campaign)
    {
        Campaign planned;
        planned.input = CampaignInput::from_text(test::formula_campaign(), "fuzz", test::formula_rigs());
        plan = plan_runs(planned, {WavePurpose::design, {{0.1, 0.2}}}).runs.front();
        input = planned.input;
        parts.make_folder();
        Journal journal(parts.folder(), "rank-0000");
        parts.store(execute(input, plan, {}), input, journal);
        file = parts.folder() / "run-000000.h5";
        image = read_bytes(file);
    }

    std::filesystem::path campaign, file;
    Parts parts;
    RunRecord plan;
    CampaignInput input;
    Bytes image;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    static WrittenShard const shard;
    auto const changed = test::changed_bytes(shard.image, data, size);
    std::ofstream(shard.file, std::ios::binary)
        .write(reinterpret_cast<char const*>(changed.data()), static_cast<std::streamsize>(changed.size()));
    shard.parts.look(shard.plan, shard.input, {crc32_of(changed)});
    return 0;
}
