// The reference of the TOML file names every section and key that the reader knows, with its default.
#include "ensemble/input/input_options.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>

namespace demens::ensemble::input {
namespace {

using ::testing::HasSubstr;

std::string read_reference()
{
    std::ifstream file(DEMENS_SOURCE_DIR "/ensemble/input/CAMPAIGN_INPUT.md");
    return {std::istreambuf_iterator<char>(file), {}};
}

//! The part of the reference from a section's heading to the next one.
std::string part_of(std::string const& reference, std::string const& heading)
{
    auto const begin = reference.find("`" + heading);
    auto const end = reference.find("\n## ", begin);
    return begin == std::string::npos ? "" : reference.substr(begin, end - begin);
}

TEST(CampaignInputReference, NamesEveryKeyInItsSection)
{
    auto const reference = read_reference();
    ASSERT_FALSE(reference.empty());
    for (auto const& section : all_sections()) {
        auto const part = part_of(reference, section.heading);
        ASSERT_FALSE(part.empty()) << section.heading;
        for (auto const& spec : section.options) {
            EXPECT_THAT(part, HasSubstr("`" + spec.key + "`")) << section.heading;
            for (auto const& choice : spec.choices)
                EXPECT_THAT(part, HasSubstr("`" + choice + "`")) << section.heading << " " << spec.key;
        }
        for (auto const& list : section.lists)
            EXPECT_THAT(part, HasSubstr("`" + list.key + "`")) << section.heading;
    }
}

TEST(CampaignInputReference, HoldsTheRightDefaultsOfWholeNumbersAndSwitches)
{
    auto const reference = read_reference();
    for (auto const& section : all_sections()) {
        auto const part = part_of(reference, section.heading);
        for (auto const& spec : section.options) {
            std::string wanted;
            if (spec.required)
                wanted = "required";
            else if (auto const* whole = std::get_if<std::int64_t>(&spec.default_value))
                wanted = std::to_string(*whole);
            else if (auto const* flag = std::get_if<bool>(&spec.default_value))
                wanted = *flag ? "true" : "false";
            else
                continue;
            EXPECT_THAT(part, HasSubstr("| `" + spec.key + "` | " + wanted + " |")) << section.heading;
        }
    }
}

} // namespace
} // namespace demens::ensemble::input
