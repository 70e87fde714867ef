// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/mirrors.hpp"

#include "fe/dof_map.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "sense/boundary_part.hpp"
#include "sense/mirrored_cracks.hpp"
#include "sense/mirrored_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double same_value = 1e-9; // of the larger of two

bool alike(double a, double b) {
  return std::abs(a - b) <= same_value * std::max({std::abs(a), std::abs(b), 1e-300});
}

// The boundary of some elements: sides that only one of them has.
std::vector<model::Face> skin_of(const model::Mesh& mesh,
                                 const std::vector<base::ElementId>& elements) {
  if (elements.size() == mesh.element_count()) {
    return mesh::outer_surface_faces(mesh);
  }
  model::Mesh part;
  part.dim = mesh.dim;
  part.x = mesh.x;
  part.node_label = mesh.node_label;
  part.node_net = mesh.node_net;
  for (const base::ElementId e : elements) {
    model::add_element(part, mesh.type[e.index()], mesh.element_nodes(e),
                       mesh.element_label[e.index()], mesh.element_net[e.index()]);
  }
  std::vector<model::Face> faces = mesh::outer_surface_faces(part);
  for (model::Face& face : faces) {
    face.element = elements[face.element.index()];
  }
  return faces;
}

/// What all planes ask of a model, made once.
class Looks {
public:
  explicit Looks(const model::Model& model) : model_(model), mesh_(model.mesh) {}

  /// What stands against a plane as a mirror; empty: nothing.
  [[nodiscard]] std::string against(const Reflection& mirror) const {
    std::string found = against_supports(mirror);
    found = found.empty() ? against_loads(mirror) : found;
    found = found.empty() ? against_contacts(mirror) : found;
    found = found.empty() ? against_ties(mirror) : found;
    return found.empty() ? crack_symmetry_obstacle(model_, mirror) : found;
  }

  [[nodiscard]] bool bodies_mirrored(const Reflection& mirror) const {
    return std::ranges::all_of(
        bodies(), [&](const BoundaryPart& body) { return mirrored_places(mirror, body, body); });
  }

  [[nodiscard]] bool own_image(const Reflection& mirror, const model::Load& load) const {
    return answers(mirror, load, load);
  }

private:
  static bool mirrored_places(const Reflection& mirror, const BoundaryPart& one,
                              const BoundaryPart& other) {
    const auto onto = [&](const BoundaryPart& from, const BoundaryPart& to) {
      return std::ranges::all_of(from.samples(),
                                 [&](const base::Vec3& x) { return to.contains_point(mirror(x)); });
    };
    return onto(one, other) && (&one == &other || onto(other, one));
  }

  // By material, state and thickness; found when first asked for, as what is held.
  [[nodiscard]] const std::vector<BoundaryPart>& bodies() const {
    if (bodies_.empty()) {
      using Kind = std::tuple<std::size_t, model::StressState, double>;
      std::map<Kind, std::vector<base::ElementId>> groups;
      for (const base::ElementId e : model::all_elements(mesh_)) {
        const model::ElementProperty& p = model_.element_property(mesh_, e);
        groups[{p.material.index(), p.state, p.thickness}].push_back(e);
      }
      for (const auto& [kind, elements] : groups) {
        bodies_.emplace_back(mesh_, skin_of(mesh_, elements));
      }
    }
    return bodies_;
  }

  [[nodiscard]] const std::vector<std::shared_ptr<const BoundaryPart>>& held() const {
    if (held_.empty()) {
      find_held();
    }
    return held_;
  }

  void find_held() const {
    const std::vector<model::FreedomRole> cls = fe::classify_freedoms(model_, mesh_);
    const std::vector<bool> used = model::mark_nodes_in_use(mesh_);
    const auto dim = static_cast<std::size_t>(mesh_.dim);
    std::vector<base::NodeId> before;
    for (std::size_t c = 0; c < dim; ++c) {
      std::vector<base::NodeId> nodes;
      for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
        const model::FreedomRole k = cls[dim * n + c];
        if (used[n] &&
            (k == model::FreedomRole::suppressed || k == model::FreedomRole::prescribed)) {
          nodes.emplace_back(n);
        }
      }
      held_.push_back(c > 0 && nodes == before
                          ? held_.back()
                          : std::make_shared<const BoundaryPart>(places_of_nodes(nodes)));
      before = std::move(nodes);
    }
  }

  [[nodiscard]] BoundaryPart places_of_nodes(const std::vector<base::NodeId>& nodes) const {
    return {mesh_, mesh::boundary_faces_with_all_nodes_in(mesh_, nodes), nodes};
  }
  [[nodiscard]] BoundaryPart places_of(const model::Load& load) const {
    if (load.nodes.valid()) {
      return places_of_nodes(mesh_.set_with_id(load.nodes).nodes);
    }
    if (load.faces.valid()) {
      return {mesh_, mesh_.set_with_id(load.faces).faces};
    }
    return {mesh_, skin_of(mesh_, mesh_.set_with_id(load.elements).elements)};
  }

  [[nodiscard]] std::string against_supports(const Reflection& mirror) const {
    for (std::size_t c = 0; c < held().size(); ++c) {
      const bool known = c > 0 && held()[c] == held()[c - 1];
      if (!known && !mirrored_places(mirror, *held()[c], *held()[c])) {
        return fmt::format("the supports along {} are not", "xyz"[c]);
      }
    }
    return {};
  }

  [[nodiscard]] bool answers(const Reflection& mirror, const model::Load& one,
                             const model::Load& other) const {
    if (find_loaded_crack(model_, one) != nullptr) {
      return is_mirrored_crack_face_load(model_, mirror, one, other);
    }
    return one.type == other.type && one.shape == other.shape &&
           mirrored_places(mirror, places_of(one), places_of(other)) &&
           load_values_are_mirrored(mirror, one, other,
                                    places_inside(one)) && // most part here, at no cost
           load_values_are_mirrored(mirror, one, other, integrated_at(one)) &&
           (&one == &other || load_values_are_mirrored(mirror, other, one, integrated_at(other)));
  }

  // A place inside each face or element of a load, off its middle, where loads like to jump.
  [[nodiscard]] std::vector<fe::LoadEvaluationPoint> places_inside(const model::Load& load) const {
    if (load.nodes.valid()) {
      return fe::load_sample_points(mesh_, load);
    }
    std::vector<fe::LoadEvaluationPoint> places;
    const auto add = [&](const auto& nodes) {
      base::Vec3 centre = base::Vec3::Zero();
      for (const base::NodeId n : nodes) {
        centre += mesh_.x[n.index()] / static_cast<double>(nodes.size());
      }
      places.push_back({0.7 * centre + 0.3 * mesh_.x[nodes[0].index()], 1.0});
    };
    if (load.faces.valid()) {
      for (const model::Face& face : mesh_.set_with_id(load.faces).faces) {
        add(mesh::nodes_of_faces(mesh_, {face}));
      }
    } else {
      for (const base::ElementId e : mesh_.set_with_id(load.elements).elements) {
        add(mesh_.element_nodes(e));
      }
    }
    return places;
  }

  // What the rules of a load cost is paid once for all planes.
  [[nodiscard]] const std::vector<fe::LoadEvaluationPoint>&
  integrated_at(const model::Load& load) const {
    const auto [at, fresh] = integrated_.try_emplace(&load);
    if (fresh) {
      at->second = fe::load_sample_points(mesh_, load);
    }
    return at->second;
  }

  [[nodiscard]] std::string against_loads(const Reflection& mirror) const {
    for (const model::LoadCase& load_case : model_.cases) {
      const std::vector<model::Load>& loads = load_case.loads;
      if (find_item_without_image(loads.size(), [&](std::size_t i, std::size_t j) {
            return answers(mirror, loads[i], loads[j]);
          })) {
        return fmt::format("load case {} is not", load_case.name);
      }
    }
    return {};
  }

  // What the steps do with a contact.
  [[nodiscard]] std::vector<std::tuple<std::size_t, int, double>>
  actions_on(base::ContactId contact) const {
    std::vector<std::tuple<std::size_t, int, double>> all;
    for (std::size_t s = 0; s < model_.steps.size(); ++s) {
      for (const model::StepAction& action : model_.steps[s].actions) {
        if (const auto* fit = std::get_if<model::ApplyFit>(&action);
            fit != nullptr && fit->contact == contact) {
          all.emplace_back(s, 0, fit->factor);
        } else if (const auto* mount = std::get_if<model::MountContact>(&action);
                   mount != nullptr && mount->contact == contact) {
          all.emplace_back(s, 1, 0.0);
        } else if (const auto* off = std::get_if<model::DismountContact>(&action);
                   off != nullptr && off->contact == contact) {
          all.emplace_back(s, 2, 0.0);
        }
      }
    }
    return all;
  }

  [[nodiscard]] bool mirrored_faces(const Reflection& mirror, base::FaceSetId one,
                                    base::FaceSetId other) const {
    return mirrored_places(mirror, {mesh_, mesh_.set_with_id(one).faces},
                           {mesh_, mesh_.set_with_id(other).faces});
  }

  // A rigid target that is its own image; of two targets that are images of each other it is not
  // asked.
  [[nodiscard]] bool mirrored_target(const Reflection& mirror, base::RigidId id) const {
    const model::RigidTarget& r = model_.rigids[id.index()];
    const double size = (r.second - r.first).norm() + std::abs(r.radius);
    const auto same = [&](const base::Vec3& a, const base::Vec3& b) {
      return (a - b).norm() <= same_value * size;
    };
    const base::Vec3 axis = r.second - r.first;
    const bool across = axis.cross(base::Vec3::Unit(mirror.axis)).norm() <= same_value * size;
    switch (r.shape) {
    case model::RigidTargetShape::arc:
    case model::RigidTargetShape::sphere:
      return same(mirror(r.first), r.first);
    case model::RigidTargetShape::line:
      return same(mirror(r.first), r.second);
    case model::RigidTargetShape::plane: // its normal lies in the mirror
      return std::abs(axis[mirror.axis]) <= same_value * size;
    case model::RigidTargetShape::cylinder:
      return across || (same(mirror(r.first), r.first) && same(mirror(r.second), r.second));
    case model::RigidTargetShape::cone:
      return same(mirror(r.first), r.first) && same(mirror(r.second), r.second);
    }
    return false;
  }

  [[nodiscard]] bool answers(const Reflection& mirror, std::size_t one, std::size_t other) const {
    const model::Contact& a = model_.contacts[one];
    const model::Contact& b = model_.contacts[other];
    if (a.type != b.type || a.gap.has_value() != b.gap.has_value() ||
        (a.gap && !alike(*a.gap, *b.gap)) || !alike(a.mu, b.mu) ||
        a.master.valid() != b.master.valid() ||
        actions_on(base::ContactId(one)) != actions_on(base::ContactId(other)) ||
        !mirrored_faces(mirror, a.slave, b.slave)) {
      return false;
    }
    return a.master.valid() ? mirrored_faces(mirror, a.master, b.master)
                            : one == other && mirrored_target(mirror, a.rigid);
  }

  [[nodiscard]] std::string against_contacts(const Reflection& mirror) const {
    const auto lone =
        find_item_without_image(model_.contacts.size(), [&](std::size_t i, std::size_t j) {
          return answers(mirror, i, j);
        });
    return lone ? fmt::format("contact {} is not", model_.contacts[*lone].name) : std::string();
  }

  [[nodiscard]] bool answers(const Reflection& mirror, const model::Mpc& one,
                             const model::Mpc& other) const {
    if (one.index() != other.index()) {
      return false;
    }
    if (const auto* tie = std::get_if<model::TransitionTie>(&one)) {
      const auto& image = std::get<model::TransitionTie>(other);
      return mirrored_places(mirror, places_of_nodes(mesh_.set_with_id(tie->slave).nodes),
                             places_of_nodes(mesh_.set_with_id(image.slave).nodes)) &&
             mirrored_faces(mirror, tie->master, image.master);
    }
    if (const auto* rigid = std::get_if<model::RigidTie>(&one)) {
      return mirrored_places(
          mirror, places_of_nodes(mesh_.set_with_id(rigid->slave).nodes),
          places_of_nodes(mesh_.set_with_id(std::get<model::RigidTie>(other).slave).nodes));
    }
    return false;
  }

  [[nodiscard]] std::string against_ties(const Reflection& mirror) const {
    const bool lone =
        find_item_without_image(model_.mpcs.size(), [&](std::size_t i, std::size_t j) {
          return answers(mirror, model_.mpcs[i], model_.mpcs[j]);
        }).has_value();
    return lone ? "an $MPC is not" : "";
  }

  const model::Model& model_;
  const model::Mesh& mesh_;
  mutable std::map<const model::Load*, std::vector<fe::LoadEvaluationPoint>> integrated_;
  mutable std::vector<BoundaryPart> bodies_;
  /// [direction]; one part for all that are held at the same nodes
  mutable std::vector<std::shared_ptr<const BoundaryPart>> held_;
};

/// The box round all nodes of elements.
struct NodeBoundingBox {
  base::Vec3 low = base::Vec3::Constant(1e300);
  base::Vec3 high = base::Vec3::Constant(-1e300);
};

NodeBoundingBox extent_of(const model::Mesh& mesh) {
  const std::vector<bool> used = model::mark_nodes_in_use(mesh);
  NodeBoundingBox box;
  for (std::size_t n = 0; n < used.size(); ++n) {
    if (used[n]) {
      box.low = box.low.cwiseMin(mesh.x[n]);
      box.high = box.high.cwiseMax(mesh.x[n]);
    }
  }
  return box;
}

Reflection middle_across(const NodeBoundingBox& box, int axis) {
  const double size = (box.high - box.low).norm();
  const double at = 0.5 * (box.low[axis] + box.high[axis]);
  return {axis, std::abs(at) < 1e-9 * size ? 0.0 : at, size};
}

} // namespace

std::vector<results::SymmetryPlanePreview> find_symmetry_planes(const model::Model& model) {
  std::vector<results::SymmetryPlanePreview> found;
  const NodeBoundingBox box = extent_of(model.mesh);
  const Looks looks(model);
  for (int axis = is_axisymmetric(model) ? 1 : 0; axis < model.mesh.dim; ++axis) {
    const Reflection mirror = middle_across(box, axis);
    if (looks.bodies_mirrored(mirror)) {
      found.push_back({.axis = axis, .at = mirror.at, .against = looks.against(mirror)});
    }
  }
  return found;
}

results::SymmetryPlanePreview check_symmetry_across_axis(const model::Model& model, int axis) {
  const Reflection mirror = middle_across(extent_of(model.mesh), axis);
  const Looks looks(model);
  return {.axis = axis,
          .at = mirror.at,
          .against = looks.bodies_mirrored(mirror) ? looks.against(mirror) : "the bodies are not"};
}

bool is_symmetric_load(const model::Model& model, const model::Load& load,
                       const results::SymmetryPlanePreview& mirror) {
  const NodeBoundingBox box = extent_of(model.mesh);
  return Looks(model).own_image({mirror.axis, mirror.at, (box.high - box.low).norm()}, load);
}

} // namespace spricka::sense
