// Campaign files from others: damaged in a bit, or made to reach outside.
#include "demens/base/error.hpp"
#include "ensemble/storage/durable.hpp"
#include "tests/mpi/finished_campaign.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::ensemble;
using namespace demens::test;
using ::testing::HasSubstr;

namespace {

//! What is said of a campaign that was changed by HDF5's own functions.
std::string refusal_after(std::function<void(hid_t)> const& change)
{
    create_finished_campaign("changed.h5");
    auto file = hdf5::open_to_write("changed.h5");
    change(file);
    file.close();
    return refusal_of_campaign("changed.h5");
}

//! A dataset takes the place of another, with a right check sum.
template <class T>
std::string refusal_with(std::string const& path, std::vector<std::size_t> const& shape,
                         std::vector<T> const& data)
{
    return refusal_after([&](hid_t file) {
        H5Ldelete(file, path.c_str(), H5P_DEFAULT);
        hdf5::write<T>(file, path, shape, data, {{"1"}, {}, "changed"});
    });
}

std::vector<std::string> datasets_below(hid_t file, std::string const& group)
{
    std::vector<std::string> paths;
    for (auto const& name : hdf5::children(file, group)) {
        auto const path = (group == "/" ? "" : group) + "/" + name;
        hdf5::Object const object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path);
        if (H5Iget_type(object) == H5I_GROUP) {
            auto const below = datasets_below(file, path);
            paths.insert(paths.end(), below.begin(), below.end());
        } else
            paths.push_back(path);
    }
    return paths;
}

} // namespace

TEST(DamagedFile, AFlippedBitInAnyDatasetIsRefusedByName)
{
    create_finished_campaign("whole.h5");
    ASSERT_EQ(refusal_of_campaign("whole.h5"), "accepted");
    auto const image = read_bytes("whole.h5");
    int flipped = 0;
    auto const file = hdf5::open_to_read("whole.h5");
    for (auto const& path : datasets_below(file, "/")) {
        hdf5::Dataset const dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), path);
        auto const size = H5Dget_storage_size(dataset);
        auto const place = H5Dget_offset(dataset);
        for (int k = 0; size > 0 && k < 4; ++k) { // spread over its bytes and bits
            auto damaged = image;
            damaged.at(place + (size - 1) * static_cast<std::size_t>(k) / 3) ^= std::byte(1 << (k * 5 % 8));
            write_durably("flipped.h5", damaged);
            EXPECT_THAT(refusal_of_campaign("flipped.h5"), HasSubstr(path + " is damaged")) << path;
            ++flipped;
        }
    }
    EXPECT_GE(flipped, 100);
}

TEST(DamagedFile, AFlippedBitAnywhereDoesNoHarm)
{
    create_finished_campaign("whole.h5");
    auto const image = read_bytes("whole.h5");
    int refused = 0;
    int constexpr places = 300;
    for (std::size_t k = 0; k < places; ++k) {
        auto damaged = image;
        damaged.at(image.size() * k / places) ^= std::byte(1 << (k % 8));
        write_durably("flipped.h5", damaged);
        refused += refusal_of_campaign("flipped.h5") != "accepted";
    }
    EXPECT_GE(refused, places / 2); // the others lie where nothing is stored
}

TEST(HostileFile, LinksThatLeadElsewhereAreRefused)
{
    auto const outside = [](hid_t file) {
        H5Ldelete(file, "/targets/value", H5P_DEFAULT);
        H5Lcreate_external("/etc/other.h5", "/value", file, "/targets/value", H5P_DEFAULT, H5P_DEFAULT);
    };
    EXPECT_THAT(refusal_after(outside), HasSubstr("/targets, where a link leads out of the file"));
    auto const soft = [](hid_t file) {
        H5Lcreate_soft("/waves", file, "/waves/0001", H5P_DEFAULT, H5P_DEFAULT);
    };
    EXPECT_THAT(refusal_after(soft), HasSubstr("/waves, where a link leads out of the file"));
    auto const cycle = [](hid_t file) {
        H5Lcreate_hard(file, "/waves", file, "/waves/0000/again", H5P_DEFAULT, H5P_DEFAULT);
    };
    EXPECT_THAT(refusal_after(cycle), HasSubstr("/waves/0000/again is in the file in two ways"));
}

TEST(HostileFile, NumbersInOtherFilesAreRefused)
{
    auto const external = [](hid_t file) {
        H5Ldelete(file, "/targets/value", H5P_DEFAULT);
        hsize_t const size = 2;
        hdf5::Space const space(H5Screate_simple(1, &size, nullptr), "space");
        hdf5::Properties const creation(H5Pcreate(H5P_DATASET_CREATE), "properties");
        H5Pset_external(creation, "secret.bin", 0, 16);
        hdf5::Dataset const dataset(
            H5Dcreate2(file, "/targets/value", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT),
            "");
    };
    EXPECT_THAT(refusal_after(external), HasSubstr("/targets/value lies in other files"));
    auto const chunked = [](hid_t file) {
        hsize_t const size = 2;
        hdf5::Space const space(H5Screate_simple(1, &size, nullptr), "space");
        hdf5::Properties const creation(H5Pcreate(H5P_DATASET_CREATE), "properties");
        H5Pset_chunk(creation, 1, &size);
        hdf5::Dataset const dataset(
            H5Dcreate2(file, "/targets/more", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, creation, H5P_DEFAULT),
            "");
    };
    EXPECT_THAT(refusal_after(chunked), HasSubstr("/targets/more is stored in chunks"));
}

TEST(HostileFile, ShapesThatDoNotFitAreRefused)
{
    auto const wave = std::string("/waves/0000/");
    EXPECT_THAT(refusal_with<double>(wave + "responses/slow", {1, 2}, {1, 2}),
                HasSubstr("/waves/0000/responses/slow has 1 x 2 entries instead of"));
    EXPECT_THAT(refusal_with<int>(wave + "runs/status", {1}, {1}), HasSubstr("runs/status has 1 entries"));
    EXPECT_THAT(refusal_with<double>(wave + "runs/status", {1}, {1}),
                HasSubstr("does not hold whole numbers"));
    EXPECT_THAT(refusal_with<double>(wave + "optimum/best_point", {1}, {1}),
                HasSubstr("optimum/best_point has 1 entries instead of 2"));
    auto const list = [](hid_t file) {
        hsize_t const size = 1000;
        hdf5::Space const space(H5Screate_simple(1, &size, nullptr), "space");
        H5Adelete(file, "format_version");
        hdf5::Attribute const attribute(
            H5Acreate2(file, "format_version", H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT),
            "attribute");
    };
    EXPECT_THAT(refusal_after(list), HasSubstr("the attribute format_version of / is not one number"));
}

TEST(HostileFile, NumbersThatNumberNothingAreRefused)
{
    auto const wave = std::string("/waves/0000/");
    std::vector<std::size_t> const six = {6}, pair = {1, 2};
    EXPECT_THAT(refusal_with<int>(wave + "runs/run", six, {0, 0, 0, 0, 0, 0}),
                HasSubstr("/waves/0000/runs/run: 0 stands where run 1 should"));
    EXPECT_THAT(refusal_with<int>(wave + "runs/run", six, {0, 1, 2, 3, 4, 6}),
                HasSubstr("6 stands where run 5 should"));
    EXPECT_THAT(refusal_with<double>(wave + "optimum/best_run", {1}, {6}),
                HasSubstr("optimum/best_run: 6 is no whole number from -1 to 5"));
    EXPECT_THAT(refusal_with<double>(wave + "optimum/best_point_number", {1}, {0.5}),
                HasSubstr("best_point_number: 0.5 is no whole number"));
    EXPECT_THAT(refusal_with<double>(wave + "optimum/factor_verdict", {2}, {0, 8}),
                HasSubstr("factor_verdict: 8 is no whole number from 0 to 7"));
    EXPECT_THAT(refusal_with<double>(wave + "tradeoff/factors", pair, {0, 2}),
                HasSubstr("tradeoff/factors: 2 is no whole number from 0 to 1"));
    EXPECT_THAT(refusal_with<double>(wave + "tradeoff/response", pair, {0, 99}),
                HasSubstr("tradeoff/response: 99 is no whole number"));
}

TEST(HostileFile, ASessionDoesNotWorkThroughLinks)
{
    create_finished_campaign("target.h5");
    std::filesystem::remove("link.h5");
    std::filesystem::create_symlink("target.h5", "link.h5");
    auto const input = CampaignInput::from_text(formula_campaign(), "test", formula_rigs());
    for (auto const& name : {"behind.h5.lock", "behind.h5.parts"}) {
        std::filesystem::remove_all("behind.h5.lock");
        std::filesystem::remove_all("behind.h5.parts");
        std::filesystem::create_symlink("target.h5", name);
        EXPECT_THROW(create_campaign_file("behind.h5", input), InputError) << name;
        std::filesystem::remove(name);
    }
    auto const before = read_bytes("target.h5");
    std::filesystem::create_symlink("target.h5", "copied.h5.new");
    create_finished_campaign("copied.h5"); // its copy on the way is made anew
    EXPECT_EQ(read_bytes("target.h5"), before);
}
