// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/model_tables.hpp"

#include "base/tidy.hpp"
#include "model/model.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace spricka::report {

std::string symmetry_note(const model::Model& model) {
  std::string sides;
  for (const model::MirrorPlane& plane : model.mirrors) {
    sides += fmt::format("{}{} {} {:.6g}", sides.empty() ? "" : ", ", "xyz"[plane.axis],
                         plane.above ? ">=" : "<=", plane.at.value_or(0.0));
  }
  return sides.empty() ? sides
                       : fmt::format("Symmetry: only the part {} is modelled. Forces, energies and "
                                     "areas are those of this part.",
                                     sides);
}

ReportTable net_table(const model::Model& model) {
  ReportTable table{
      "Nets",
      {{"net", "", true}, {"nodes", "", false}, {"elements", "", false}, {"of type", "", true}},
      {}};
  const model::Mesh& mesh = model.mesh;
  const std::vector<bool> used = model::nodes_in_use(mesh);
  for (std::size_t n = 0; n < model.nets.size(); ++n) {
    std::size_t nodes = 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
      nodes += used[i] && mesh.node_net[i] == base::NetId(n) ? 1 : 0;
    }
    std::array<std::size_t, base::element_infos.size()> count{};
    std::size_t elements = 0;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (mesh.element_net[e] == base::NetId(n)) {
        ++count[static_cast<std::size_t>(mesh.type[e])];
        ++elements;
      }
    }
    if (nodes == 0 && elements == 0) {
      continue;
    }
    std::string types;
    for (std::size_t t = 0; t < count.size(); ++t) {
      if (count[t] > 0) {
        types += fmt::format("{}{} {}", types.empty() ? "" : ", ", count[t],
                             base::element_infos[t].name);
      }
    }
    const std::string& name = model.nets[n].name;
    table.rows.push_back({name.empty() ? "(deck)" : name, fmt::format("{}", nodes),
                          fmt::format("{}", elements), types});
  }
  return table;
}

ReportTable property_table(const model::Model& model) {
  constexpr std::array<const char*, 4> state{"plane stress", "plane strain", "axisymmetric",
                                             "solid"};
  ReportTable table{"Properties",
                    {{"elements", "", true},
                     {"material", "", true},
                     {"E", model.units.stress_name(), false},
                     {"nu", "", false},
                     {"state", "", true},
                     {"thickness", model.units.length_name, false}},
                    {}};
  for (const model::ElementProperty& p : model.properties) {
    const model::ElasticMaterial& m = model.materials[p.material.index()];
    const bool plane =
        p.state == model::StressState::plane_stress || p.state == model::StressState::plane_strain;
    table.rows.push_back({model.mesh.set_with_id(p.elements).name, m.name,
                          fmt::format("{:.6g}", m.E), fmt::format("{:.4g}", m.nu),
                          state[static_cast<std::size_t>(p.state)],
                          plane ? fmt::format("{:.6g}", p.thickness) : ""});
  }
  return table;
}

namespace {

const std::string& master_name(const model::Model& model, const model::Contact& contact) {
  return contact.rigid.valid() ? model.rigids[contact.rigid.index()].name
                               : model.mesh.set_with_id(contact.master).name;
}

} // namespace

ReportTable contact_pair_table(const model::Model& model) {
  ReportTable table{"Contacts",
                    {{"contact", "", true},
                     {"slave", "", true},
                     {"master", "", true},
                     {"type", "", true},
                     {"pairing", "", true},
                     {"declared gap", model.units.length_name, false},
                     {"mu", "", false}},
                    {}};
  for (const model::Contact& c : model.contacts) {
    table.rows.push_back({c.name, model.mesh.set_with_id(c.slave).name, master_name(model, c),
                          c.type == model::ContactType::bonded ? "bonded" : "unilateral",
                          c.pairing == model::PairingMethod::node ? "node" : "segment",
                          c.gap ? fmt::format("{:.6g}", *c.gap) : "measured",
                          fmt::format("{:.4g}", c.mu)});
  }
  return table;
}

ReportTable rigid_table(const model::Model& model) {
  const std::string& unit = model.units.length_name;
  ReportTable table{"Rigid targets",
                    {{"target", "", true},
                     {"shape", "", true},
                     {"from or centre", unit, true},
                     {"to", unit, true},
                     {"radius", unit, false}},
                    {}};
  static constexpr std::array shapes{"line", "arc", "plane", "cylinder", "cone", "sphere"};
  for (const model::RigidTarget& r : model.rigids) {
    const bool round = r.radius != 0.0 || r.second_radius != 0.0;
    const bool one_point =
        r.shape == model::RigidTargetShape::arc || r.shape == model::RigidTargetShape::sphere;
    const std::string radius = fmt::format("{:.6g}", std::abs(r.radius));
    table.rows.push_back({r.name,
                          fmt::format("{}{}", shapes[static_cast<std::size_t>(r.shape)],
                                      r.radius < 0.0 || r.second_radius < 0.0 ? ", a bore" : ""),
                          base::place_text(r.first, model.mesh.dim),
                          one_point ? "" : base::place_text(r.second, model.mesh.dim),
                          r.shape == model::RigidTargetShape::cone
                              ? fmt::format("{} to {:.6g}", radius, std::abs(r.second_radius))
                          : round ? radius
                                  : ""});
  }
  return table;
}

} // namespace spricka::report
