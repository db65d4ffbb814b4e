#include "src/observe/frame_file/formats.hpp"
#include "tests/fuzz/accepts.hpp"

//! The first byte says which format the others are read as.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    namespace formats = observe::frame_file;
    if (size == 0)
        return 0;
    auto const text = test::text_of(data + 1, size - 1);
    test::read_or_refuse([&] {
        switch (data[0]) {
        case '#':
            formats::read_vtk_legacy(text, "fuzz", 1);
            break;
        case '<':
            formats::read_vtk_xml(text, "fuzz", 1);
            formats::files_of_collection(text, "fuzz");
            break;
        case 'I':
            formats::read_dump(text, "fuzz", 1);
            break;
        default:
            formats::read_csv(text, "fuzz", 1);
        }
    });
    return 0;
}
