// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/front_surroundings.hpp"

#include "analysis/scene/scene_heat.hpp"
#include "fe/assemble.hpp"
#include "fe/set_shares.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/graft.hpp"
#include "model/model.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

/// Nodes that a domain moves, and the elements round them.
struct Near {
  std::set<base::NodeId> nodes;
  std::set<base::ElementId> elements;
};

Near near_front(const crack::FrontIntegralDomains& domains) {
  Near near;
  for (const std::vector<crack::VirtualExtensionField>& point : domains.points) {
    for (const crack::VirtualExtensionField& field : point) {
      near.elements.insert(field.elements.begin(), field.elements.end());
      near.elements.insert(field.inside.begin(), field.inside.end());
      for (const crack::NodeMotion& moved : field.motion) {
        near.nodes.insert(moved.node);
      }
    }
  }
  return near;
}

// What a unit force per volume on a set adds up to: its volume, as loads are integrated.
double weighted_volume(const model::Model& model, const model::Mesh& mesh,
                       base::ElementSetId elements) {
  model::Load unit;
  unit.type = model::LoadType::body;
  unit.elements = elements;
  unit.value = {base::CompiledExpression::make_constant(1.0)};
  const base::Vector f = fe::consistent_load_vector(model, mesh, {"", {unit}});
  double sum = 0.0;
  for (Eigen::Index i = 0; i < f.size(); i += mesh.dim) {
    sum += f[i];
  }
  return sum;
}

std::vector<base::NodeId> nodes_of_side(const model::Mesh& mesh, const model::Face& face) {
  const auto nodes = mesh.element_nodes(face.element);
  std::vector<base::NodeId> result;
  for (const int k : shape::side_nodes(mesh.type[face.element.index()], face.side)) {
    result.push_back(nodes[static_cast<std::size_t>(k)]);
  }
  return result;
}

// Where all elements are quadratic, terms of the domains take the rims of heated sets as they are.
bool heat_is_known_inside(const model::Mesh& mesh) {
  return std::ranges::all_of(mesh.type,
                             [](base::ElementType t) { return base::element_info(t).quadratic; });
}

bool is_per_area(const model::Load& load) {
  return load.type == model::LoadType::traction || load.type == model::LoadType::pressure;
}

bool fills(const model::Load& load) {
  return load.elements.valid() &&
         (load.type == model::LoadType::body || load.type == model::LoadType::resultant ||
          load.type == model::LoadType::temperature);
}

crack::ActingLoad acting_near(const model::Model& model, const model::Mesh& mesh,
                              const model::Load& load, double factor, const Near& near) {
  crack::ActingLoad acting{&load, factor, {}, {}};
  if (is_per_area(load)) {
    for (const model::Face& face : mesh.set_with_id(load.faces).faces) {
      if (std::ranges::any_of(nodes_of_side(mesh, face),
                              [&](base::NodeId n) { return near.nodes.contains(n); })) {
        acting.faces.push_back(face);
      }
    }
  } else if (fills(load)) {
    const bool heats = load.type == model::LoadType::temperature;
    for (const base::ElementId e :
         heats ? mesh.set_with_id(load.elements).elements
               : fe::find_set_coverage(model, mesh, load.elements).elements) {
      if (near.elements.contains(e)) {
        acting.elements.push_back(e);
      }
    }
    std::ranges::sort(acting.elements);
  }
  return acting;
}

constexpr double same_plane = 1e-6; // of a face's extent: it lies across an axis

// Whether all nodes of a side have one coordinate.
bool lies_across(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes, int axis) {
  base::Vec3 low = mesh.x[nodes.front().index()];
  base::Vec3 high = low;
  for (const base::NodeId n : nodes) {
    low = low.cwiseMin(mesh.x[n.index()]);
    high = high.cwiseMax(mesh.x[n.index()]);
  }
  return high[axis] - low[axis] <= same_plane * (high - low).norm();
}

// [3 * node] held by a support of flat sides across an axis either along that axis (a plane of
// symmetry) or along both others but not along it (one of antisymmetry): reactions there do no work
// with what moves in their plane, as they are at right angles to how the displacement changes in
// it.
std::vector<bool> held_by_planes(const model::Mesh& mesh,
                                 const std::vector<model::FreedomRole>& cls) {
  std::vector<bool> by_planes(cls.size(), false);
  for (const model::Face& face : mesh::boundary_faces(mesh)) {
    const std::vector<base::NodeId> nodes = nodes_of_side(mesh, face);
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = [&](base::NodeId n, int along) {
        return 3 * n.index() + static_cast<std::size_t>((axis + along) % 3);
      };
      const auto rests = [&](int along) {
        return std::ranges::all_of(nodes, [&](base::NodeId n) {
          return cls[at(n, along)] == model::FreedomRole::suppressed;
        });
      };
      if (!lies_across(mesh, nodes, axis)) {
        continue;
      }
      const bool across = rests(0);
      const bool along = !across && rests(1) && rests(2);
      for (const base::NodeId n : nodes) {
        for (const int c : {0, 1, 2}) {
          by_planes[at(n, c)] = by_planes[at(n, c)] || (c == 0 ? across : along);
        }
      }
    }
  }
  return by_planes;
}

// Part of a front's radius that domains stay off the axis, as in space off its centre.
constexpr double near_axis = 0.2;

// What a tip in the plane may move besides, or may not.
void limit_at_tip(const model::Model& model, const model::Mesh& mesh, const mesh::CrackFront& front,
                  std::vector<bool>& held) {
  for (std::size_t n = 0; front.symmetric_half && n < mesh.node_count(); ++n) {
    const base::Vec3 d = mesh.x[n] - front.tip_point().x;
    const base::Vec3 across(-front.tip_point().growth.y(), front.tip_point().growth.x(), 0.0);
    if (std::abs(d.dot(across)) < 1e-9 * front.a) {
      // The line of a half model is held across it, and the virtual extension moves along it.
      held[n] = false;
    }
  }
  if (model::is_axisymmetric(model)) {
    // Partners are carried round the axis with the section (crack.38): they have no place there.
    for (std::size_t n = 0; n < mesh.node_count(); ++n) {
      held[n] = held[n] || mesh.x[n].x() < near_axis * front.tip_point().x.x();
    }
  }
}

// Rims of what is heated end zones of the plane, unless terms of the domains take them.
void limit_by_heat(const model::Model& model, const model::Mesh& mesh,
                   std::vector<std::int64_t>& zones) {
  if (heat_is_known_inside(mesh)) {
    return;
  }
  auto zone = static_cast<std::int64_t>(model.properties.size());
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.type != model::LoadType::temperature) {
        continue;
      }
      for (const base::ElementId e : mesh.set_with_id(load.elements).elements) {
        // The step doubles with each heated set: elements of unlike properties, or in unlike sets
        // of those, never have the same number.
        zones[e.index()] += zone;
      }
      zone = zone < (std::int64_t{1} << 50) ? 2 * zone : zone + 1;
    }
  }
}

} // namespace

std::vector<std::int64_t> assign_material_zone_numbers(const model::Model& model,
                                                       const model::Mesh& mesh) {
  std::vector<std::int64_t> of_property(model.properties.size());
  for (std::size_t p = 0; p < of_property.size(); ++p) {
    of_property[p] = static_cast<std::int64_t>(p);
    for (std::size_t q = 0; q < p; ++q) {
      const model::ElementProperty& one = model.properties[p];
      const model::ElementProperty& other = model.properties[q];
      if (one.material == other.material && one.state == other.state &&
          one.thickness == other.thickness) {
        of_property[p] = of_property[q];
        break;
      }
    }
  }
  std::vector<std::int64_t> zones;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    zones.push_back(of_property[mesh.property[e].index()]);
  }
  return zones;
}

crack::FrontLoads collect_front_loads(const model::Model& model, const Discretisation& scene,
                                      const crack::FrontIntegralDomains& domains,
                                      const base::Vector& case_factor) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const Near near = near_front(domains);
  crack::FrontLoads loads;
  for (std::size_t c = 0; c < model.cases.size(); ++c) {
    const double factor = case_factor[static_cast<Eigen::Index>(c)];
    for (const model::Load& load : model.cases[c].loads) {
      if (factor == 0.0) {
        continue;
      }
      crack::ActingLoad acting = acting_near(model, mesh, load, factor, near);
      if (acting.faces.empty() && acting.elements.empty()) {
        continue;
      }
      if (load.type == model::LoadType::resultant) {
        // A resultant is spread evenly over its set: domains take it as a force per volume.
        acting.factor /= weighted_volume(model, mesh, load.elements);
      }
      loads.loads.push_back(std::move(acting));
    }
  }
  const bool heated = std::ranges::any_of(loads.loads, [](const crack::ActingLoad& a) {
    return a.load->type == model::LoadType::temperature;
  });
  if (heated) {
    loads.temperature = scene.case_temperature * case_factor;
    loads.heat = scaled_case_temperatures(scene, case_factor);
  }
  return loads;
}

crack::IntegrationDomainConstraints find_domain_exclusions(const model::Model& model,
                                                           const Discretisation& scene,
                                                           const mesh::CrackFront& front) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const auto dim = static_cast<std::size_t>(mesh.dim);
  crack::IntegrationDomainConstraints limits;
  limits.node.assign(mesh.node_count(), false);
  limits.zone = assign_material_zone_numbers(model, mesh);
  const std::vector<bool> by_planes =
      front.is_tip() ? std::vector<bool>(scene.cls.size(), false) : held_by_planes(mesh, scene.cls);
  for (std::size_t i = 0; i < scene.cls.size(); ++i) {
    if ((model::is_suppressed_or_prescribed(scene.cls[i]) && !by_planes[i]) ||
        scene.cls[i] == model::FreedomRole::dependent) {
      limits.node[i / dim] = true;
    }
  }
  if (front.is_tip()) {
    limit_at_tip(model, mesh, front, limits.node);
    limit_by_heat(model, mesh, limits.zone);
  }
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      // A force on a node that moves has no derivative that the domains know (crack.18).
      if (load.type == model::LoadType::force) {
        for (const base::NodeId n : mesh.set_with_id(load.nodes).nodes) {
          limits.node[n.index()] = true;
        }
      }
    }
  }
  return limits;
}

void fill_crack_face_sets(const model::Model& model, mesh::CrackedMesh& cracked) {
  for (std::size_t i = 0; i < cracked.faces.size() && i < model.cracks.size(); ++i) {
    const model::CrackDefinition& crack = model.cracks[i];
    if (!crack.left.valid() || !crack.right.valid()) {
      continue;
    }
    mesh::CrackFaceSides faces = mesh::crack_face_sides(cracked.mesh, cracked.faces[i]);
    cracked.mesh.face_sets[crack.left.index()].faces = std::move(faces.left);
    cracked.mesh.face_sets[crack.right.index()].faces = std::move(faces.right);
  }
}

bool reject_total_loads_on_crack_faces(const model::Model& model, const Discretisation& scene,
                                       base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = scene.cracked.mesh;
  std::set<model::Face> crack_faces;
  for (const mesh::CrackFaceNodes& crack_face : scene.cracked.faces) {
    const mesh::CrackFaceSides faces = mesh::crack_face_sides(mesh, crack_face);
    crack_faces.insert(faces.left.begin(), faces.left.end());
    crack_faces.insert(faces.right.begin(), faces.right.end());
  }
  bool good = true;
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.faces.valid() && !is_per_area(load) &&
          std::ranges::any_of(mesh.set_with_id(load.faces).faces, [&](const model::Face& face) {
            return crack_faces.contains(face);
          })) {
        diagnostics.error(load.span, "E417",
                          fmt::format("load case {} gives a total to faces of a crack: how it "
                                      "spreads would change as the crack grows",
                                      load_case.name),
                          "give a PRESSURE or TRACTION, or leave the crack's part of the line out "
                          "of the set");
        good = false;
      }
    }
  }
  return good;
}

} // namespace spricka::analysis
