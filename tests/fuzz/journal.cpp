// Lines of a journal, of which some are given the check sum that makes them count: those that begin with '='.
#include "ensemble/storage/journal.hpp"
#include "ensemble/file/parts.hpp"
#include "ensemble/storage/durable.hpp"
#include "tests/fuzz/accepts.hpp"
#include "tests/fuzz/scratch.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace demens;
    using namespace demens::ensemble;
    static auto const folder = test::scratch_path("journals");
    static bool const made = std::filesystem::create_directories(folder);
    static_cast<void>(made);
    std::istringstream in(test::text_of(data, size));
    std::ofstream journal(folder / "journal-rank-0000", std::ios::binary);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with('='))
            journal << fmt::format("{:08x} {}\n", crc32_of(line.substr(1)), line.substr(1));
        else
            journal << line << '\n';
    journal.close();
    test::read_or_refuse([&] {
        for (auto const& [run, history] : read_journals(folder))
            quarantine_reason(history);
        forget_runs(folder, {1});
    });
    return 0;
}
