// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/file.hpp"
#include "report/report.hpp"
#include "report/table.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <system_error>

// The format: VTK's file formats (Kitware, "VTK File Formats", XML), unstructured grid, appended
// raw data, each array cut into blocks that zlib compresses one by one.

namespace spricka::report {
namespace {

using base::ElementType;

/// VTK's cell numbers, in the order of base::ElementType.
constexpr std::array<std::uint8_t, 12> vtk_cell{5, 22, 9, 23, 28, 10, 24, 13, 26, 12, 25, 29};

/// VTK counts the faces of its 27-node hexahedron x- x+ y- y+ z- z+; [VTK node - 20] our node.
constexpr std::array<std::size_t, 6> hexec27_faces{25, 23, 22, 24, 20, 21};

constexpr std::size_t block_size = std::size_t{1} << 18;

void append_word(std::string& bytes, std::uint64_t word) {
  std::array<char, sizeof word> raw{};
  std::memcpy(raw.data(), &word, sizeof word);
  bytes.append(raw.data(), raw.size());
}

/// One array as VTK wants it: number of blocks, block size, size of the last block if it is not
/// full, compressed sizes, compressed blocks.
std::string compress_array(std::string_view data) {
  const std::size_t blocks = (data.size() + block_size - 1) / block_size;
  std::string packed;
  std::string sizes;
  std::string buffer(compressBound(block_size), '\0');
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::string_view block = data.substr(b * block_size, block_size);
    uLongf length = static_cast<uLongf>(buffer.size());
    const int status = compress2(reinterpret_cast<Bytef*>(buffer.data()), &length,
                                 reinterpret_cast<const Bytef*>(block.data()),
                                 static_cast<uLong>(block.size()), Z_DEFAULT_COMPRESSION);
    if (status != Z_OK) {
      throw std::system_error(ENOMEM, std::generic_category(), "zlib");
    }
    append_word(sizes, length);
    packed.append(buffer.data(), length);
  }
  std::string bytes;
  append_word(bytes, blocks);
  append_word(bytes, block_size);
  append_word(bytes, data.size() % block_size);
  return bytes + sizes + packed;
}

/// The head that names the arrays and the data they point to.
class Document {
public:
  template <class T>
  void add(std::string_view name, std::string_view type, int components,
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
        compress_array({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }
  void line(std::string_view text) { (head_ += text) += '\n'; }

  [[nodiscard]] std::string finish() const {
    return head_ + "  <AppendedData encoding=\"raw\">\n_" + data_ +
           "\n  </AppendedData>\n</VTKFile>\n";
  }

private:
  std::string head_;
  std::string data_;
};

/// Nodes that an element uses, renumbered without holes: cutting a crack leaves some unused.
struct UsedNodes {
  std::vector<std::size_t> node;   ///< [point] mesh node
  std::vector<std::int64_t> point; ///< [node] point, or -1
};

UsedNodes used_nodes(const model::Mesh& mesh) {
  UsedNodes used;
  used.point.assign(mesh.node_count(), -1);
  for (const base::NodeId n : mesh.nodes) {
    used.point[n.index()] = 0;
  }
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (used.point[n] == 0) {
      used.point[n] = static_cast<std::int64_t>(used.node.size());
      used.node.push_back(n);
    }
  }
  return used;
}

void add_cells(Document& document, const model::Mesh& mesh, const UsedNodes& used) {
  std::vector<std::int64_t> connectivity(mesh.nodes.size());
  std::transform(mesh.nodes.begin(), mesh.nodes.end(), connectivity.begin(),
                 [&](base::NodeId n) { return used.point[n.index()]; });
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.type[e] == ElementType::hexec27) {
      const std::span<const base::NodeId> nodes = mesh.nodes_of(base::ElementId(e));
      const std::size_t first_face = static_cast<std::size_t>(mesh.first[e]) + 20;
      for (std::size_t f = 0; f < hexec27_faces.size(); ++f) {
        connectivity[first_face + f] = used.point[nodes[hexec27_faces[f]].index()];
      }
    }
  }
  std::vector<std::int64_t> offsets;
  std::vector<std::uint8_t> types;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    offsets.push_back(mesh.first[e + 1]);
    types.push_back(vtk_cell[static_cast<std::size_t>(mesh.type[e])]);
  }
  document.line("      <Cells>");
  document.add("connectivity", "Int64", 1, connectivity);
  document.add("offsets", "Int64", 1, offsets);
  document.add("types", "UInt8", 1, types);
  document.line("      </Cells>");
  std::vector<std::int64_t> net;
  std::vector<std::int64_t> label;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    net.push_back(mesh.element_net[e].value);
    label.push_back(mesh.element_label[e]);
  }
  document.line("      <CellData Scalars=\"net\">");
  document.add("net", "Int64", 1, net);
  document.add("label", "Int64", 1, label);
  document.line("      </CellData>");
}

double von_mises(const std::array<double, 6>& s) {
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(0.5 * ((s[0] - s[1]) * (s[0] - s[1]) + (s[1] - s[2]) * (s[1] - s[2]) +
                          (s[2] - s[0]) * (s[2] - s[0])) +
                   3.0 * shear);
}

void add_point_data(Document& document, const model::Mesh& mesh, const UsedNodes& used,
                    const results::StepResult& step) {
  const auto dim = static_cast<std::size_t>(mesh.dim);
  std::vector<double> displacement;
  std::vector<double> stress;
  std::vector<double> mises;
  std::vector<std::int64_t> label;
  const bool moved = step.u.size() == static_cast<Eigen::Index>(dim * mesh.node_count());
  const bool stressed = step.stress.size() == mesh.node_count();
  for (const std::size_t n : used.node) {
    label.push_back(mesh.node_label[n]);
    for (std::size_t i = 0; i < 3 && moved; ++i) {
      displacement.push_back(i < dim ? step.u[static_cast<Eigen::Index>(dim * n + i)] : 0.0);
    }
    if (stressed) {
      stress.insert(stress.end(), step.stress[n].begin(), step.stress[n].end());
      mises.push_back(von_mises(step.stress[n]));
    }
  }
  constexpr std::array<std::string_view, 6> component{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
  document.line("      <PointData>");
  if (moved) {
    document.add("displacement", "Float64", 3, displacement);
  }
  if (stressed) {
    document.add("stress", "Float64", 6, stress, component);
    document.add("von_mises", "Float64", 1, mises);
  }
  document.add("label", "Int64", 1, label);
  document.line("      </PointData>");
}

} // namespace

void write_vtu(const std::filesystem::path& file, const model::Model& /*model*/,
               const results::Increment& increment, const results::StepResult& step) {
  const model::Mesh& mesh = increment.mesh;
  const UsedNodes used = used_nodes(mesh);
  Document document;
  document.line("<?xml version=\"1.0\"?>");
  document.line(
      fmt::format("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
                  "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">",
                  std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian"));
  document.line("  <UnstructuredGrid>");
  document.line(fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">",
                            used.node.size(), mesh.element_count()));
  std::vector<double> x;
  for (const std::size_t n : used.node) {
    x.insert(x.end(), mesh.x[n].data(), mesh.x[n].data() + 3);
  }
  document.line("      <Points>");
  document.add("Points", "Float64", 3, x);
  document.line("      </Points>");
  add_cells(document, mesh, used);
  add_point_data(document, mesh, used, step);
  document.line("    </Piece>");
  document.line("  </UnstructuredGrid>");
  write_file(file, document.finish());
}

void write_pvd(const std::filesystem::path& file,
               const std::vector<std::pair<double, std::string>>& entries) {
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"1.0\">\n"
                     "  <Collection>\n";
  for (const auto& [time, name] : entries) {
    text +=
        fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, escape(name));
  }
  write_file(file, text + "  </Collection>\n</VTKFile>\n");
}

} // namespace spricka::report
