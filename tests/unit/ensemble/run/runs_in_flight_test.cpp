#include "ensemble/run/runs_in_flight.hpp"

#include <filesystem>
#include <gtest/gtest.h>

using namespace demens::ensemble;

namespace {

TEST(RunsInFlight, ThoseThatHaveNotEndedBeginAgain)
{
    auto const folder = std::filesystem::path("runs-in-flight");
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    {
        Journal journal(folder, "rank-0000");
        RunsInFlight flight(journal);
        for (int row = 0; row < 4; ++row)
            flight.start(row, 10 + row, Journal::Company::others, 0.5 * row);
        flight.note_signals();
        EXPECT_EQ(flight.end(1), 0.5);
        journal.end(11, 7, 1, 1);
        flight.note_signals();
        EXPECT_EQ(flight.give_up(), (std::deque{0, 2, 3}));
        EXPECT_TRUE(flight.give_up().empty());
    }
    auto histories = read_journals(folder);
    EXPECT_EQ(histories[11].status, 1);
    for (int const run : {10, 12, 13}) {
        EXPECT_FALSE(histories[run].open) << run;
        EXPECT_EQ(histories[run].deaths, 0) << run;
        EXPECT_EQ(histories[run].status, -1) << run;
    }
    std::filesystem::remove_all(folder);
}

} // namespace
