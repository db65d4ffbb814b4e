#include "demens/picture_file/picture_file.hpp"
#include "tests/fuzz/accepts.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    test::read_or_refuse([&] { picture_file::read_picture(test::text_of(data, size), "fuzz.png"); });
    return 0;
}
