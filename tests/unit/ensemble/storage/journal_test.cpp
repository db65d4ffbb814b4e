#include "demens/base/file_error.hpp"
#include "ensemble/storage/journal.hpp"

#include "ensemble/storage/durable.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::ensemble;

namespace {

class JournalTest : public testing::Test
{
  protected:
    JournalTest()
    {
        folder_ = std::string("journal-") + testing::UnitTest::GetInstance()->current_test_info()->name();
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }

    std::filesystem::path folder_;
};

} // namespace

TEST(CheckSum, IsTheOneOfTheStandard)
{
    EXPECT_EQ(crc32_of(std::string("123456789")), 0xcbf43926u); // check value of CRC-32/ISO-HDLC
}

TEST_F(JournalTest, TellsHowFarARunIs)
{
    Journal journal(folder_, "rank-0000");
    journal.start(7, Journal::Company::others);
    journal.at(7, 0.11, "in stage \"fill\" at 0.5 s");
    journal.at(7, 0.28, "in stage \"flow\" at 1.25 s");
    journal.at(8, 0.5, "of none that has begun");
    auto histories = read_journals(folder_);
    EXPECT_TRUE(histories[7].open);
    EXPECT_EQ(histories[7].share, 0.28);
    EXPECT_EQ(histories[7].moment, "in stage \"flow\" at 1.25 s");
    EXPECT_GE(histories[7].told, histories[7].begun);
    EXPECT_FALSE(histories[8].open);
    journal.start(7, Journal::Company::others); // again, from its beginning
    EXPECT_EQ(read_journals(folder_)[7].share, 0);
    for (auto const* said :
         {"AT 7 nan 1732243988 x", "AT 7 -1 1732243988 x", "AT 7 0.5 then x", "AT 7 0.5 1732243988"})
        std::ofstream(folder_ / "journal-rank-0000", std::ios::app)
            << fmt::format("{:08x} {}\n", crc32_of(std::string(said)), said);
    EXPECT_EQ(read_journals(folder_)[7].share, 0) << "that is no share, no time, no moment";
}

TEST_F(JournalTest, CountsDeathsByWhatWasWritten)
{
    {
        Journal journal(folder_, "rank-0000");
        journal.start(1, Journal::Company::others);
        journal.end(1, 0xabcd1234u, 5, 12.5);
        journal.start(2, Journal::Company::others); // killed
    }
    {
        Journal journal(folder_, "rank-0000");
        journal.start(2, Journal::Company::others);
        journal.drain(2);                          // given up on request: does not count
        journal.start(3, Journal::Company::alone); // killed
    }
    {
        Journal journal(folder_, "rank-0001");
        journal.start(4, Journal::Company::others);
        std::ofstream(folder_ / "journal-rank-0001", std::ios::app) << journal.crash_line(4, 11);
        journal.start(2, Journal::Company::others); // killed
    }
    auto histories = read_journals(folder_);
    EXPECT_EQ(histories[1].shard_crcs, std::vector<std::uint32_t>{0xabcd1234u});
    EXPECT_EQ(histories[1].status, 5);
    EXPECT_EQ(histories[1].seconds, 12.5);
    EXPECT_EQ(histories[1].deaths, 0);
    EXPECT_EQ(histories[2].deaths, 2);
    EXPECT_TRUE(histories[2].open);
    EXPECT_EQ(histories[2].deaths_alone, 0);
    EXPECT_EQ(histories[3].deaths_alone, 1);
    EXPECT_EQ(histories[3].deaths, 0);
    EXPECT_EQ(histories[4].crashes, 1);
    EXPECT_EQ(histories[4].crash, "signal 11");
    EXPECT_EQ(histories[4].deaths, 0);
}

TEST_F(JournalTest, AProcessMayHaveSeveralRunsInProgress)
{
    {
        Journal journal(folder_, "rank-0000");
        for (int run = 1; run <= 4; ++run)
            journal.start(run, Journal::Company::others);
        journal.end(2, 7, 1, 1);
        journal.drain(3); // then killed
    }
    auto histories = read_journals(folder_);
    for (int const run : {1, 4}) {
        EXPECT_TRUE(histories[run].open);
        EXPECT_EQ(histories[run].deaths, 1);
    }
    for (int const run : {2, 3}) {
        EXPECT_FALSE(histories[run].open);
        EXPECT_EQ(histories[run].deaths, 0);
    }
    Journal journal(folder_, "rank-0000"); // nothing of before is in progress any more
    histories = read_journals(folder_);
    EXPECT_FALSE(histories[1].open);
    EXPECT_EQ(histories[1].deaths, 1);
    journal.start(1, Journal::Company::others);
    journal.end(1, 8, 1, 1);
    EXPECT_EQ(read_journals(folder_)[1].deaths, 1);
}

TEST_F(JournalTest, DoesNotBlameARunWhoseProcessWasAskedToEnd)
{
    for (int session = 0; session < 5; ++session) {
        Journal journal(folder_, "rank-0000");
        journal.start(1, Journal::Company::alone);
        std::ofstream(folder_ / "journal-rank-0000", std::ios::app) << journal.stop_line(1); // then killed
    }
    auto histories = read_journals(folder_);
    EXPECT_EQ(histories[1].deaths, 0);
    EXPECT_EQ(histories[1].deaths_alone, 0);
    EXPECT_TRUE(histories[1].open);
}

TEST_F(JournalTest, DamagedLinesAreAsIfTheyWereNotThere)
{
    auto const file = folder_ / "journal-rank-0000";
    {
        Journal journal(folder_, "rank-0000");
        journal.start(1, Journal::Company::others);
        journal.end(1, 7, 1, 1);
        journal.start(2, Journal::Company::others);
        journal.end(2, 8, 1, 1);
    }
    // Cut at every length: no cut makes a line that was not written, and the next line is whole again.
    auto const whole = read_bytes(file);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        std::filesystem::resize_file(file, length);
        Journal(folder_, "rank-0000").start(3, Journal::Company::others);
        auto histories = read_journals(folder_);
        EXPECT_TRUE(histories[3].open) << length;
        EXPECT_LE(histories[1].shard_crcs.size() + histories[2].shard_crcs.size(), 2u);
        for (auto const crc : histories[1].shard_crcs)
            EXPECT_EQ(crc, 7u);
        for (auto const crc : histories[2].shard_crcs)
            EXPECT_EQ(crc, 8u);
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<char const*>(whole.data()), static_cast<std::streamsize>(whole.size()));
    }
    // One wrong bit in the last END: run 2 was begun and never ended.
    auto changed = whole;
    changed[changed.size() - 2] ^= std::byte{1};
    write_durably(file, changed);
    auto histories = read_journals(folder_);
    EXPECT_EQ(histories[1].shard_crcs.size(), 1u);
    EXPECT_TRUE(histories[2].shard_crcs.empty());
    EXPECT_EQ(histories[2].deaths, 1);
}

TEST_F(JournalTest, WhatAHostileHandWritesWithARightCheckSumIsAsIfItWereNotThere)
{
    {
        Journal journal(folder_, "rank-0000");
        journal.start(1, Journal::Company::others);
        journal.end(1, 0xabcd1234u, 5, 12.5);
    }
    std::ofstream file(folder_ / "journal-rank-0000", std::ios::app);
    for (std::string const line :
         {"END 1", "END 1 crc", "END 1 fffffffffffffffff", "START 1", "START 1 yesterday", "ALONE 1 1e999",
          "CRASH 1 signal", "CRASH 1 99999999999", "START 99999999999 1", "MELT 1"})
        file << fmt::format("{:08x} {}\n", crc32_of(line), line);
    file.close();
    auto histories = read_journals(folder_);
    ASSERT_EQ(histories.size(), 1u);
    EXPECT_EQ(histories[1].shard_crcs, std::vector<std::uint32_t>{0xabcd1234u});
    EXPECT_FALSE(histories[1].open);
    EXPECT_EQ(histories[1].crashes, 0);
}

TEST(WriteDurably, NamesTheFileThatCannotBeWritten)
{
    std::filesystem::remove_all("no-such-folder");
    try {
        write_durably("no-such-folder/file", {});
        FAIL();
    } catch (FileError const& error) {
        EXPECT_STREQ(error.what(), "cannot create no-such-folder/file.part: No such file or directory");
    }
}
