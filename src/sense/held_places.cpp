// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/held_places.hpp"

#include "fe/assemble.hpp"
#include "fe/dof_map.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/cut/mouth.hpp"
#include "model/model.hpp"
#include "sense/mirrored_cracks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double balance_round_off = 1e-9; // of a load
constexpr double straight_on = 0.985;      // cosine of 10 degrees

bool is_held(model::FreedomRole cls) {
  return cls == model::FreedomRole::suppressed || cls == model::FreedomRole::prescribed;
}

class ConstraintCheck {
public:
  ConstraintCheck(const model::Model& model, base::Diagnostics& list)
      : model_(model), mesh_(model.mesh), list_(list),
        cls_(fe::classify_freedoms(model, model.mesh)) {}

  /// Also marks the nodes that some load acts on.
  void loads() {
    loaded_.assign(mesh_.node_count(), false);
    for (const model::LoadCase& load_case : model_.cases) {
      for (const model::Load& load : load_case.loads) {
        if (model::is_force_load(load) && !on_a_crack(load)) {
          look_at(load_case, load);
        }
      }
    }
  }

  void surfaces() {
    if (mesh_.dim != 2) {
      return;
    }
    for (const model::Contact& contact : model_.contacts) {
      for (const base::FaceSetId set : {contact.slave, contact.master}) {
        if (set.valid() && wholly_held(mesh::nodes_of_faces(mesh_, mesh_.set_with_id(set).faces))) {
          list_.warning(contact.span, "W458",
                        fmt::format("contact {}: every node of {} is held in all directions, the "
                                    "body behind it is not: the contact presses on the supports "
                                    "alone",
                                    contact.name, mesh_.set_with_id(set).name),
                        "hold the body elsewhere; for a partner that does not yield there is "
                        "$RIGID");
        }
      }
    }
  }

  void mouths() {
    std::optional<mesh::HostMesh> host;
    for (const model::CrackDefinition& crack : model_.cracks) {
      if (crack.kind == model::CrackDefinitionKind::free && !crack.points.empty()) {
        look_at_mouth(crack, host ? *host : host.emplace(mesh_));
      }
    }
  }

private:
  [[nodiscard]] bool on_a_crack(const model::Load& load) const {
    return find_loaded_crack(model_, load) != nullptr ||
           std::ranges::any_of(model_.cracks, [&](const model::CrackDefinition& crack) {
             return load.faces.valid() && lies_on_path(mesh_.set_with_id(load.faces), crack);
           });
  }

  // On a line of symmetry, which is held until the crack runs along it.
  [[nodiscard]] bool lies_on_path(const model::FaceSet& set,
                                  const model::CrackDefinition& crack) const {
    if (!crack.path.valid()) {
      return false;
    }
    const std::vector<base::NodeId>& path = mesh_.set_with_id(crack.path).nodes;
    return std::ranges::any_of(set.faces, [&](const model::Face& face) {
      return std::ranges::all_of(mesh::nodes_of_faces(mesh_, {face}), [&](base::NodeId n) {
        return std::ranges::find(path, n) != path.end();
      });
    });
  }

  [[nodiscard]] std::span<const model::FreedomRole> freedoms_of(base::NodeId n) const {
    const auto dim = static_cast<std::size_t>(mesh_.dim);
    return std::span(cls_).subspan(dim * n.index(), dim);
  }

  [[nodiscard]] bool held(base::NodeId n) const {
    return std::ranges::all_of(freedoms_of(n), is_held);
  }

  void look_at(const model::LoadCase& load_case, const model::Load& load) {
    const base::Vector f = fe::consistent_load_vector(model_, mesh_, {load_case.name, {load}});
    const double all = f.size() > 0 ? f.lpNorm<Eigen::Infinity>() : 0.0;
    if (!f.allFinite() || !(all > 0.0)) {
      return;
    }
    // Largest of what stands on freedoms that can move: squares go beyond the range of numbers.
    double acts = 0.0;
    for (Eigen::Index i = 0; i < f.size(); ++i) {
      const std::size_t n = static_cast<std::size_t>(i / mesh_.dim);
      loaded_[n] = loaded_[n] || f[i] != 0.0;
      acts = is_held(cls_[static_cast<std::size_t>(i)]) ? acts : std::max(acts, std::abs(f[i]));
    }
    if (acts <= balance_round_off * all) {
      list_.warning(load.span, "W457",
                    fmt::format("load case {}: this load stands on held freedoms alone and goes "
                                "into the supports: no body feels it",
                                load_case.name),
                    "name the set that is to be loaded, or hold another one");
    }
  }

  // A crack or a load that makes more of a body than a base for others to stand on.
  [[nodiscard]] bool matters(const fe::Body& body) const {
    const auto cracked = [&](const model::CrackDefinition& crack) {
      return crack.kind == model::CrackDefinitionKind::free
                 ? crack.net == body.net || !crack.net.valid()
                 : crack.path.valid() &&
                       std::ranges::any_of(mesh_.set_with_id(crack.path).nodes,
                                           [&](base::NodeId n) {
                                             return std::ranges::binary_search(body.nodes, n);
                                           });
    };
    return std::ranges::any_of(model_.cracks, cracked) ||
           std::ranges::any_of(body.nodes,
                               [&](base::NodeId n) { return loaded_[n.index()] && !held(n); });
  }

  // All nodes held, and some other node of their body, of which results are wanted, is not.
  [[nodiscard]] bool wholly_held(const std::vector<base::NodeId>& nodes) {
    if (nodes.empty() || !std::ranges::all_of(nodes, [&](base::NodeId n) { return held(n); })) {
      return false;
    }
    if (bodies_.empty()) {
      bodies_ = fe::find_bodies(mesh_);
    }
    return std::ranges::any_of(bodies_, [&](const fe::Body& body) {
      return std::ranges::binary_search(body.nodes, nodes.front()) && matters(body) &&
             !std::ranges::all_of(body.nodes, [&](base::NodeId n) { return held(n); });
    });
  }

  // What a case prescribes may draw the crack faces apart.
  [[nodiscard]] bool suppressed(base::NodeId node) const {
    return std::ranges::all_of(freedoms_of(node), [](model::FreedomRole cls) {
      return cls == model::FreedomRole::suppressed;
    });
  }

  // The boundary side that the mouth opens in, with both its ends held.
  void look_at_mouth(const model::CrackDefinition& crack, const mesh::HostMesh& host) {
    const base::Vec3& start = crack.points.front();
    double near = 0.0;
    const mesh::NearestMouth mouth = mesh::find_crack_mouth(host, start, crack.net);
    for (const model::Face& face : host.boundary()) {
      const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(mesh_, face);
      const double length = (mesh_.x[edge.b.index()] - mesh_.x[edge.a.index()]).norm();
      // The given mouth may lie a little off the side that it is moved onto.
      const bool here =
          (!crack.net.valid() || mesh_.element_net[face.element.index()] == crack.net) &&
          mesh::nearest_point_on_edge(mesh_, edge, mouth.at).distance <= 1e-6 * length &&
          mouth.distance <= 1e-3 * length;
      if (!here) {
        continue;
      }
      near += 1.0;
      if (!suppressed(edge.a) || !suppressed(edge.b)) {
        return;
      }
    }
    if (near > 0.0) {
      list_.warning(crack.span, "W458",
                    fmt::format("crack {} opens at ({:.6g}, {:.6g}), where the boundary is held in "
                                "all directions on both sides: it cannot open there",
                                crack.name, start.x(), start.y()),
                    "hold the body elsewhere, or look at the place of the crack");
    }
  }

  const model::Model& model_;
  const model::Mesh& mesh_;
  base::Diagnostics& list_;
  std::vector<model::FreedomRole> cls_;
  std::vector<fe::Body> bodies_;
  std::vector<bool> loaded_; ///< [node]
};

/// A boundary side at a node, seen from there.
struct SideAt {
  base::NodeId other;
  base::Vec3 way = base::Vec3::Zero(); ///< unit
};

std::vector<SideAt> sides_at(const mesh::HostMesh& host, base::NodeId node) {
  std::vector<SideAt> sides;
  const std::vector<base::Vec3>& x = host.mesh().x;
  for (const base::ElementId e : host.elements_around(node)) {
    for (int s = 0; s < base::element_info(host.mesh().type[e.index()]).sides; ++s) {
      const mesh::EdgeEndAndMidNodes edge = mesh::element_edge_nodes(host.mesh(), {e, s});
      if ((edge.a == node || edge.b == node) && !host.neighbour({e, s})) {
        const base::NodeId other = edge.a == node ? edge.b : edge.a;
        sides.push_back({other, (x[other.index()] - x[node.index()]).normalized()});
      }
    }
  }
  return sides;
}

bool is_corner(const mesh::HostMesh& host, base::NodeId node) {
  return std::ranges::any_of(host.elements_around(node), [&](base::ElementId e) {
    const auto corners =
        static_cast<std::size_t>(base::element_info(host.mesh().type[e.index()]).corners);
    const auto nodes = host.mesh().element_nodes(e).first(corners);
    return std::ranges::find(nodes, node) != nodes.end();
  });
}

bool without_patch(const model::Model& model, std::size_t crack) {
  return std::ranges::any_of(model.tip_nets, [&](const model::TipMeshSettings& tip) {
    return tip.crack == base::CrackId(crack) && !tip.patch;
  });
}

} // namespace

void warn_of_loads_on_supports(const model::Model& model, base::Diagnostics& list) {
  if (list.has_errors()) {
    return;
  }
  ConstraintCheck held(model, list);
  held.loads();
  held.surfaces();
  held.mouths();
}

void warn_of_misplaced_crack_mouths(const model::Model& model, base::Diagnostics& list) {
  const bool some = std::ranges::any_of(model.cracks, [](const model::CrackDefinition& crack) {
    return crack.kind == model::CrackDefinitionKind::path;
  });
  if (list.has_errors() || model.mesh.dim != 2 || !some) {
    return;
  }
  const mesh::HostMesh host(model.mesh);
  const std::vector<model::FreedomRole> cls = fe::classify_freedoms(model, model.mesh);
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    const model::CrackDefinition& crack = model.cracks[c];
    if (crack.kind != model::CrackDefinitionKind::path || crack.is_in_mesh() ||
        !crack.path.valid() || model.mesh.set_with_id(crack.path).nodes.size() < 2) {
      continue; // E401
    }
    std::vector<base::NodeId> path = model.mesh.set_with_id(crack.path).nodes;
    // Middle nodes may be named or not.
    std::erase_if(path, [&](base::NodeId n) { return !is_corner(host, n); });
    if (path.size() < 2) {
      continue; // E427
    }
    const base::Vec3& x = model.mesh.x[path.front().index()];
    const base::Vec3 along = (model.mesh.x[path[1].index()] - x).normalized();
    const std::vector<SideAt> sides = sides_at(host, path.front());
    if (sides.empty() && without_patch(model, c)) { // with a patch: E421
      list.error(crack.span, "E458",
                 fmt::format("crack {}: PATH begins at ({:.6g}, {:.6g}) inside the body",
                             crack.name, x.x(), x.y()),
                 "a PATH is ordered from the mouth, a node of the boundary, to the tip");
    }
    const bool on_boundary = std::ranges::any_of(
        sides, [&](const SideAt& side) { return side.way.dot(along) > straight_on; });
    const auto behind = std::ranges::find_if(
        sides, [&](const SideAt& side) { return side.way.dot(along) < -straight_on; });
    if (!on_boundary || behind == sides.end()) {
      continue;
    }
    // The direction across the path, along x or y, in which a line of symmetry is held.
    const std::size_t across = std::abs(along.x()) > std::abs(along.y()) ? 1 : 0;
    const bool held = is_held(cls[2 * behind->other.index() + across]);
    list.warning(
        crack.span, "W459",
        fmt::format("crack {}: PATH begins at ({:.6g}, {:.6g}), in the middle of a straight side "
                    "of the body, which {} behind that point",
                    crack.name, x.x(), x.y(),
                    held ? "is held like a line of symmetry" : "is free, as if cracked already,"),
        held ? "the crack has another tip there, which is not looked at: begin PATH at the corner"
             : "its length counts from there, its K is that of all that is open: begin PATH at the "
               "corner where the side begins");
  }
}

} // namespace spricka::sense
