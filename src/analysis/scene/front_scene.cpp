// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/front_scene.hpp"

#include "analysis/scene/domain_rings.hpp"
#include "analysis/scene/tip_surroundings.hpp"
#include "mesh/boundary.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using base::Vec3;

constexpr double same_plane = 1e-6; // of a face's extent: it lies across an axis

bool is_held(model::FreedomClass type) {
  return type == model::FreedomClass::suppressed || type == model::FreedomClass::prescribed;
}

// Whether all nodes of a side have one coordinate.
bool lies_across(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes, int axis) {
  Vec3 low = mesh.x[nodes.front().index()];
  Vec3 high = low;
  for (const base::NodeId n : nodes) {
    low = low.cwiseMin(mesh.x[n.index()]);
    high = high.cwiseMax(mesh.x[n.index()]);
  }
  return high[axis] - low[axis] <= same_plane * (high - low).norm();
}

// Nodes of a side of an element.
std::vector<base::NodeId> nodes_of(const model::Mesh& mesh, const model::Face& face) {
  const auto all = mesh.element_nodes(face.element);
  std::vector<base::NodeId> nodes;
  for (const int k : shape::side_nodes(mesh.type[face.element.index()], face.side)) {
    nodes.push_back(all[static_cast<std::size_t>(k)]);
  }
  return nodes;
}

// [3 * node] held by a support of flat sides across an axis either along that axis (a plane of
// symmetry) or along both others but not along it (one of antisymmetry): reactions there do no work
// with what moves in their plane, as they are at right angles to how the displacement changes in
// it.
std::vector<bool> held_by_planes(const model::Mesh& mesh,
                                 const std::vector<model::FreedomClass>& cls) {
  std::vector<bool> by_planes(cls.size(), false);
  for (const model::Face& face : mesh::boundary_faces(mesh)) {
    const std::vector<base::NodeId> nodes = nodes_of(mesh, face);
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = [&](base::NodeId n, int along) {
        return 3 * n.index() + static_cast<std::size_t>((axis + along) % 3);
      };
      const auto rests = [&](int along) {
        return std::ranges::all_of(nodes, [&](base::NodeId n) {
          return cls[at(n, along)] == model::FreedomClass::suppressed;
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

std::string why_none(const crack::FrontExtensions& fields) {
  std::set<std::string> reasons;
  for (const crack::OmittedDomain& out : fields.left_out) {
    reasons.insert(out.why);
  }
  return fmt::format("{}", fmt::join(reasons, "; "));
}

// The node sets that hold nodes near a point of a front, by their names.
std::string remedy_at(const model::Model& model, const Discretisation& scene,
                      const mesh::FrontPoint& point) {
  constexpr double near = 3.0; // radii of the tube
  std::set<std::string> names;
  for (const model::FreedomAssignment& freedom : model.freedoms) {
    const model::NodeSet& set = scene.cracked.mesh.set_with_id(freedom.nodes);
    if (std::ranges::any_of(set.nodes, [&](base::NodeId n) {
          return (scene.cracked.mesh.x[n.index()] - point.x).norm() < near * point.radius;
        })) {
      names.insert(set.name.empty() ? "a set" : set.name);
    }
  }
  const std::string smaller = "give a smaller RADIUS or SIZE on $TIPNET or other DOMAINS on $VCE";
  return names.empty() ? smaller
                       : fmt::format("{} of $FREEDOM holds nodes there: is that body the one to be "
                                     "held? Else {}",
                                     fmt::join(names, ", "), smaller);
}

// Points inside the body that no domain belongs to.
std::vector<std::size_t> points_without(const mesh::CrackFront& front,
                                        const crack::FrontExtensions& fields) {
  std::vector<std::size_t> without;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    if (fields.points.empty() || (fields.points[i].empty() && !front.points[i].at_surface)) {
      without.push_back(i);
    }
  }
  return without;
}

// Layers of tetrahedra reach unevenly far, and wide ones of a tube where the front turns sharply:
// where those of the usual domains have no room the first one is a domain, too. Where that has none
// a smooth curve through the others would be no K.
crack::FrontExtensions fields_of(const model::Model& model, const Discretisation& scene,
                                 const mesh::CrackFront& front, base::Diagnostics& diagnostics) {
  std::vector<int> rings = domain_rings(model, front.crack);
  const crack::DomainLimits limits = front_limits(model, scene);
  crack::FrontExtensions fields = crack::front_extensions(scene.cracked, front, rings, limits);
  const bool given = std::ranges::any_of(model.vces, [&](const model::CrackExtensionSettings& vce) {
    return vce.crack == front.crack && !vce.domains.empty();
  });
  if (!points_without(front, fields).empty() && !given) {
    rings.insert(rings.begin(), 1);
    fields = crack::front_extensions(scene.cracked, front, rings, limits);
  }
  const std::vector<std::size_t> without = points_without(front, fields);
  const model::CrackDefinition& crack = model.cracks[front.crack.index()];
  const std::string remedy =
      without.empty() ? "" : remedy_at(model, scene, front.points[without.front()]);
  if (fields.empty()) {
    diagnostics.error(
        crack.span, "E412",
        fmt::format("crack {}: no domain fits round its front: {}", crack.name, why_none(fields)),
        remedy);
  } else if (!without.empty()) {
    const Vec3& x = front.points[without.front()].x;
    diagnostics.error(
        crack.span, "E412",
        fmt::format("crack {}: no domain fits round {} of {} points of its front, the "
                    "first at ({:.6g}, {:.6g}, {:.6g}): {}",
                    crack.name, without.size(), front.points.size(), x.x(), x.y(), x.z(),
                    why_none(fields)),
        remedy);
  }
  return fields;
}

} // namespace

crack::DomainLimits front_limits(const model::Model& model, const Discretisation& scene) {
  const model::Mesh& mesh = scene.cracked.mesh;
  crack::DomainLimits limits;
  limits.node.assign(mesh.node_count(), false);
  limits.zone = material_zones(model, mesh);
  const std::vector<bool> by_planes = held_by_planes(mesh, scene.cls);
  for (std::size_t i = 0; i < scene.cls.size(); ++i) {
    if ((is_held(scene.cls[i]) && !by_planes[i]) ||
        scene.cls[i] == model::FreedomClass::dependent) {
      limits.node[i / 3] = true;
    }
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

crack::TipLoads front_loads(const model::Model& model, const Discretisation& scene,
                            const crack::FrontExtensions& fields, const base::Vector& case_factor) {
  std::vector<crack::ExtensionField> all;
  for (const std::vector<crack::ExtensionField>& point : fields.points) {
    all.insert(all.end(), point.begin(), point.end());
  }
  return tip_loads(model, scene, all, case_factor);
}

// How deep a crack reaches behind an open front: the area of a face over the chord of the front's
// ends.
double mean_depth(const mesh::CrackedMesh& cracked, const mesh::CrackFront& front) {
  Vec3 area = Vec3::Zero();
  for (const model::Face& face : cracked.faces[front.crack.index()].left_sides) {
    const geometry::ElementSide side = model::element_side(cracked.mesh, face);
    side.for_quadrature_points(
        2, [&](const base::Vec2& r, double weight) { area += weight * side.area_vector(r); });
  }
  const double chord = (front.points.back().x - front.points.front().x).norm();
  return chord > 0.0 ? area.norm() / chord : front.a;
}

bool make_fronts(const model::Model& model, Discretisation& scene, base::Diagnostics& diagnostics) {
  bool good = true;
  for (mesh::CrackFront& front : scene.cracked.fronts) {
    if (model.cracks[front.crack.index()].kind == model::CrackDefinitionKind::ellipse) {
      front.a = model.cracks[front.crack.index()].plane.a;
    } else if (front.points.front().at_surface && !model.cracks[front.crack.index()].plane.closed) {
      front.a = mean_depth(scene.cracked, front);
    }
    const std::size_t errors = diagnostics.error_count();
    crack::FrontExtensions fields = fields_of(model, scene, front, diagnostics);
    good = good && diagnostics.error_count() == errors;
    scene.fronts.push_back({front, std::move(fields)});
  }
  scene.cracked.fronts.clear();
  return good;
}

} // namespace spricka::analysis
