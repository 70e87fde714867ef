// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/vtu_grid.hpp"

#include "base/deflater.hpp"
#include "model/property_points.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace spricka::report {
namespace {

using base::ElementType;

/// VTK's cell numbers, in the order of base::ElementType.
constexpr std::array<std::uint8_t, 12> vtk_cell{5, 22, 9, 23, 28, 10, 24, 13, 26, 12, 25, 29};

/// VTK counts the faces of its 27-node hexahedron x- x+ y- y+ z- z+; [VTK node - 20] our node.
constexpr std::array<std::size_t, 6> hexec27_faces{25, 23, 22, 24, 20, 21};

/// The first triangle of VTK's wedges turns outwards, ours inwards; [VTK node] our node. (VTK's
/// faces and volumes go by that; its interpolation does not mind.)
constexpr std::array<std::size_t, 15> wedge_order{0, 2, 1, 3, 5, 4, 8, 7, 6, 11, 10, 9, 12, 14, 13};

constexpr std::size_t block_size = std::size_t{1} << 18;

void append_word(std::string& bytes, std::uint64_t word) {
  std::array<char, sizeof word> raw{};
  std::memcpy(raw.data(), &word, sizeof word);
  bytes.append(raw.data(), raw.size());
}

/// Our place of VTK's node i of an element.
std::size_t place_of(ElementType type, std::size_t i) {
  if (type == ElementType::penta6 || type == ElementType::pentac15) {
    return wedge_order[i];
  }
  const bool face = type == ElementType::hexec27 && i >= 20 && i < 26;
  return face ? hexec27_faces[i - 20] : i;
}

void add_cells(VtuDocument& document, const model::Mesh& mesh, const VtuGridPoints& points) {
  std::vector<std::int64_t> connectivity(mesh.nodes.size());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto first = static_cast<std::size_t>(mesh.first[e]);
    for (std::size_t i = 0; i < mesh.element_nodes(base::ElementId(e)).size(); ++i) {
      connectivity[first + i] = points.point_at_connectivity[first + place_of(mesh.type[e], i)];
    }
  }
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    offsets.push_back(mesh.first[e + 1]);
    types.push_back(vtk_cell[static_cast<std::size_t>(mesh.type[e])]);
  }
  document.add_line("      <Cells>");
  document.add_array("connectivity", "Int64", 1, connectivity);
  document.add_array("offsets", "Int64", 1, offsets);
  document.add_array("types", "UInt8", 1, types);
  document.add_line("      </Cells>");
}

} // namespace

std::string compress_array(std::string_view data, bool measured) {
  const std::size_t blocks = (data.size() + block_size - 1) / block_size;
  std::string packed;
  std::string sizes;
  base::Deflater deflater(measured ? base::RepetitionSearch::runs : base::RepetitionSearch::quick,
                          block_size);
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::string_view block = deflater.pack(data.substr(b * block_size, block_size));
    append_word(sizes, block.size());
    packed.append(block);
  }
  std::string bytes;
  append_word(bytes, blocks);
  append_word(bytes, block_size);
  append_word(bytes, data.size() % block_size);
  return bytes + sizes + packed;
}

VtuGridPoints make_vtu_grid_points(const model::Mesh& mesh, bool split) {
  model::FieldPointsByProperty sources;
  if (split) {
    sources = model::property_points(mesh);
  } else {
    for (const base::NodeId n : mesh.nodes) {
      sources.of.push_back(n.value);
    }
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      sources.node.emplace_back(n);
    }
  }
  std::vector<std::int64_t> point(sources.node.size(), -1);
  for (const std::int32_t source : sources.of) {
    point[static_cast<std::size_t>(source)] = 0;
  }
  VtuGridPoints points;
  for (std::size_t s = 0; s < point.size(); ++s) {
    if (point[s] == 0) {
      point[s] = static_cast<std::int64_t>(points.node.size());
      points.node.push_back(sources.node[s].index());
      points.source.push_back(s);
    }
  }
  for (const std::int32_t source : sources.of) {
    points.point_at_connectivity.push_back(point[static_cast<std::size_t>(source)]);
  }
  point.resize(mesh.node_count()); // the nodes' own come first
  points.point = std::move(point);
  return points;
}

namespace {

VtuDocument begin_grid(const std::vector<double>& x, std::size_t cells) {
  VtuDocument document;
  document.add_line("<?xml version=\"1.0\"?>");
  document.add_line(
      fmt::format("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
                  "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">",
                  std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"));
  document.add_line("  <UnstructuredGrid>");
  document.add_line(
      fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">", x.size() / 3, cells));
  document.add_line("      <Points>");
  document.add_array("Points", "Float64", 3, x);
  document.add_line("      </Points>");
  return document;
}

struct CellKind {
  std::size_t points = 0;
  std::uint8_t type = 0;
};

// Cells of one kind, their points one after another.
VtuDocument simple_cells(const std::vector<double>& x, const std::vector<std::int64_t>& points,
                         const CellKind& kind) {
  const std::size_t cells = points.size() / kind.points;
  VtuDocument document = begin_grid(x, cells);
  std::vector<std::int64_t> offsets;
  for (std::size_t c = 1; c <= cells; ++c) {
    offsets.push_back(static_cast<std::int64_t>(c * kind.points));
  }
  document.add_line("      <Cells>");
  document.add_array("connectivity", "Int64", 1, points);
  document.add_array("offsets", "Int64", 1, offsets);
  document.add_array("types", "UInt8", 1, std::vector<std::uint8_t>(cells, kind.type));
  document.add_line("      </Cells>");
  return document;
}

} // namespace

VtuDocument begin_vtu_grid(const model::Mesh& mesh, const VtuGridPoints& points) {
  std::vector<double> x;
  for (const std::size_t n : points.node) {
    x.insert(x.end(), mesh.x[n].data(), mesh.x[n].data() + 3);
  }
  VtuDocument document = begin_grid(x, mesh.element_count());
  add_cells(document, mesh, points);
  return document;
}

VtuDocument begin_vtu_triangles(const std::vector<double>& x,
                                const std::vector<std::int64_t>& corners) {
  return simple_cells(x, corners, {3, vtk_cell[static_cast<std::size_t>(ElementType::trim3)]});
}

VtuDocument begin_vtu_lines(const std::vector<double>& x, const std::vector<std::int64_t>& ends) {
  constexpr std::uint8_t line = 3; // VTK_LINE
  return simple_cells(x, ends, {2, line});
}

void add_cell_numbers(VtuDocument& document, const model::Mesh& mesh) {
  std::vector<std::int64_t> net;
  std::vector<std::int64_t> label;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    net.push_back(mesh.element_net[e].value);
    label.push_back(mesh.element_label[e]);
  }
  document.add_array("net", "Int64", 1, net);
  document.add_array("label", "Int64", 1, label);
}

std::string finish_vtu_text(VtuDocument& document) {
  document.add_line("    </Piece>");
  document.add_line("  </UnstructuredGrid>");
  return document.document_text();
}

} // namespace spricka::report
