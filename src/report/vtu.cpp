// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/file.hpp"
#include "report/report.hpp"
#include "report/table.hpp"
#include "report/vtu_grid.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace spricka::report {
namespace {

double von_mises(const std::array<double, 6>& s) {
  const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
  return std::sqrt(0.5 * ((s[0] - s[1]) * (s[0] - s[1]) + (s[1] - s[2]) * (s[1] - s[2]) +
                          (s[2] - s[0]) * (s[2] - s[0])) +
                   3.0 * shear);
}

void add_point_data(VtuDocument& document, const model::Mesh& mesh, const UsedNodes& used,
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
  VtuDocument document = vtu_grid(mesh, used);
  document.line("      <CellData Scalars=\"net\">");
  add_cell_numbers(document, mesh);
  document.line("      </CellData>");
  add_point_data(document, mesh, used, step);
  write_file(file, vtu_end(document));
}

namespace {

/// 1 for the members of a set, 0 for all others.
template <class Members, class Place>
void add_mark(VtuDocument& document, const std::string& name, std::size_t count,
              const Members& members, const Place& place) {
  std::vector<std::uint8_t> mark(count, 0);
  for (const auto& member : members) {
    if (const std::int64_t at = place(member); at >= 0) {
      mark[static_cast<std::size_t>(at)] = 1;
    }
  }
  document.add(escape(name), "UInt8", 1, mark);
}

} // namespace

void write_mesh_vtu(const std::filesystem::path& file, const model::Mesh& mesh) {
  const UsedNodes used = used_nodes(mesh);
  VtuDocument document = vtu_grid(mesh, used);
  document.line("      <CellData>");
  add_cell_numbers(document, mesh);
  for (const model::ElementSet& set : mesh.element_sets) {
    if (!set.name.empty()) {
      add_mark(document, set.name, mesh.element_count(), set.elements,
               [](base::ElementId e) { return static_cast<std::int64_t>(e.index()); });
    }
  }
  document.line("      </CellData>");
  document.line("      <PointData>");
  const auto point = [&](base::NodeId n) { return used.point[n.index()]; };
  std::vector<std::int64_t> label;
  for (const std::size_t n : used.node) {
    label.push_back(mesh.node_label[n]);
  }
  document.add("label", "Int64", 1, label);
  for (const model::NodeSet& set : mesh.node_sets) {
    if (!set.name.empty()) {
      add_mark(document, set.name, used.node.size(), set.nodes, point);
    }
  }
  document.line("      </PointData>");
  write_file(file, vtu_end(document));
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
