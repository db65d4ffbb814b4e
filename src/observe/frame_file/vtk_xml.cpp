// VTK's XML files (.vtp, .vtu) with arrays in text or binary, inline or appended; not compressed.
#include "src/observe/frame_file/formats.hpp"
#include "src/observe/frame_file/vtk_types.hpp"

#include "demens/base/text/number.hpp"

#include <map>

namespace demens::observe::frame_file {
namespace {

//! A tag with its attributes, and where its content begins.
struct Tag
{
    std::string_view name; //!< with its slash when it closes
    std::map<std::string_view, std::string_view> attributes;
    std::size_t end; //!< one past its bracket

    std::string_view get(std::string_view key) const
    {
        auto const found = attributes.find(key);
        return found == attributes.end() ? std::string_view{} : found->second;
    }
};

//! The next tag from a position on, which moves behind it; none: there is none. Comments and declarations are
//! passed over.
std::optional<Tag> next_tag(std::string_view content, std::size_t& at)
{
    constexpr char const* blanks = " \t\r\n";
    while ((at = content.find('<', at)) != std::string_view::npos &&
           (content.substr(at, 2) == "<?" || content.substr(at, 2) == "<!"))
        ++at;
    std::size_t const end = at == std::string_view::npos ? at : content.find('>', at);
    if (end == std::string_view::npos)
        return std::nullopt;
    auto rest = content.substr(at + 1, end - at - 1);
    std::size_t const name_end = std::min(rest.find_first_of(blanks), rest.size());
    at = end + 1;
    Tag tag{rest.substr(0, name_end), {}, at};
    rest.remove_prefix(name_end);
    while (true) {
        std::size_t const equals = rest.find('='), open = rest.find_first_of("\"'", equals);
        if (equals == std::string_view::npos || open == std::string_view::npos)
            return tag;
        std::size_t const close = rest.find(rest[open], open + 1);
        if (close == std::string_view::npos)
            return tag;
        auto const from = rest.find_first_not_of(blanks);
        auto key = rest.substr(from, equals - from);
        key = key.substr(0, std::min(key.find_first_of(blanks), key.size()));
        tag.attributes[key] = rest.substr(open + 1, close - open - 1);
        rest.remove_prefix(close + 1);
    }
}

//! Bytes of a text in base 64, up to what is not of its alphabet; padding ends a group, after which another
//! may begin, as where a count is encoded by itself.
std::string from_base64(std::string_view text)
{
    constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (char const c : text) {
        auto const value = alphabet.find(c);
        if (value == std::string_view::npos) {
            if (c == '=')
                bits = 0, held = 0;
            else if (c != ' ' && c != '\n' && c != '\r' && c != '\t')
                break;
            continue;
        }
        bits = bits << 6 | static_cast<std::uint32_t>(value), held += 6;
        if (held >= 8)
            held -= 8, bytes.push_back(static_cast<char>(bits >> held & 0xFF));
    }
    return bytes;
}

class XmlFile
{
  public:
    XmlFile(std::string const& content, std::string const& origin) : content_(content), origin_(origin) {}

    std::vector<SphereFrame> read(double unit)
    {
        // Raw appended bytes may look like tags: what is before them is read alone.
        std::size_t const appended = content_.find("<AppendedData");
        text_ = content_.substr(0, std::min(appended, content_.size()));
        if (appended != std::string_view::npos) {
            std::size_t after = appended;
            auto const tag = next_tag(content_, after);
            appended_is_raw_ = tag && tag->get("encoding") == "raw";
            std::size_t const mark = tag ? content_.find('_', tag->end) : std::string_view::npos;
            if (mark != std::string_view::npos)
                appended_ = content_.substr(mark + 1);
        }
        std::vector<double> points, sizes;
        std::optional<SizeName> size;
        std::string_view section;
        std::size_t at = 0;
        while (auto const tag = next_tag(text_, at)) {
            if (tag->name == "VTKFile")
                take_head(*tag);
            else if (tag->name == "Points" || tag->name == "PointData" || tag->name == "/Points" ||
                     tag->name == "/PointData")
                section = tag->name;
            else if (tag->name == "DataArray" && section == "Points")
                append(points, numbers(*tag));
            else if (tag->name == "DataArray" && section == "PointData") {
                auto const found =
                    size_among([&](std::string_view name) { return tag->get("Name") == name; });
                if (found && (!size || size->name == found->name)) {
                    size = found;
                    append(sizes, numbers(*tag));
                }
            }
        }
        if (!size)
            refuse("its points have no array \"radius\" or \"diameter\"");
        return {{origin_, spheres_of(points, sizes, size->radii, unit, origin_)}};
    }

  private:
    [[noreturn]] void refuse(std::string const& why) const
    {
        throw InputError(fmt::format("{}: {}", origin_, why));
    }

    static void append(std::vector<double>& all, std::vector<double> const& more)
    {
        all.insert(all.end(), more.begin(), more.end());
    }

    void take_head(Tag const& tag)
    {
        if (!tag.get("compressor").empty())
            refuse("its arrays are compressed; write the file without compression (ParaView: Compressor Type "
                   "None)");
        order_ = tag.get("byte_order") == "BigEndian" ? ByteOrder::big : ByteOrder::little;
        head_size_ = tag.get("header_type") == "UInt64" ? 8 : 4;
    }

    //! What a count of bytes, in front of them, lets through.
    std::string_view counted(std::string_view bytes) const
    {
        auto const head = bytes.substr(0, head_size_);
        auto const count = head_size_ == 8 ? numbers_in<std::uint64_t>(head, order_)
                                           : numbers_in<std::uint32_t>(head, order_);
        if (count.empty() || count[0] > static_cast<double>(bytes.size() - head_size_))
            refuse("an array goes on beyond its bytes: the file is not whole");
        return bytes.substr(head_size_, static_cast<std::size_t>(count[0]));
    }

    std::vector<double> numbers(Tag const& tag) const
    {
        auto const& type = vtk_type(tag.get("type"), origin_);
        auto const format = tag.get("format");
        auto const inside = text_.substr(tag.end, text_.find('<', tag.end) - tag.end);
        if (format == "ascii")
            return numbers_written(inside);
        if (format == "binary")
            return type.numbers(counted(from_base64(inside)), order_);
        if (format != "appended")
            refuse(fmt::format("an array has the format \"{}\", not ascii, binary or appended", format));
        auto const offset = count_of(tag.get("offset"), appended_.size());
        if (!offset || *offset == appended_.size())
            refuse(
                fmt::format("an array's offset \"{}\" is not within the appended data", tag.get("offset")));
        auto const from = appended_.substr(*offset);
        return type.numbers(appended_is_raw_ ? counted(from) : counted(from_base64(from)), order_);
    }

    std::vector<double> numbers_written(std::string_view text) const
    {
        std::vector<double> numbers;
        constexpr char const* blanks = " \t\r\n";
        for (std::size_t at = 0; (at = text.find_first_not_of(blanks, at)) != std::string_view::npos;) {
            std::size_t const end = std::min(text.find_first_of(blanks, at), text.size());
            auto const value = text::number_of(text.substr(at, end - at));
            if (!value)
                refuse(fmt::format("\"{}\" in an array is not a number", text.substr(at, end - at)));
            numbers.push_back(*value);
            at = end;
        }
        return numbers;
    }

    std::string_view content_, text_, appended_;
    std::string const& origin_;
    ByteOrder order_ = ByteOrder::little;
    std::size_t head_size_ = 4;
    bool appended_is_raw_ = false;
};

} // namespace

std::vector<SphereFrame> read_vtk_xml(std::string const& content, std::string const& origin, double unit)
{
    return XmlFile(content, origin).read(unit);
}

std::vector<std::string> files_of_collection(std::string const& content, std::string const& origin)
{
    std::vector<std::string> files;
    std::size_t at = 0;
    while (auto const tag = next_tag(content, at))
        if (tag->name == "DataSet")
            files.emplace_back(tag->get("file"));
    if (files.empty())
        throw InputError(fmt::format("{}: the collection names no files", origin));
    return files;
}

} // namespace demens::observe::frame_file
