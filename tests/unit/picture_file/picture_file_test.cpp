// Pictures in the three formats come back as they were written.
#include "demens/picture_file/picture_file.hpp"

#include "demens/base/error.hpp"
#include "demens/base/file_error.hpp"
#include "demens/base/text/file.hpp"

#include <gtest/gtest.h>

#include <gd.h>

namespace {

using namespace demens;

//! Grey from 0 to 250 in columns, as a file.
std::string written(void* (*write)(gdImage*, int*))
{
    gdImage* const image = gdImageCreateTrueColor(26, 30);
    for (int row = 0; row < 30; ++row)
        for (int column = 0; column < 26; ++column)
            gdImageSetPixel(image, column, row, gdTrueColor(10 * column, 10 * column, 10 * column));
    int size = 0;
    void* const bytes = write(image, &size);
    std::string content(static_cast<char const*>(bytes), static_cast<std::size_t>(size));
    gdFree(bytes);
    gdImageDestroy(image);
    return content;
}

struct Written
{
    char const* name;
    std::string content;
    double tolerance; //!< of 255
};

std::vector<Written> all_formats()
{
    return {{"PNG", written([](gdImage* i, int* size) { return gdImagePngPtr(i, size); }), 0},
            {"JPEG", written([](gdImage* i, int* size) { return gdImageJpegPtr(i, size, 95); }), 3},
            {"BMP", written([](gdImage* i, int* size) { return gdImageBmpPtr(i, size, 0); }), 0}};
}

TEST(PictureFile, ReadsPngJpegAndBmp)
{
    for (auto const& [name, content, tolerance] : all_formats()) {
        auto const image = picture_file::read_picture(content, "a picture");
        ASSERT_EQ(image.columns, 26) << name;
        ASSERT_EQ(image.rows, 30) << name;
        for (int column = 0; column < 26; ++column)
            EXPECT_NEAR(255 * static_cast<double>(image.at(column, 17)), 255 - 10 * column, tolerance + 1e-4)
                << name << " " << column;
    }
}

TEST(PictureFile, RefusesWhatIsDamagedOrNoPicture)
{
    for (auto const& format : all_formats())
        for (std::size_t const part : {format.content.size() / 2, std::size_t{20}}) {
            try {
                picture_file::read_picture(format.content.substr(0, part), "half.picture");
                ADD_FAILURE() << format.name << " of " << part << " bytes was read";
            } catch (InputError const& error) {
                EXPECT_NE(std::string(error.what()).find("half.picture: damaged"), std::string::npos)
                    << error.what();
            }
        }
    EXPECT_THROW(picture_file::read_picture("", "empty"), InputError);
    EXPECT_THROW(picture_file::read_picture("GIF89a...", "a.gif"), InputError);
    EXPECT_THROW(picture_file::read_picture("/nowhere/a.png"), InputError);
}

TEST(PictureFile, MakesNoMemoryOfWhatAHeaderStates)
{
    auto formats = all_formats();
    auto const refusal = [](std::string const& content) -> std::string {
        try {
            picture_file::read_picture(content, "large");
        } catch (InputError const& error) {
            return error.what();
        }
        return "accepted";
    };
    std::string const four("\x00\x00\x40\x00", 4), back("\x00\x40\x00\x00", 4); // 16,384, either end first
    formats[0].content.replace(16, 8, four + four);
    auto const frame = formats[1].content.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    formats[1].content.replace(frame + 5, 4, "\x40\x01\x40\x01");
    formats[2].content.replace(18, 8, back + back);
    for (auto const& format : formats)
        EXPECT_NE(refusal(format.content).find("pixels; at most 150000000 are read"), std::string::npos)
            << format.name << " " << refusal(format.content);
    auto many = all_formats()[0].content;
    many.replace(16, 8, std::string("\x00\x00\x27\x10\x00\x00\x27\x10", 8)); // 10,000 x 10,000
    EXPECT_NE(refusal(many).find("states 100000000 pixels in"), std::string::npos) << refusal(many);
}

TEST(PictureFile, SeesColoursAsLumaAndTransparencyAsWhite)
{
    gdImage* const image = gdImageCreateTrueColor(2, 1);
    gdImageAlphaBlending(image, 0);
    gdImageSaveAlpha(image, 1);
    gdImageSetPixel(image, 0, 0, gdTrueColor(255, 0, 0));
    gdImageSetPixel(image, 1, 0, gdTrueColorAlpha(0, 0, 0, gdAlphaTransparent));
    int size = 0;
    void* const bytes = gdImagePngPtr(image, &size);
    auto const read = picture_file::read_picture(
        std::string(static_cast<char const*>(bytes), static_cast<std::size_t>(size)), "two pixels");
    gdFree(bytes);
    gdImageDestroy(image);
    EXPECT_NEAR(read.at(0, 0), 1 - 0.299, 1e-6);
    EXPECT_NEAR(read.at(1, 0), 0, 1e-6);
}

TEST(PictureFile, WritesGreyAndColours)
{
    auto const folder = std::filesystem::path(::testing::TempDir());
    observe::GreyImage grey(3, 2);
    grey.at(2, 1) = 1, grey.at(0, 1) = 0.2F;
    picture_file::write_png(folder / "grey.png", grey);
    auto const read = picture_file::read_picture(folder / "grey.png");
    ASSERT_EQ(read.darkness.size(), grey.darkness.size());
    for (std::size_t k = 0; k < grey.darkness.size(); ++k)
        EXPECT_FLOAT_EQ(read.darkness[k], grey.darkness[k]) << k;
    picture_file::write_png(folder / "colours.png",
                            picture_file::ColourImage{2, 1, {{0, 0, 255}, {255, 255, 255}}});
    EXPECT_NEAR(picture_file::read_picture(folder / "colours.png").at(0, 0), 1 - 0.114, 1e-6);
    EXPECT_THROW(picture_file::write_png("/nowhere/grey.png", grey), FileError);
    std::filesystem::remove(folder / "grey.png");
    std::filesystem::remove(folder / "colours.png");
}

TEST(PictureFile, IsToldByItsName)
{
    EXPECT_TRUE(picture_file::is_picture_file("a.JPG"));
    EXPECT_TRUE(picture_file::is_picture_file("b/a.bmp"));
    EXPECT_FALSE(picture_file::is_picture_file("a.tif"));
}

} // namespace
