// How often the stated 95 % intervals hold the truth where runs scatter by 8 % with heavy tails, by surrogate
// kind and replicates. Writes a table in Markdown.   coverage [CAMPAIGNS] [WAVES] [SURROGATE...]
#include "tests/unit/tao_calib/wave/coverage.hpp"
#include "tests/bench/calibration/with_petsc.hpp"

#include <algorithm>
#include <fmt/format.h>

int main(int argc, char** argv)
{
    using namespace demens::tao_calib;
    int const campaigns = argc > 1 ? std::stoi(argv[1]) : 100, waves = argc > 2 ? std::stoi(argv[2]) : 0;
    return demens::bench::with_petsc(argc, argv, [&] {
        fmt::print("| surrogate | 1 | 2 | 4 | 16 replicates |\n|---|---|---|---|---|\n");
        std::vector<std::string> kinds(argv + std::min(argc, 3), argv + argc);
        if (kinds.empty())
            kinds = {"quadratic", "rbf", "gaussian_process", "auto"};
        for (auto const& kind : kinds) {
            fmt::print("| {} |", kind);
            for (int replicates : {1, 2, 4, 16}) {
                auto const found = coverage(kind, replicates, campaigns, waves);
                fmt::print(" {:.1f} % (+-{:.3f}), {} within bounds: {:.1f} % |", 100 * found.share(),
                           found.half_width(), found.whole, 100.0 * found.whole_held / found.whole);
                std::fflush(stdout);
            }
            fmt::print("\n");
        }
        return 0;
    });
}
