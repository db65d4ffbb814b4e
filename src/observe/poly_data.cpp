#include "src/observe/poly_data.hpp"

#include "demens/base/error.hpp"

#include <bit>
#include <fmt/format.h>
#include <fstream>

namespace demens::observe {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say LittleEndian");

//! RFC 4648.
std::string to_base64(std::string_view bytes)
{
    constexpr char const* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::size_t const left = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < left ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= left ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

} // namespace

void write_frame_file(std::filesystem::path const& file, std::string const& content)
{
    std::ofstream out(file, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.close();
    if (!out)
        throw InputError(
            fmt::format("{}: a frame cannot be written; give a folder that is writable and has room "
                        "for it ({} bytes)",
                        file.string(), content.size()));
}

void PolyData::set_cells(std::string const& kind, std::vector<std::int64_t> const& connectivity,
                         std::vector<std::int64_t> const& ends)
{
    cells_ = ends.size();
    cells_kind_ = kind;
    cells_xml_ = array("connectivity", 1, connectivity) + array("offsets", 1, ends);
}

std::string PolyData::array_xml(std::string const& name, char const* type, int components,
                                std::string_view bytes)
{
    std::uint64_t const length = bytes.size();
    std::string block(reinterpret_cast<char const*>(&length), sizeof(length));
    block += bytes;
    return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n{}\n"
                       "</DataArray>\n",
                       type, name, components, to_base64(block));
}

//! As VTK writes them: codes of the letters, each word ends with 0.
void PolyData::add_words(std::string const& name, std::vector<std::string> const& words)
{
    std::string codes;
    for (auto const& word : words) {
        for (char const letter : word)
            codes += fmt::format("{} ", static_cast<unsigned char>(letter));
        codes += "0 ";
    }
    words_xml_ += fmt::format("<Array type=\"String\" Name=\"{}\" NumberOfTuples=\"{}\" "
                              "format=\"ascii\">{}</Array>\n",
                              name, words.size(), codes);
}

void PolyData::write(std::filesystem::path const& file) const
{
    std::string counts;
    for (char const* kind : {"Verts", "Lines", "Strips", "Polys"})
        counts += fmt::format(" NumberOf{}=\"{}\"", kind, cells_kind_ == kind ? cells_ : 0);
    write_frame_file(
        file,
        fmt::format("<?xml version=\"1.0\"?>\n"
                    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
                    "header_type=\"UInt64\">\n<PolyData>\n"
                    "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                    "format=\"ascii\">{}</DataArray>\n{}</FieldData>\n"
                    "<Piece NumberOfPoints=\"{}\"{}>\n<Points>\n{}</Points>\n<PointData>\n{}</PointData>\n"
                    "<CellData>\n{}</CellData>\n"
                    "<{}>\n{}</{}>\n</Piece>\n</PolyData>\n</VTKFile>\n",
                    time_, words_xml_, points_, counts, points_xml_, point_data_xml_, cell_data_xml_,
                    cells_kind_, cells_xml_, cells_kind_));
}

} // namespace demens::observe
