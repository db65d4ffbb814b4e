#include "demens/shape/stl.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/file.hpp"
#include "demens/base/text/number.hpp"

#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace demens::shape {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little endian");

constexpr std::size_t header_size = 84,
                      record_size = 50; // 80 bytes of text and the count; 12 floats and 2 bytes

[[noreturn]] void refuse(std::filesystem::path const& file, std::string const& what)
{
    throw InputError(fmt::format("{}: {}", file.string(), what));
}

std::string content_of(std::filesystem::path const& file)
{
    return text::read_file(file, "STL file");
}

std::size_t binary_count(std::string const& content)
{
    std::uint32_t count = 0;
    std::memcpy(&count, content.data() + header_size - sizeof(count), sizeof(count));
    return count;
}

//! A binary file can begin with "solid" too; its length then tells.
bool is_ascii(std::string const& content)
{
    if (content.size() >= header_size && content.size() == header_size + record_size * binary_count(content))
        return false;
    std::size_t const start = std::min(content.find_first_not_of("\xEF\xBB\xBF \t\r\n"), content.size());
    return text::lower_case(content.substr(start, 5)) == "solid" && content.find('\0') == std::string::npos;
}

TriangleSoup read_binary(std::filesystem::path const& file, std::string const& content)
{
    if (content.size() < header_size)
        refuse(file,
               fmt::format(
                   "not an STL file: {} bytes, neither text that begins with \"solid\" nor the {} bytes of "
                   "a binary header",
                   content.size(), header_size));
    std::size_t const count = binary_count(content), expected = header_size + record_size * count;
    if (content.size() < expected)
        refuse(file, fmt::format("truncated, or not an STL file: {} triangles need {} bytes, it has {}",
                                 count, expected, content.size()));
    if (std::size_t const held = (content.size() - header_size) / record_size; held > count)
        refuse(file,
               fmt::format("its header says {} triangles, but its {} bytes hold {}; write the file again, or "
                           "put the right count into bytes 81 to 84",
                           count, content.size(), held));
    TriangleSoup soup(count);
    for (std::size_t k = 0; k < count; ++k) {
        float numbers[12]; // the normal, which the corners tell as well, and three corners
        std::memcpy(numbers, content.data() + header_size + k * record_size, sizeof(numbers));
        for (std::size_t c = 0; c < 3; ++c)
            soup[k][c] = {numbers[3 + 3 * c], numbers[4 + 3 * c], numbers[5 + 3 * c]};
    }
    return soup;
}

//! Reads word by word and knows the line that it is in. Capitals do not count.
class Words
{
  public:
    Words(std::filesystem::path const& file, std::string const& content)
        : file_(file), text_(text::plain_text(content, file.string()))
    {
    }

    //! The next word in small letters, empty at the end.
    std::string next()
    {
        constexpr char const* blanks = " \t\n";
        std::size_t const from = std::min(text_.find_first_not_of(blanks, at_), text_.size());
        for (; at_ < from; ++at_)
            line_ += text_[at_] == '\n';
        at_ = std::min(text_.find_first_of(blanks, from), text_.size());
        return text::lower_case(std::string_view(text_).substr(from, at_ - from));
    }
    void expect(std::initializer_list<char const*> words)
    {
        for (char const* word : words) {
            std::string const found = next();
            if (found != word)
                unexpected(found, fmt::format("\"{}\"", word));
        }
    }
    double number()
    {
        std::string const word = next();
        auto const value = text::number_of(word);
        if (!value)
            unexpected(word, "a number");
        return *value;
    }
    //! The name of a solid ends with its line; a file in one line goes on with its facets.
    void skip_name()
    {
        auto const end = std::min(text_.find('\n', at_), text_.size());
        auto const facets =
            text::lower_case(std::string_view(text_).substr(at_, end - at_)).find(" facet normal ");
        at_ = facets == std::string::npos ? end : at_ + facets;
    }
    //! What follows `endsolid` in its line; facets there would be lost.
    void skip_closing_name()
    {
        skip_name();
        if (at_ < text_.size() && text_[at_] != '\n')
            refuse(file_, fmt::format("line {}: facets follow \"endsolid\" in its line", line_));
    }
    //! \throws InputError that says what was found, and what should have been there
    [[noreturn]] void unexpected(std::string const& found, std::string const& expected) const
    {
        refuse(file_, found.empty()
                          ? fmt::format("truncated: ends before {} in line {}", expected, line_)
                          : fmt::format("line {}: \"{}\" where {} is expected", line_, found, expected));
    }

  private:
    std::filesystem::path const& file_;
    std::string text_;
    std::size_t at_ = 0, line_ = 1;
};

//! The facets of a solid behind its name, up to `endsolid` and its name.
void read_solid(Words& words, TriangleSoup& soup)
{
    for (std::string word = words.next(); word != "endsolid"; word = words.next()) {
        if (word != "facet")
            words.unexpected(word, word.empty() ? "\"endsolid\"" : "\"facet\" or \"endsolid\"");
        words.expect({"normal"});
        for (int k = 0; k < 3; ++k)
            words.next(); // the corners tell the normal as well, and some programs write nan
        words.expect({"outer", "loop"});
        auto& triangle = soup.emplace_back();
        for (Vector3& corner : triangle) {
            words.expect({"vertex"});
            corner.x = words.number();
            corner.y = words.number();
            corner.z = words.number();
        }
        words.expect({"endloop", "endfacet"});
    }
    words.skip_closing_name();
}

//! The triangles of all solids: CAD programs write a solid a part.
TriangleSoup read_ascii(std::filesystem::path const& file, std::string const& content)
{
    TriangleSoup soup;
    Words words(file, content);
    for (std::string word = words.next(); !word.empty(); word = words.next()) {
        if (word != "solid")
            words.unexpected(word, "\"solid\" or the end of the file");
        words.skip_name();
        read_solid(words, soup);
    }
    return soup;
}

} // namespace

TriangleSoup read_stl(std::filesystem::path const& file)
{
    return read_stl(file, content_of(file));
}

TriangleSoup read_stl(std::filesystem::path const& file, std::string const& content)
{
    return is_ascii(content) ? read_ascii(file, content) : read_binary(file, content);
}

std::shared_ptr<TriangleMesh const> load_mesh(std::filesystem::path const& file,
                                              MeshPlacement const& placement)
{
    return load_mesh(file, content_of(file), placement);
}

std::shared_ptr<TriangleMesh const> load_mesh(std::filesystem::path const& file, std::string const& content,
                                              MeshPlacement const& placement)
{
    TriangleSoup soup = read_stl(file, content);
    for (auto& triangle : soup)
        for (Vector3& corner : triangle)
            corner = placement.placement(placement.scale * corner);
    try {
        return std::make_shared<TriangleMesh>(soup);
    } catch (InputError const& error) {
        refuse(file, error.what());
    }
}

std::string check_within(TriangleMesh const& mesh, Vector3 const& lower, Vector3 const& upper)
{
    auto const box = [](Vector3 const& a, Vector3 const& b) {
        return fmt::format("({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m", a.x, a.y, a.z, b.x, b.y,
                           b.z);
    };
    Bounds const& bounds = mesh.bounds();
    auto const outside = [&](double Vector3::*along) {
        return bounds.upper.*along < lower.*along || bounds.lower.*along > upper.*along;
    };
    auto const beyond = [&](double Vector3::*along) {
        return bounds.lower.*along < lower.*along || bounds.upper.*along > upper.*along;
    };
    std::string const where = fmt::format("the mesh reaches from {}, the domain from {}",
                                          box(bounds.lower, bounds.upper), box(lower, upper));
    if (outside(&Vector3::x) || outside(&Vector3::y) || outside(&Vector3::z))
        throw InputError("no part of the mesh is in the domain: " + where +
                         "; is its scale or its shift right?");
    if (beyond(&Vector3::x) || beyond(&Vector3::y) || beyond(&Vector3::z))
        return "a part of the mesh is outside the domain: " + where;
    return "";
}

} // namespace demens::shape
