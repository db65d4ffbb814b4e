#include "src/rig/custom/particle_csv.hpp"
#include "tests/fuzz/accepts.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    test::read_or_refuse([&] { rig::custom::read_particle_csv(test::text_of(data, size), "fuzz.csv"); });
    return 0;
}
