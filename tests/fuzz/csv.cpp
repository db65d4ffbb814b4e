#include "demens/base/text/csv.hpp"
#include "ensemble/curve/measured_curve.hpp"
#include "tests/fuzz/accepts.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    auto const content = test::text_of(data, size);
    test::read_or_refuse([&] { text::CsvTable::from_text(content, "fuzz.csv"); });
    test::read_or_refuse([&] { ensemble::read_curve(content, "fuzz.csv", {}); });
    return 0;
}
