#include "demens/shape/stl.hpp"
#include "tests/fuzz/accepts.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    test::read_or_refuse([&] {
        auto const mesh = shape::load_mesh("fuzz.stl", test::text_of(data, size));
        mesh->faults();
    });
    return 0;
}
