// Legacy VTK files, in text or binary (big-endian): POINTS, and an array of sizes among the data of the
// points.
#include "src/observe/frame_file/formats.hpp"
#include "src/observe/frame_file/vtk_types.hpp"

#include "demens/base/text/file.hpp"
#include "demens/base/text/number.hpp"

#include <map>

namespace demens::observe::frame_file {
namespace {

constexpr char const* blanks = " \t\r\n";

class LegacyFile
{
  public:
    LegacyFile(std::string const& content, std::string const& origin) : content_(content), origin_(origin) {}

    std::vector<SphereFrame> read(double unit)
    {
        line(), line(); // the mark and a title
        auto const form = text::trimmed(line());
        if (form != "ASCII" && form != "BINARY")
            refuse(fmt::format("its third line is \"{}\", neither ASCII nor BINARY", form.substr(0, 40)));
        is_binary_ = form == "BINARY";
        while (true) {
            auto const keyword = word();
            if (keyword.empty())
                break;
            take(keyword);
        }
        auto const size =
            size_among([&](std::string_view name) { return of_points_.count(std::string(name)) > 0; });
        if (!size)
            refuse("its points have no array \"radius\" or \"diameter\"");
        return {
            {origin_, spheres_of(points_, of_points_[std::string(size->name)], size->radii, unit, origin_)}};
    }

  private:
    [[noreturn]] void refuse(std::string const& why) const
    {
        throw InputError(fmt::format("{}: {}", origin_, why));
    }

    std::string_view line()
    {
        std::size_t const from = at_, end = std::min(content_.find('\n', at_), content_.size());
        at_ = std::min(content_.size(), end + 1);
        return content_.substr(from, end - from);
    }
    //! The next word, empty at the end.
    std::string_view word()
    {
        std::size_t const from = content_.find_first_not_of(blanks, at_);
        if (from == std::string_view::npos)
            return {};
        at_ = std::min(content_.find_first_of(blanks, from), content_.size());
        return content_.substr(from, at_ - from);
    }
    std::size_t count()
    {
        auto const text = word();
        if (auto const value = count_of(text, content_.size()))
            return *value;
        refuse(fmt::format("\"{}\" stands where a count would, within the size of the file", text));
    }
    std::vector<double> array(std::size_t values, std::string_view type_name)
    {
        auto const& type = vtk_type(type_name, origin_);
        std::vector<double> numbers;
        if (is_binary_) {
            line(); // what is left of the keyword's
            auto const bytes = content_.substr(std::min(at_, content_.size()), values * type.size);
            at_ += bytes.size();
            numbers = type.numbers(bytes, ByteOrder::big);
        } else {
            while (numbers.size() < values) {
                auto const text = word();
                auto const value = text::number_of(text);
                if (!value)
                    break;
                numbers.push_back(*value);
            }
        }
        if (numbers.size() != values)
            refuse(fmt::format("an array of {} values ends after {}: the file is not whole", values,
                               numbers.size()));
        return numbers;
    }
    void keep(std::string const& name, std::vector<double> values)
    {
        if (are_of_points_)
            of_points_[name] = std::move(values);
    }
    //! What a keyword says.
    void take(std::string_view keyword)
    {
        auto const is = [&](auto... names) { return ((keyword == names) || ...); };
        if (is("DATASET")) {
            if (auto const kind = word(); kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID")
                refuse(fmt::format("its data set is {}; POLYDATA and UNSTRUCTURED_GRID hold spheres", kind));
        } else if (is("POINTS")) {
            std::size_t const points = count();
            points_ = array(3 * points, word());
        } else if (is("VERTICES", "LINES", "POLYGONS", "TRIANGLE_STRIPS", "CELLS")) {
            std::size_t const cells = count(), values = count();
            cell_sizes_ = {cells, values};
            auto const after = at_;
            if (word() != "OFFSETS") { // as before version 5.1
                at_ = after;
                array(values, "int");
            } else
                array(cells, word());
        } else if (is("CONNECTIVITY"))
            array(cell_sizes_[1], word());
        else if (is("CELL_TYPES"))
            array(count(), "int");
        else if (is("POINT_DATA", "CELL_DATA"))
            are_of_points_ = keyword == "POINT_DATA", items_ = count();
        else if (is("SCALARS"))
            take_scalars();
        else if (is("VECTORS", "NORMALS", "TENSORS")) {
            word();
            auto const type = word();
            array((keyword == "TENSORS" ? 9 : 3) * items_, type);
        } else if (is("FIELD"))
            take_field();
        else if (is("LOOKUP_TABLE")) {
            word();
            array(4 * count(), "unsigned_char");
        } else if (is("METADATA")) {
            line(); // what is left of the keyword's; an empty line ends it
            while (at_ < content_.size() && !text::trimmed(line()).empty()) {
            }
        } else
            refuse(fmt::format("\"{}\" is not a keyword that is read", keyword.substr(0, 40)));
    }
    void take_scalars()
    {
        auto const name = std::string(word()), type = std::string(word());
        auto after = at_;
        std::size_t components = 1;
        if (auto const next = word(); next != "LOOKUP_TABLE") {
            at_ = after, components = count(), after = at_;
            if (word() != "LOOKUP_TABLE")
                refuse(fmt::format("the array {} lacks its LOOKUP_TABLE", name));
        }
        word(); // the table's name
        keep(name, array(components * items_, type));
    }
    void take_field()
    {
        word();
        for (std::size_t arrays = count(); arrays > 0; --arrays) {
            auto const name = std::string(word());
            if (name == "METADATA") {
                take(name);
                ++arrays;
                continue;
            }
            std::size_t const components = count(), tuples = count();
            keep(name, array(components * tuples, word()));
        }
    }

    std::string_view content_;
    std::string const& origin_;
    std::size_t at_ = 0;
    bool is_binary_ = false, are_of_points_ = false;
    std::size_t items_ = 0;
    std::array<std::size_t, 2> cell_sizes_{};
    std::vector<double> points_;
    std::map<std::string, std::vector<double>> of_points_;
};

} // namespace

std::vector<SphereFrame> read_vtk_legacy(std::string const& content, std::string const& origin, double unit)
{
    return LegacyFile(content, origin).read(unit);
}

} // namespace demens::observe::frame_file
