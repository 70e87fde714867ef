// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/table.hpp"
#include "report/drawing/vtu_grid.hpp"
#include "report/report.hpp"
#include "results/k_quantities.hpp"
#include "results/stress_component.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace spricka::report {
namespace {

/// Stresses as arrays: the components, von Mises, principal ones.
template <class Real> class StressArrays {
public:
  void add(const results::Stress& s) {
    for (const double component : s) {
      stress_.push_back(static_cast<Real>(component));
    }
    mises_.push_back(static_cast<Real>(results::von_mises(s)));
    for (const double p : results::principal_stresses(s)) {
      principal_.push_back(static_cast<float>(p));
    }
  }
  void write(VtuDocument& document, const std::string& prefix) const {
    const char* const type = sizeof(Real) == sizeof(double) ? "Float64" : "Float32";
    document.add_array(prefix + "stress", type, 6, stress_, results::stress_component_names);
    document.add_array(prefix + "von_mises", type, 1, mises_);
    document.add_array(prefix + "principal", "Float32", 3, principal_,
                       results::principal_stress_names);
  }

private:
  std::vector<Real> stress_, mises_;
  std::vector<float> principal_;
};

/// A nodal vector at the points. Sums over points shall be sums over nodes: where `once`, a node's
/// further points hold zero.
std::vector<double> at_points(const model::Mesh& mesh, const VtuGridPoints& points,
                              const base::Vector& field, bool once) {
  const auto dim = static_cast<std::size_t>(mesh.dim);
  std::vector<double> values;
  values.reserve(3 * points.node.size());
  for (std::size_t p = 0; p < points.node.size(); ++p) {
    const std::size_t n = points.node[p];
    const bool further = once && points.point[n] != static_cast<std::int64_t>(p);
    for (std::size_t i = 0; i < 3; ++i) {
      values.push_back(i < dim && !further ? field[static_cast<Eigen::Index>(dim * n + i)] : 0.0);
    }
  }
  return values;
}

std::vector<std::int64_t> labels(const model::Mesh& mesh, const VtuGridPoints& points) {
  std::vector<std::int64_t> label;
  for (const std::size_t n : points.node) {
    label.push_back(mesh.node_label[n]);
  }
  return label;
}

void add_point_data(VtuDocument& document, const model::Mesh& mesh, const VtuGridPoints& points,
                    const results::LoadStepResult& step) {
  const auto freedoms = static_cast<Eigen::Index>(mesh.node_count()) * mesh.dim;
  document.add_line("      <PointData>");
  if (step.u.size() == freedoms) {
    document.add_array("displacement", "Float64", 3, at_points(mesh, points, step.u, false));
  }
  if (!step.stress.empty()) {
    StressArrays<double> arrays;
    for (const std::size_t source : points.source) {
      arrays.add(step.stress[source]);
    }
    arrays.write(document, "");
  }
  if (step.reaction.size() == freedoms) {
    document.add_array("reaction", "Float64", 3, at_points(mesh, points, step.reaction, true));
  }
  document.add_array("label", "Int64", 1, labels(mesh, points));
  document.add_line("      </PointData>");
}

} // namespace

void write_step_vtu(const std::filesystem::path& file, const model::Model& /*model*/,
                    const results::CrackLengthResult& increment,
                    const results::LoadStepResult& step) {
  const model::Mesh& mesh = increment.mesh;
  const VtuGridPoints points = make_vtu_grid_points(mesh, step.stress.size() > mesh.node_count());
  VtuDocument document = begin_vtu_grid(mesh, points);
  document.add_line("      <CellData Scalars=\"net\">");
  add_cell_numbers(document, mesh);
  if (!step.element_stress.empty()) {
    StressArrays<float> arrays; // for the eye
    for (const results::Stress& s : step.element_stress) {
      arrays.add(s);
    }
    arrays.write(document, "element_");
  }
  for (const results::FrontResult& front : step.fronts) {
    for (std::size_t k = 0; k < 2 && front.is_tip() && front.has_error_bar(); ++k) {
      // where the error of K comes from
      const std::vector<double>& eta = front.single_point().bar[k].of_element;
      document.add_array(escape_xml(fmt::format("eta_K{}_{}", k + 1, front.name)), "Float32", 1,
                         std::vector<float>(eta.begin(), eta.end()));
    }
  }
  document.add_line("      </CellData>");
  add_point_data(document, mesh, points, step);
  write_file(file, finish_vtu_text(document));
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
  document.add_array(escape_xml(name), "UInt8", 1, mark);
}

} // namespace

void write_mesh_sets_vtu(const std::filesystem::path& file, const model::Mesh& mesh) {
  const VtuGridPoints points = make_vtu_grid_points(mesh, false);
  VtuDocument document = begin_vtu_grid(mesh, points);
  document.add_line("      <CellData>");
  add_cell_numbers(document, mesh);
  for (const model::ElementSet& set : mesh.element_sets) {
    if (!set.name.empty()) {
      add_mark(document, set.name, mesh.element_count(), set.elements,
               [](base::ElementId e) { return static_cast<std::int64_t>(e.index()); });
    }
  }
  document.add_line("      </CellData>");
  document.add_line("      <PointData>");
  const auto point = [&](base::NodeId n) { return points.point[n.index()]; };
  document.add_array("label", "Int64", 1, labels(mesh, points));
  for (const model::NodeSet& set : mesh.node_sets) {
    if (!set.name.empty()) {
      add_mark(document, set.name, points.node.size(), set.nodes, point);
    }
  }
  document.add_line("      </PointData>");
  write_file(file, finish_vtu_text(document));
}

void write_contact_vtu(const std::filesystem::path& file, const model::Model& model,
                       const results::LoadStepResult& step) {
  std::vector<double> x;
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> number; // of the contact, by point
  std::vector<std::uint8_t> closed;
  std::array<std::vector<double>, 3> values;
  std::vector<double> shear;
  for (const results::ContactResult& contact : step.contacts) {
    if (!contact.mounted) {
      continue;
    }
    const auto first = static_cast<std::int64_t>(number.size());
    const auto card = std::ranges::find(model.contacts, contact.name, &model::Contact::name);
    for (const results::ContactPoint& p : contact.points) {
      x.insert(x.end(), p.x.data(), p.x.data() + 3);
      number.push_back(card - model.contacts.begin());
      closed.push_back(p.closed ? 1 : 0);
      values[0].push_back(p.p_lumped);
      values[1].push_back(p.p_consistent);
      values[2].push_back(p.gap);
      shear.insert(shear.end(), p.shear.data(), p.shear.data() + 3);
    }
    for (const int corner : contact.corners) {
      corners.push_back(first + corner);
    }
  }
  VtuDocument document = begin_vtu_triangles(x, corners);
  document.add_line("      <PointData Scalars=\"p_lumped\">");
  document.add_array("p_lumped", "Float64", 1, values[0]);
  document.add_array("p_consistent", "Float64", 1, values[1]);
  document.add_array("gap", "Float64", 1, values[2]);
  document.add_array("shear", "Float64", 3, shear);
  document.add_array("closed", "UInt8", 1, closed);
  document.add_array("contact", "Int64", 1, number);
  document.add_line("      </PointData>");
  write_file(file, finish_vtu_text(document));
}

void write_front_vtu(const std::filesystem::path& file, const model::Model& model,
                     const results::LoadStepResult& step) {
  std::vector<double> x;
  std::vector<double> growth;
  std::vector<std::int64_t> ends;
  std::vector<std::int64_t> crack;
  std::vector<const results::FrontPointResult*> places;
  std::vector<const results::FrontResult*> front_of; // [place]
  for (const results::FrontResult& front : step.fronts) {
    const auto first = static_cast<std::int64_t>(places.size());
    const auto count = static_cast<std::int64_t>(front.points.size());
    const auto card = std::ranges::find_if(model.cracks, [&](const model::CrackDefinition& c) {
      return front.name == c.name || front.name.starts_with(c.name + ".");
    });
    for (const results::FrontPointResult& place : front.points) {
      places.push_back(&place);
      front_of.push_back(&front);
      x.insert(x.end(), place.x.data(), place.x.data() + 3);
      growth.insert(growth.end(), place.direction.data(), place.direction.data() + 3);
      crack.push_back(card - model.cracks.begin());
    }
    for (std::int64_t i = 0; i < (front.is_loop ? count : count - 1); ++i) {
      ends.push_back(first + i);
      ends.push_back(first + (i + 1) % count);
    }
  }
  VtuDocument document = begin_vtu_lines(x, ends);
  document.add_line("      <PointData Scalars=\"K1\">");
  for (const results::KQuantity& q : results::k_quantities) {
    if (q.appears_in(results::in_output, 3)) {
      std::vector<double> values;
      for (std::size_t i = 0; i < places.size(); ++i) {
        // A bar that there is not is no bar of nothing.
        const bool given = q.is_given(*front_of[i]);
        values.push_back(given ? q.extract_value(*front_of[i], *places[i])
                               : std::numeric_limits<double>::quiet_NaN());
      }
      document.add_array(q.name, "Float64", 1, values);
    }
  }
  document.add_array("growth", "Float64", 3, growth);
  document.add_array("crack", "Int64", 1, crack);
  document.add_line("      </PointData>");
  write_file(file, finish_vtu_text(document));
}

void write_pvd(const std::filesystem::path& file, const std::vector<PvdEntry>& entries) {
  std::string text = "<?xml version=\"1.0\"?>\n"
                     "<VTKFile type=\"Collection\" version=\"1.0\">\n"
                     "  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", entry.time,
                        entry.part, escape_xml(entry.name));
  }
  write_file(file, text + "  </Collection>\n</VTKFile>\n");
}

} // namespace spricka::report
