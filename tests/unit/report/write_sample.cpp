// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/element_type.hpp"
#include "report/report.hpp"
#include "sample.hpp"
#include "shape/topology.hpp"

#include <filesystem>
#include <fstream>
#include <initializer_list>

namespace {

using namespace spricka;
using base::ElementType;

/// Corners of the unit triangle, square, tetrahedron, wedge or cube.
std::vector<base::Vec3> corners_of(ElementType type) {
  const base::ElementInfo& info = base::element_info(type);
  const double x0 = 2.0 * static_cast<double>(type); // side by side
  std::vector<base::Vec3> x{{x0, 0, 0}, {x0 + 1, 0, 0}, {x0, 1, 0}, {x0, 0, 1}};
  if (info.dim == 2 && info.corners == 4) {
    x = {x[0], x[1], {x0 + 1, 1, 0}, x[2]};
  } else if (info.corners == 6) {
    x = {x[0], x[1], x[2], x[3], {x0 + 1, 0, 1}, {x0, 1, 1}};
  } else if (info.corners == 8) {
    x = {x[0], x[1], {x0 + 1, 1, 0}, x[2], x[3], {x0 + 1, 0, 1}, {x0 + 1, 1, 1}, {x0, 1, 1}};
  }
  return x;
}

/// One element of a quadratic type; where its further nodes lie follows from the sides they belong
/// to. `quarter`: mid nodes of the edges at the first corner stand at the quarter next to it.
void add_unit(model::Mesh& mesh, ElementType type, bool quarter) {
  const base::ElementInfo& info = base::element_info(type);
  std::vector<base::Vec3> x = corners_of(type);
  const base::Vec3 centre = 0.25 * (x[0] + x[1] + x[2] + x[3]);
  x.resize(static_cast<std::size_t>(info.nodes), centre); // a QUAMC9 has it; others overwrite
  const auto at = [&x](int n) -> base::Vec3& { return x[static_cast<std::size_t>(n)]; };
  for (int m = 0; m < shape::edge_count(type); ++m) {
    const auto [a, b] = shape::edge_corners(type, m);
    const double t = !quarter || (a != 0 && b != 0) ? 0.5 : (a == 0 ? 0.25 : 0.75);
    at(info.corners + m) = (1.0 - t) * at(a) + t * at(b);
  }
  if (type == ElementType::hexec27) {
    x.back().setZero();
    for (int s = 0; s < info.sides; ++s) {
      const std::span<const int> side = shape::side_nodes(type, s);
      at(side[8]) = 0.25 * (at(side[0]) + at(side[1]) + at(side[2]) + at(side[3]));
      x.back() += at(side[8]) / 6.0;
    }
  }
  std::vector<base::NodeId> nodes;
  nodes.reserve(x.size());
  for (const base::Vec3& p : x) {
    nodes.push_back(model::add_node(mesh, p, 1, base::NetId(0)));
  }
  model::add_element(mesh, type, nodes, 1, base::NetId(0));
}

results::CrackLengthResult units(std::initializer_list<ElementType> types, bool quarter) {
  results::CrackLengthResult increment;
  increment.mesh.dim = 3;
  for (const ElementType type : types) {
    add_unit(increment.mesh, type, quarter);
  }
  return increment;
}

} // namespace

/// Writes the sample's run folder for readers other than our own.
int main(int count, char** arguments) {
  if (count != 2) {
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  const test::Sample sample = test::make_sample();
  std::vector<report::PvdEntry> entries;
  for (const results::CrackLengthResult& increment : sample.run.increments) {
    const std::string name = "sample." + std::to_string(increment.number) + ".vtu";
    report::write_step_vtu(folder / name, sample.model, increment, increment.steps[1]);
    entries.push_back({.time = increment.a, .part = 0, .name = name});
  }
  using enum ElementType;
  report::write_step_vtu(folder / "solids.vtu", sample.model,
                         units({tet10, pentac15, hexec20, hexec27}, false), {});
  report::write_step_vtu(folder / "quarter.vtu", sample.model,
                         units({trimc6, quamc8, quamc9, tet10, pentac15, hexec20, hexec27}, true),
                         {});
  report::write_pvd(folder / "sample.pvd", entries);
  report::write_k_csv(folder / "k.csv", sample.model, sample.run);
  report::write_pressure_csv(folder / "pressure.csv", sample.model, sample.run);
  std::ofstream(folder / "report.html")
      << report::html_report(sample.sources, sample.model, sample.run);
}
