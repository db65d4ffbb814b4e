// A campaign file with a finished wave, of which bytes are changed: cases are lists of (offset, byte). The
// check sums that are right for the changed bytes are not made anew, so that datasets mostly end there;
// headers, attributes and the structure of the file do not.
#include "ensemble/campaign_reader.hpp"
#include "ensemble/storage/durable.hpp"
#include "tests/fuzz/accepts.hpp"
#include "tests/fuzz/changed_bytes.hpp"
#include "tests/fuzz/scratch.hpp"
#include "tests/mpi/finished_campaign.hpp"

#include <fstream>

namespace {

using namespace demens;
using namespace demens::ensemble;

std::filesystem::path const file = test::scratch_path("campaign.h5");

Bytes campaign_image()
{
    test::create_finished_campaign(file);
    return read_bytes(file);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    static Bytes const image = campaign_image();
    auto const changed = test::changed_bytes(image, data, size);
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<char const*>(changed.data()), static_cast<std::streamsize>(changed.size()));
    test::read_or_refuse([&] {
        CampaignReader const reader(file, test::formula_rigs());
        if (reader.campaign().runs_planned() > 0)
            reader.details_of(reader.campaign().runs_planned() - 1);
    });
    return 0;
}
