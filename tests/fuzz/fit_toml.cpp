#include "tao_calib/fit_table/fit_input.hpp"
#include "tests/fuzz/accepts.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    test::read_or_refuse([&] { tao_calib::FitInput::from_text(test::text_of(data, size), "fuzz.toml"); });
    return 0;
}
