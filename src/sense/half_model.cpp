// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/half_model.hpp"

#include "fe/load_points.hpp"
#include "model/model.hpp"
#include "sense/half_cracks.hpp"
#include "sense/mirrored_cracks.hpp"
#include "sense/mirrors.hpp"
#include "sense/requests_without_target.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

using base::Vec3;

/// How much of a set stays.
enum class SetRemainder { all, some, none };

/// Which nodes and elements stay, and how much of sets and contacts does.
class KeptModelSide {
public:
  KeptModelSide(const model::Model& model, const HalfModelPlane& plane)
      : model_(model), plane_(plane) {
    const model::Mesh& mesh = model.mesh;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      bool below = false;
      bool above = false;
      for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
        below = below || plane.signed_distance(mesh.x[n.index()]) < -plane.reach;
        above = above || plane.signed_distance(mesh.x[n.index()]) > plane.reach;
      }
      stays_.push_back(above);
      if (above && below && !across_) {
        across_ = base::ElementId(e);
      }
    }
  }

  [[nodiscard]] const HalfModelPlane& plane() const { return plane_; }
  [[nodiscard]] std::optional<base::ElementId> element_across() const { return across_; }
  [[nodiscard]] bool stays(base::ElementId e) const { return stays_[e.index()]; }
  [[nodiscard]] bool stays(const model::Face& face) const { return stays(face.element); }
  [[nodiscard]] bool stays(base::NodeId n) const {
    return plane_.signed_distance(model_.mesh.x[n.index()]) >= -plane_.reach;
  }
  [[nodiscard]] bool within(base::NodeId n) const {
    return std::abs(plane_.signed_distance(model_.mesh.x[n.index()])) <= plane_.reach;
  }

  [[nodiscard]] SetRemainder part(const model::Load& load) const {
    const model::Mesh& mesh = model_.mesh;
    return load.nodes.valid()   ? part_of(mesh.set_with_id(load.nodes).nodes)
           : load.faces.valid() ? part_of(mesh.set_with_id(load.faces).faces)
                                : part_of(mesh.set_with_id(load.elements).elements);
  }
  [[nodiscard]] SetRemainder part(base::FaceSetId set) const {
    return part_of(model_.mesh.set_with_id(set).faces);
  }

private:
  template <class T> [[nodiscard]] SetRemainder part_of(const std::vector<T>& members) const {
    const auto stay = static_cast<std::size_t>(
        std::ranges::count_if(members, [&](const T& member) { return stays(member); }));
    return stay == members.size() ? SetRemainder::all
           : stay > 0             ? SetRemainder::some
                                  : SetRemainder::none;
  }

  const model::Model& model_;
  HalfModelPlane plane_;
  std::vector<bool> stays_; ///< [element]
  std::optional<base::ElementId> across_;
};

bool is_total(const model::Load& load) {
  return load.type == model::LoadType::resultant || load.type == model::LoadType::bearing;
}

std::string across_text(const model::Model& model, base::ElementId e) {
  const model::Mesh& mesh = model.mesh;
  const std::string& net = model.nets[mesh.element_net[e.index()].index()].name;
  return fmt::format("element {}{} lies across it, which must be a line of the mesh",
                     mesh.element_label[e.index()], net.empty() ? "" : " of net " + net);
}

// What has no half, of a model whose sides are mirror images.
std::string without_half(const model::Model& model, const KeptModelSide& side,
                         const results::SymmetryPlanePreview& mirror) {
  if (const auto e = side.element_across()) {
    return across_text(model, *e);
  }
  for (const model::Mpc& mpc : model.mpcs) {
    if (const auto* rigid = std::get_if<model::RigidTie>(&mpc)) {
      const auto& nodes = model.mesh.set_with_id(rigid->slave).nodes;
      const auto stay = std::ranges::count_if(nodes, [&](auto n) { return side.stays(n); });
      if (stay > 0 && stay < std::ssize(nodes)) {
        return "an $MPC TYPE=RIGID lies across it";
      }
    }
  }
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (is_total(load) && side.part(load) == SetRemainder::some &&
          !is_symmetric_load(model, load, mirror)) {
        return fmt::format("a total of load case {} lies across it and is not its own image",
                           load_case.name);
      }
    }
  }
  return describe_crack_without_half(model, side.plane());
}

/// The plane of a mirror, or why it has no sides to choose from.
struct Chosen {
  HalfModelPlane plane;
  results::SymmetryPlanePreview mirror;
  std::string against;
};

Chosen choose(const model::Model& model, const model::MirrorPlane& request,
              const results::SymmetryPlanePreview& mirror) {
  Chosen chosen;
  chosen.mirror = mirror;
  chosen.plane = make_half_model_plane(model.mesh, request, chosen.mirror.at);
  if (model::is_axisymmetric(model) && request.axis == 0) {
    chosen.against = "x is the radius";
  } else if (!chosen.mirror.against.empty()) {
    chosen.against = chosen.mirror.against + " mirrored by it";
  } else {
    chosen.against = without_half(model, KeptModelSide(model, chosen.plane), chosen.mirror);
  }
  return chosen;
}

/// Makes the half.
class Keeper {
public:
  Keeper(model::Model& model, KeptModelSide side) : model_(model), side_(std::move(side)) {}

  void run() {
    for (model::LoadCase& load_case : model_.cases) {
      std::vector<model::Load> kept;
      for (model::Load& load : load_case.loads) {
        keep_load(std::move(load), kept);
      }
      load_case.loads = std::move(kept);
    }
    keep_contacts();
    remove_cracks_beyond_plane(model_, side_.plane());
    drop_empty_ties();
    keep_mesh();
    hold_plane();
  }

private:
  // What of a total acts on the faces and elements that stay.
  [[nodiscard]] Vec3 own_part(const model::Load& load) const {
    Vec3 force = Vec3::Zero();
    const auto add = [&](const auto& where, std::span<const fe::LoadPoint> points) {
      for (const fe::LoadPoint& point : points) {
        force += side_.stays(where) ? point.force : Vec3::Zero();
      }
    };
    fe::for_load_points(model_, model_.mesh, load, {add, add});
    return force;
  }

  void keep_load(model::Load load, std::vector<model::Load>& kept) {
    const SetRemainder part = load_part(load);
    if (part == SetRemainder::none) {
      return;
    }
    if (is_total(load) && part == SetRemainder::some) {
      Vec3 force = own_part(load);
      force[side_.plane().axis] = 0.0; // what is across is balanced by the image
      for (std::size_t i = 0; i < load.value.size(); ++i) {
        load.value[i] =
            base::CompiledExpression::make_constant(force[static_cast<Eigen::Index>(i)]);
      }
    }
    if (load.type == model::LoadType::force) {
      split_forces(load, kept);
    }
    kept.push_back(std::move(load));
  }

  // Faces of a crack are made with its mesh.
  [[nodiscard]] SetRemainder load_part(const model::Load& load) const {
    const model::CrackDefinition* const crack = find_loaded_crack(model_, load);
    if (crack == nullptr) {
      return side_.part(load);
    }
    const bool goes = lies_on_removed_side(model_, *crack, side_.plane()) ||
                      load.faces == find_missing_crack_face(model_, *crack, side_.plane());
    return goes ? SetRemainder::none : SetRemainder::all;
  }

  // The other half of a force in the plane acts on what goes.
  void split_forces(model::Load& load, std::vector<model::Load>& kept) {
    std::vector<model::NodeSet>& sets = model_.mesh.node_sets;
    model::NodeSet in_plane{{}, {}, load.span};
    model::NodeSet beside{{}, {}, load.span};
    for (const base::NodeId n : sets[load.nodes.index()].nodes) {
      (side_.within(n) ? in_plane : beside).nodes.push_back(n);
    }
    if (in_plane.nodes.empty()) {
      return;
    }
    model::Load half = load;
    for (base::CompiledExpression& value : half.value) {
      value.code.push_back({base::OpCode::number, 0.5});
      value.code.push_back({base::OpCode::multiply, 0.0});
    }
    half.nodes = base::NodeSetId(sets.size());
    sets.push_back(std::move(in_plane));
    load.nodes = base::NodeSetId(sets.size());
    sets.push_back(std::move(beside));
    kept.push_back(std::move(half));
  }

  void keep_contacts() {
    std::vector<base::ContactId> now(model_.contacts.size());
    std::vector<model::Contact> kept;
    for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
      if (side_.part(model_.contacts[i].slave) != SetRemainder::none) {
        now[i] = base::ContactId(kept.size());
        kept.push_back(std::move(model_.contacts[i]));
      }
    }
    model_.contacts = std::move(kept);
    for (model::Step& step : model_.steps) {
      std::erase_if(step.actions, [&](model::StepAction& action) {
        return std::visit(
            [&](auto& act) {
              if constexpr (requires { act.contact; }) {
                act.contact = now[act.contact.index()];
                return !act.contact.valid();
              } else {
                return false;
              }
            },
            action);
      });
    }
  }

  void drop_empty_ties() {
    std::erase_if(model_.mpcs, [&](const model::Mpc& mpc) {
      const auto* tie = std::get_if<model::TransitionTie>(&mpc);
      const auto* rigid = std::get_if<model::RigidTie>(&mpc);
      const base::NodeSetId slave = tie != nullptr     ? tie->slave
                                    : rigid != nullptr ? rigid->slave
                                                       : base::NodeSetId();
      return slave.valid() && std::ranges::none_of(model_.mesh.set_with_id(slave).nodes,
                                                   [&](base::NodeId n) { return side_.stays(n); });
    });
  }

  // Elements are numbered anew; nodes stay where they are, those of no element have no freedoms.
  void keep_mesh() {
    const model::Mesh old = std::move(model_.mesh);
    model::Mesh& mesh = model_.mesh;
    mesh = model::Mesh();
    mesh.dim = old.dim;
    mesh.x = old.x;
    mesh.node_label = old.node_label;
    mesh.node_net = old.node_net;
    std::vector<base::ElementId> now(old.element_count());
    for (std::size_t i = 0; i < old.element_count(); ++i) {
      const base::ElementId e(i);
      if (side_.stays(e)) {
        now[i] = model::add_element(mesh, old.type[i], old.element_nodes(e), old.element_label[i],
                                    old.element_net[i]);
        mesh.property.back() = old.property[i];
      }
    }
    for (const model::NodeSet& set : old.node_sets) {
      model::NodeSet& kept = mesh.node_sets.emplace_back(set);
      std::erase_if(kept.nodes, [&](base::NodeId n) { return !side_.stays(n); });
    }
    for (const model::ElementSet& set : old.element_sets) {
      model::ElementSet& kept = mesh.element_sets.emplace_back(set);
      std::erase_if(kept.elements, [&](base::ElementId e) { return !side_.stays(e); });
      for (base::ElementId& e : kept.elements) {
        e = now[e.index()];
      }
    }
    for (const model::FaceSet& set : old.face_sets) {
      model::FaceSet& kept = mesh.face_sets.emplace_back(set);
      std::erase_if(kept.faces, [&](const model::Face& face) { return !side_.stays(face); });
      for (model::Face& face : kept.faces) {
        face.element = now[face.element.index()];
      }
    }
  }

  void hold_plane() {
    model::Mesh& mesh = model_.mesh;
    const std::vector<bool> used = model::mark_nodes_in_use(mesh);
    model::NodeSet held{{}, {}, side_.plane().span};
    for (std::size_t n = 0; n < used.size(); ++n) {
      if (used[n] && side_.within(base::NodeId(n))) {
        held.nodes.emplace_back(n);
      }
    }
    model::NodeSetFreedomRole freedom;
    freedom.cls = model::FreedomRole::suppressed;
    freedom.dof[static_cast<std::size_t>(side_.plane().axis)] = true;
    freedom.nodes = base::NodeSetId(mesh.node_sets.size());
    freedom.span = side_.plane().span;
    mesh.node_sets.push_back(std::move(held));
    model_.freedoms.push_back(freedom);
  }

  model::Model& model_;
  KeptModelSide side_;
};

} // namespace

std::string half_model_obstacle(const model::Model& model,
                                const results::SymmetryPlanePreview& mirror) {
  model::MirrorPlane plane;
  plane.axis = mirror.axis;
  return choose(model, plane, mirror).against;
}

void reduce_to_half_model(model::Model& model, base::Diagnostics& list) {
  // A crack that is drawn in a plane wants a mouth there, which another plane may give it.
  std::stable_partition(
      model.mirrors.begin(), model.mirrors.end(), [&](const model::MirrorPlane& request) {
        return half_model_obstacle(model, check_symmetry_across_axis(model, request.axis)).empty();
      });
  const std::set<std::string> before = existing_entity_names(model);
  for (model::MirrorPlane& request : model.mirrors) {
    const Chosen chosen = choose(model, request, check_symmetry_across_axis(model, request.axis));
    const char axis = "xyz"[request.axis];
    if (!chosen.against.empty()) {
      list.error(request.span, "E354",
                 fmt::format("{} = {:.6g} does not part the model in two mirror images: {}", axis,
                             chosen.mirror.at, chosen.against),
                 "without the card, check lists the planes of symmetry that there are");
      return;
    }
    Keeper(model, KeptModelSide(model, chosen.plane)).run();
    request.at = chosen.mirror.at;
  }
  drop_requests_without_target(model, before, list);
}

} // namespace spricka::sense
