#include "ensemble/input/campaign_input.hpp"
#include "tests/fuzz/accepts.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    test::read_or_refuse([&] {
        ensemble::CampaignInput::from_text(test::text_of(data, size), "fuzz.toml", rig::all_rigs(),
                                           ensemble::input::no_files);
    });
    return 0;
}
