// Text dumps as LIGGGHTS and LAMMPS write them: sections that begin with ITEM:, any number of time steps.
#include "src/observe/frame_file/formats.hpp"

#include "demens/base/text/file.hpp"
#include "demens/base/text/number.hpp"

#include <algorithm>
#include <array>

namespace demens::observe::frame_file {
namespace {

std::vector<std::string_view> words_in(std::string_view line)
{
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t const from = line.find_first_not_of(" \t\r", at);
        if (from == std::string_view::npos)
            break;
        at = std::min(line.size(), line.find_first_of(" \t\r", from));
        words.push_back(line.substr(from, at - from));
    }
    return words;
}

//! Where the coordinates and the size stand in a row.
struct Columns
{
    std::array<std::size_t, 3> place;
    std::size_t size;
    double radii;
    bool is_scaled; //!< coordinates are shares of the box
};

class Dump
{
  public:
    Dump(std::string const& content, std::string const& origin, double unit)
        : rest_(content), origin_(origin), unit_(unit)
    {
    }

    std::vector<SphereFrame> read()
    {
        std::vector<SphereFrame> frames;
        while (next_line()) {
            if (line_.substr(0, 5) != "ITEM:")
                refuse(fmt::format("\"{}\" stands where a section would begin with \"ITEM:\"",
                                   line_.substr(0, 40)));
            auto const section = text::trimmed(line_.substr(5));
            if (section.rfind("TIMESTEP", 0) == 0)
                time_step_ = text::trimmed(required_line("a time step"));
            else if (section.rfind("NUMBER OF ATOMS", 0) == 0)
                atoms_ = atoms(text::trimmed(required_line("a number of atoms")));
            else if (section.rfind("BOX BOUNDS", 0) == 0)
                read_box(section);
            else if (section.rfind("ATOMS", 0) == 0)
                frames.push_back(read_atoms(words_in(line_.substr(line_.find("ATOMS") + 5))));
            else
                required_line("what \"" + section + "\" says"); // UNITS, TIME: one line each
        }
        if (frames.empty())
            refuse("there is no \"ITEM: ATOMS\"");
        return frames;
    }

  private:
    [[noreturn]] void refuse(std::string const& why) const
    {
        throw InputError(fmt::format("{}:{}: {}", origin_, line_number_, why));
    }

    bool next_line()
    {
        do {
            if (rest_.empty())
                return false;
            std::size_t const end = std::min(rest_.find('\n'), rest_.size());
            line_ = rest_.substr(0, end);
            rest_.remove_prefix(std::min(rest_.size(), end + 1));
            ++line_number_;
        } while (line_.find_first_not_of(" \t\r") == std::string_view::npos);
        return true;
    }

    std::string_view required_line(std::string const& what)
    {
        if (!next_line() || line_.substr(0, 5) == "ITEM:")
            refuse(
                fmt::format("the file ends, or the next section begins, before {}: it is not whole", what));
        return line_;
    }

    double number(std::string_view word) const
    {
        if (auto const value = text::number_of(word))
            return *value;
        refuse(fmt::format("\"{}\" is not a number", word));
    }

    std::size_t atoms(std::string_view word) const
    {
        if (auto const count = count_of(word, rest_.size())) // a line each
            return *count;
        refuse(fmt::format("\"{}\" stands where a number of atoms would, within the size of the file", word));
    }

    void read_box(std::string const& section)
    {
        is_skewed_ = section.find("xy") != std::string::npos;
        for (auto& [low, high] : box_) {
            auto const words = words_in(required_line("the bounds of the box"));
            if (words.size() < 2)
                refuse("a bound of the box has two numbers");
            low = number(words[0]), high = number(words[1]);
        }
    }

    Columns columns_of(std::vector<std::string_view> const& names) const
    {
        auto const find = [&](std::string_view name) -> std::optional<std::size_t> {
            auto const at = std::find(names.begin(), names.end(), name);
            if (at == names.end())
                return std::nullopt;
            return static_cast<std::size_t>(at - names.begin());
        };
        auto const size = size_among([&](std::string_view name) { return find(name).has_value(); });
        if (!size)
            refuse(
                fmt::format("there is no column of radii among \"{}\"; add radius (or diameter) to the dump "
                            "command",
                            line_));
        for (std::string_view const suffix : {"", "u", "s"}) {
            auto const x = find(fmt::format("x{}", suffix)), y = find(fmt::format("y{}", suffix)),
                       z = find(fmt::format("z{}", suffix));
            if (!x || !y || !z)
                continue;
            if (suffix == "s" && is_skewed_)
                refuse("coordinates xs ys zs in a box that is not rectangular are not read; dump x y z");
            return {{*x, *y, *z}, *find(size->name), size->radii, suffix == "s"};
        }
        refuse(fmt::format("there are no coordinates among \"{}\"; add x y z to the dump command", line_));
    }

    SphereFrame read_atoms(std::vector<std::string_view> const& names)
    {
        auto const columns = columns_of(names);
        std::vector<double> coordinates, sizes;
        for (std::size_t k = 0; k < atoms_; ++k) {
            auto const words = words_in(required_line(fmt::format("atom {} of {}", k + 1, atoms_)));
            if (words.size() != names.size())
                refuse(fmt::format("{} values in a row of {} columns", words.size(), names.size()));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double const value = number(words[columns.place[axis]]);
                auto const& [low, high] = box_[axis];
                coordinates.push_back(columns.is_scaled ? low + value * (high - low) : value);
            }
            sizes.push_back(number(words[columns.size]));
        }
        auto const name = time_step_.empty() ? origin_ : fmt::format("{}, time step {}", origin_, time_step_);
        return {name, spheres_of(coordinates, sizes, columns.radii, unit_, name)};
    }

    std::string_view rest_, line_;
    std::string const& origin_;
    double unit_;
    int line_number_ = 0;
    std::string time_step_;
    std::size_t atoms_ = 0;
    std::array<std::array<double, 2>, 3> box_{};
    bool is_skewed_ = false;
};

} // namespace

std::vector<SphereFrame> read_dump(std::string const& content, std::string const& origin, double unit)
{
    return Dump(content, origin, unit).read();
}

} // namespace demens::observe::frame_file
