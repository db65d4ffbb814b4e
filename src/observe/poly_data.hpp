#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace demens::observe {

//! \throws InputError when it cannot be written
void write_frame_file(std::filesystem::path const& file, std::string const& content);

//! An XML PolyData file whose arrays are base64 in their places (VTK file formats, "binary" data): any reader
//! of XML can take it apart.
class PolyData
{
  public:
    PolyData(std::size_t points, double time) : points_(points), time_(time) {}

    void set_points(std::vector<float> const& xyz) { points_xml_ = array("Points", 3, xyz); }
    template <class T> // float or std::int64_t
    void add_point_data(std::string const& name, int components, std::vector<T> const& values)
    {
        point_data_xml_ += array(name, components, values);
    }
    template <class T>
    void add_cell_data(std::string const& name, int components, std::vector<T> const& values)
    {
        cell_data_xml_ += array(name, components, values);
    }
    //! Words of the whole file.
    void add_words(std::string const& name, std::vector<std::string> const& words);
    //! `kind` is Verts or Polys; cell i has the points from end i - 1 to end i.
    void set_cells(std::string const& kind, std::vector<std::int64_t> const& connectivity,
                   std::vector<std::int64_t> const& ends);
    void write(std::filesystem::path const& file) const;

  private:
    template <class T>
    static std::string array(std::string const& name, int components, std::vector<T> const& values)
    {
        return array_xml(name, sizeof(T) == 4 ? "Float32" : "Int64", components,
                         {reinterpret_cast<char const*>(values.data()), values.size() * sizeof(T)});
    }
    static std::string array_xml(std::string const& name, char const* type, int components,
                                 std::string_view bytes);

    std::size_t points_, cells_ = 0;
    double time_;
    std::string points_xml_, point_data_xml_, cell_data_xml_, words_xml_, cells_kind_, cells_xml_;
};

} // namespace demens::observe
