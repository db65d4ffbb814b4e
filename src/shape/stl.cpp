#include "demens/shape/stl.hpp"

#include "demens/base/error.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

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
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
        refuse(file, "there is no such STL file, or it cannot be read");
    std::ostringstream content;
    content << in.rdbuf();
    return content.str();
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
    std::size_t const start = content.find_first_not_of(" \t\r\n");
    return start != std::string::npos && content.compare(start, 5, "solid") == 0 &&
           content.find('\0') == std::string::npos;
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
    TriangleSoup soup(count);
    for (std::size_t k = 0; k < count; ++k) {
        float numbers[12]; // the normal, which the corners tell as well, and three corners
        std::memcpy(numbers, content.data() + header_size + k * record_size, sizeof(numbers));
        for (std::size_t c = 0; c < 3; ++c)
            soup[k][c] = {numbers[3 + 3 * c], numbers[4 + 3 * c], numbers[5 + 3 * c]};
    }
    return soup;
}

//! Reads word by word and knows the line that it is in.
class Words
{
  public:
    Words(std::filesystem::path const& file, std::string const& content) : file_(file), text_(content) {}

    //! The next word, empty at the end.
    std::string next()
    {
        constexpr char const* blanks = " \t\r\n";
        std::size_t const from = std::min(text_.find_first_not_of(blanks, at_), text_.size());
        for (; at_ < from; ++at_)
            line_ += text_[at_] == '\n';
        at_ = std::min(text_.find_first_of(blanks, from), text_.size());
        return text_.substr(from, at_ - from);
    }
    void expect(std::initializer_list<char const*> words)
    {
        for (char const* word : words) {
            std::string const found = next();
            if (found != word)
                refuse(file_,
                       found.empty()
                           ? fmt::format("truncated: ends before \"{}\" in line {}", word, line_)
                           : fmt::format("line {}: \"{}\" where \"{}\" is expected", line_, found, word));
        }
    }
    double number()
    {
        std::string const word = next();
        std::istringstream in(word);
        double value = 0;
        if (word.empty())
            refuse(file_, fmt::format("truncated: ends before a number in line {}", line_));
        if (!(in >> value) || !in.eof())
            refuse(file_, fmt::format("line {}: \"{}\" where a number is expected", line_, word));
        return value;
    }
    void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  private:
    std::filesystem::path const& file_;
    std::string const& text_;
    std::size_t at_ = 0, line_ = 1;
};

TriangleSoup read_ascii(std::filesystem::path const& file, std::string const& content)
{
    TriangleSoup soup;
    Words words(file, content);
    words.expect({"solid"});
    words.skip_line(); // the name
    for (std::string word = words.next(); word != "endsolid"; word = words.next()) {
        if (word.empty())
            refuse(file, "truncated: ends before \"endsolid\"");
        if (word != "facet")
            refuse(file, fmt::format("\"{}\" where \"facet\" or \"endsolid\" is expected, after {} triangles",
                                     word, soup.size()));
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
