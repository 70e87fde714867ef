// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

// VTK's file format (Kitware, "VTK File Formats", XML), unstructured grid, appended raw data, each
// array cut into blocks that zlib compresses one by one.
namespace spricka::report {

/// One array as VTK wants it: number of blocks, block size, size of the last block if it is not
/// full, compressed sizes, compressed blocks. Of measured numbers runs alone are looked for.
std::string compress_array(std::string_view data, bool measured);

/// The head that names the arrays and the data they point to.
class VtuDocument {
public:
  /// Adds an array with its head: VTK's name of the type, components, and their names if given.
  template <class T>
  void add_array(std::string_view name, std::string_view type, int components,
                 const std::vector<T>& values, std::span<const std::string_view> names = {}) {
    head_ += fmt::format(R"(        <DataArray type="{}" Name="{}")", type, name);
    if (components > 1) {
      head_ += fmt::format(R"( NumberOfComponents="{}")", components);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      head_ += fmt::format(R"( ComponentName{}="{}")", i, names[i]);
    }
    head_ += fmt::format(" format=\"appended\" offset=\"{}\"/>\n", data_.size());
    data_ +=
        compress_array({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)},
                       std::is_floating_point_v<T>);
  }
  /// Adds a line to the head as it is.
  void add_line(std::string_view text) { (head_ += text) += '\n'; }

  /// Head and appended data, closed as one VTK file.
  [[nodiscard]] std::string document_text() const {
    return head_ + "  <AppendedData encoding=\"raw\">\n_" + data_ +
           "\n  </AppendedData>\n</VTKFile>\n";
  }

private:
  std::string head_;
  std::string data_;
};

/// The points of a picture: nodes that an element uses, renumbered without holes (cutting a crack
/// leaves some unused).
struct VtuGridPoints {
  std::vector<std::size_t> node;   ///< [point] mesh node
  std::vector<std::size_t> source; ///< [point] where its stress stands in the results
  std::vector<std::int64_t> point; ///< [node] its first point, or -1
  std::vector<std::int64_t> point_at_connectivity; ///< [connectivity index] point
};

/// One point for each node; `split`: one more for each further property that meets there.
VtuGridPoints make_vtu_grid_points(const model::Mesh& mesh, bool split);

/// A document with the grid: its points, and its cells of all types in VTK's node order. Cell data,
/// point data and finish_vtu_text() are to follow.
VtuDocument begin_vtu_grid(const model::Mesh& mesh, const VtuGridPoints& points);
/// Net and number of each cell, as arrays within <CellData>.
void add_cell_numbers(VtuDocument& document, const model::Mesh& mesh);
/// A document with points and triangles between them, three places for each.
VtuDocument begin_vtu_triangles(const std::vector<double>& x,
                                const std::vector<std::int64_t>& corners);
/// The same of straight lines. [3 * point], [2 * line]
VtuDocument begin_vtu_lines(const std::vector<double>& x, const std::vector<std::int64_t>& ends);
/// Closes the grid of a document and returns the whole file.
std::string finish_vtu_text(VtuDocument& document);

} // namespace spricka::report
