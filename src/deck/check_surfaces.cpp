// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "geometry/polyline.hpp"
#include "model/model.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

/// Surfaces that two cards speak of: what a contact holds already must not be held, or loaded, by
/// another card as well.
namespace spricka::deck {

namespace {

using Faces = std::vector<model::Face>;

Faces sorted_faces(const model::Mesh& mesh, base::FaceSetId set) {
  Faces faces = mesh.set_with_id(set).faces;
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

Faces common(const Faces& a, const Faces& b) {
  Faces both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

std::string count_of(std::size_t faces) {
  return fmt::format("{} face{}", faces, faces == 1 ? "" : "s");
}

/// Two surfaces that are to meet, faces ascending.
struct SurfaceFacePair {
  Faces one, two;
};

SurfaceFacePair pair_of(const model::Mesh& mesh, const model::Contact& contact) {
  return {sorted_faces(mesh, contact.slave),
          contact.master.valid() ? sorted_faces(mesh, contact.master) : Faces()};
}

class SurfaceConflictCheck {
public:
  explicit SurfaceConflictCheck(DeckContext& context)
      : c_(context), model_(context.model), mesh_(model_.mesh) {
    for (const model::Contact& contact : model_.contacts) {
      pairs_.push_back(pair_of(mesh_, contact));
    }
    find_mounted();
  }

  void look() {
    for (std::size_t b = 0; b < pairs_.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        look_at_contacts(a, b);
      }
    }
    for (const model::Mpc& mpc : model_.mpcs) {
      if (const auto* tie = std::get_if<model::TransitionTie>(&mpc)) {
        look_at_tie(*tie);
      } else if (const auto* body = std::get_if<model::RigidTie>(&mpc)) {
        look_at_rigid_tie(*body);
      }
    }
    look_at_equations();
    look_at_loads();
  }

private:
  // What is in force at the end of each step, or all along in a deck without steps. A contact that
  // a step mounts is absent before.
  void find_mounted() {
    std::vector<bool> in(model_.contacts.size(), true);
    std::vector<double> load(model_.cases.size(), 0.0);
    for (const model::Step& step : model_.steps) {
      for (const model::Action& action : step.actions) {
        if (const auto* on = std::get_if<model::MountContact>(&action)) {
          in[on->contact.index()] = false;
        }
      }
    }
    for (const model::Step& step : model_.steps) {
      for (const model::Action& action : step.actions) {
        if (const auto* on = std::get_if<model::MountContact>(&action)) {
          in[on->contact.index()] = true;
        } else if (const auto* off = std::get_if<model::DismountContact>(&action)) {
          in[off->contact.index()] = false;
        } else if (const auto* apply = std::get_if<model::ApplyLoad>(&action)) {
          load[apply->load_case.index()] = apply->factor;
        }
      }
      mounted_.push_back(in);
      loaded_.push_back(load);
    }
    if (model_.steps.empty()) {
      mounted_.push_back(in);
    }
  }

  [[nodiscard]] bool together(std::size_t a, std::size_t b) const {
    return std::ranges::any_of(mounted_,
                               [&](const std::vector<bool>& in) { return in[a] && in[b]; });
  }

  [[nodiscard]] base::Vec3 middle(const model::Face& face) const {
    base::Vec3 sum = base::Vec3::Zero();
    const std::vector<base::NodeId> nodes = nodes_of(face);
    for (const base::NodeId n : nodes) {
      sum += mesh_.x[n.index()];
    }
    return sum / static_cast<double>(nodes.size());
  }

  // The corners of a side.
  [[nodiscard]] std::vector<base::NodeId> nodes_of(const model::Face& face) const {
    const auto all = mesh_.element_nodes(face.element);
    const base::ElementType type = mesh_.type[face.element.index()];
    std::vector<base::NodeId> corners;
    for (const int local :
         shape::side_nodes(type, face.side).first(shape::side_corners(type, face.side))) {
      corners.push_back(all[static_cast<std::size_t>(local)]);
    }
    return corners;
  }

  // Faces of one pair that lie opposite the same faces in another as well: of the faces that both
  // have, those whose nearest partner of either pair belongs to both.
  [[nodiscard]] std::size_t doubled(const SurfaceFacePair& a, const SurfaceFacePair& b) const {
    const Faces shared = common(a.one, b.one);
    const Faces auxiliary = common(a.two, b.two);
    if (shared.empty() || auxiliary.empty()) {
      return 0;
    }
    Faces all;
    std::set_union(a.two.begin(), a.two.end(), b.two.begin(), b.two.end(), std::back_inserter(all));
    if (all.size() == auxiliary.size()) {
      return shared.size();
    }
    std::vector<base::Vec3> places;
    std::ranges::transform(all, std::back_inserter(places),
                           [&](const model::Face& face) { return middle(face); });
    return static_cast<std::size_t>(std::ranges::count_if(shared, [&](const model::Face& face) {
      const base::Vec3 x = middle(face);
      const auto nearest = std::ranges::min_element(
          places, {}, [&](const base::Vec3& place) { return (place - x).squaredNorm(); });
      return std::binary_search(auxiliary.begin(), auxiliary.end(),
                                all[static_cast<std::size_t>(nearest - places.begin())]);
    }));
  }

  // How many of some faces lie opposite a partner, not beyond its ends; all where that is rigid.
  [[nodiscard]] std::size_t facing(const Faces& faces, const Faces& auxiliary) const {
    if (auxiliary.empty()) {
      return faces.size();
    }
    if (mesh_.dim == 3) {
      return static_cast<std::size_t>(std::ranges::count_if(
          faces, [&](const model::Face& face) { return lies_before(face, auxiliary); }));
    }
    std::map<base::NodeId, int> sides; // of the partner's nodes: one at an end
    for (const model::Face& face : auxiliary) {
      for (const base::NodeId n : nodes_of(face)) {
        ++sides[n];
      }
    }
    return static_cast<std::size_t>(std::ranges::count_if(faces, [&](const model::Face& face) {
      const base::Vec3 x = middle(face);
      double nearest = std::numeric_limits<double>::max();
      bool opposite = false;
      for (const model::Face& other : auxiliary) {
        const std::vector<base::NodeId> ends = nodes_of(other);
        const auto [t, distance] =
            geometry::nearest_point(x, mesh_.x[ends[0].index()], mesh_.x[ends[1].index()]);
        if (distance < nearest) {
          nearest = distance;
          opposite = (t > 0.0 && t < 1.0) || sides.at(ends[t > 0.5 ? 1 : 0]) > 1;
        }
      }
      return opposite;
    }));
  }

  // In space: whether the middle of a face, moved along the normal of the nearest of the partner's,
  // is no farther from the middle of that one than its corners are.
  [[nodiscard]] bool lies_before(const model::Face& face, const Faces& auxiliary) const {
    const base::Vec3 x = middle(face);
    const model::Face& other = *std::ranges::min_element(
        auxiliary, {}, [&](const model::Face& f) { return (middle(f) - x).squaredNorm(); });
    const std::vector<base::NodeId> corners = nodes_of(other);
    const base::Vec3 at = middle(other);
    const auto from_middle = [&](std::size_t i) {
      return base::Vec3(mesh_.x[corners[i].index()] - at);
    };
    const base::Vec3 n = from_middle(0).cross(from_middle(1)).normalized();
    double reach = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      reach = std::max(reach, from_middle(i).norm());
    }
    return (x - at - n.dot(x - at) * n).norm() < reach;
  }

  [[nodiscard]] std::size_t line_of(base::SourceSpan span) const {
    return c_.sources.locate(span.file, span.begin).line;
  }

  [[nodiscard]] std::string surfaces_of(const model::Contact& contact) const {
    return fmt::format("{} and {}", mesh_.set_with_id(contact.slave).name,
                       contact.rigid.valid() ? model_.rigids[contact.rigid.index()].name
                                             : mesh_.set_with_id(contact.master).name);
  }

  // Whether both demand the same of surfaces that both pair.
  static bool alike(const model::Contact& a, const model::Contact& b) {
    return a.type == b.type && a.gap == b.gap && a.mu == b.mu;
  }

  void look_at_contacts(std::size_t a, std::size_t b) {
    const model::Contact& first = model_.contacts[a];
    const model::Contact& second = model_.contacts[b];
    if (!together(a, b)) {
      return;
    }
    std::size_t faces = 0;
    if (first.rigid.valid() || second.rigid.valid()) {
      faces = first.rigid == second.rigid ? common(pairs_[a].one, pairs_[b].one).size() : 0;
    } else {
      const SurfaceFacePair swapped{pairs_[b].two, pairs_[b].one};
      faces = std::max(doubled(pairs_[a], pairs_[b]), doubled(pairs_[a], swapped));
    }
    if (faces > 0 && alike(first, second)) {
      c_.diagnostics.warning(
          second.span, "W354",
          fmt::format("contact {} pairs {} that contact {} in line {} pairs already ({}): "
                      "displacements and K are those of one, how the two share the pressure is "
                      "left open",
                      second.name, count_of(faces), first.name, line_of(first.span),
                      surfaces_of(first)),
          "take one of them away");
    } else if (faces > 0) {
      const bool types = first.type != second.type;
      c_.error(second.span, "E351",
               fmt::format("contact {} pairs {} that contact {} in line {} pairs already "
                           "({}){}",
                           second.name, count_of(faces), first.name, line_of(first.span),
                           surfaces_of(first), types ? ": one bonds what the other lets part" : ""),
               "take one of them away; for one after the other DISMOUNT the first in the step that "
               "says MOUNT for the second");
    }
  }

  // The faces of a set all of whose corners are among nodes.
  [[nodiscard]] Faces faces_within(const Faces& faces, const std::set<base::NodeId>& nodes) const {
    Faces within;
    std::ranges::copy_if(faces, std::back_inserter(within), [&](const model::Face& face) {
      return std::ranges::all_of(nodes_of(face), [&](base::NodeId n) { return nodes.contains(n); });
    });
    return within;
  }

  void say_tied(const model::Contact& contact, base::SourceSpan tie, std::size_t faces) {
    c_.error(contact.span, "E352",
             fmt::format("contact {} pairs {} that the $MPC in line {} ties already ({})",
                         contact.name, count_of(faces), line_of(tie), surfaces_of(contact)),
             "tied surfaces cannot press or part: take the $CONTACT away, or the $MPC");
  }

  void look_at_tie(const model::TransitionTie& tie) {
    if (!tie.slave.valid() || !tie.master.valid()) {
      return;
    }
    const std::vector<base::NodeId>& list = mesh_.set_with_id(tie.slave).nodes;
    const std::set<base::NodeId> nodes(list.begin(), list.end());
    const Faces master = sorted_faces(mesh_, tie.master);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const SurfaceFacePair& pair = pairs_[i];
      const SurfaceFacePair here{faces_within(pair.one, nodes), master};
      const SurfaceFacePair turned{faces_within(pair.two, nodes), master};
      const std::size_t faces =
          std::max(doubled(pair, here), doubled({pair.two, pair.one}, turned));
      if (faces > 0) {
        say_tied(model_.contacts[i], tie.span, faces);
      }
    }
  }

  // Both surfaces on one rigid body: a pin and its bore in one set.
  void look_at_rigid_tie(const model::RigidTie& tie) {
    if (!tie.slave.valid()) {
      return;
    }
    const std::vector<base::NodeId>& list = mesh_.set_with_id(tie.slave).nodes;
    const std::set<base::NodeId> nodes(list.begin(), list.end());
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const SurfaceFacePair& pair = pairs_[i];
      const bool both = !pair.two.empty() && faces_within(pair.one, nodes) == pair.one &&
                        faces_within(pair.two, nodes) == pair.two;
      if (both) {
        say_tied(model_.contacts[i], tie.span, pair.one.size());
      }
    }
  }

  // Matching nodes that equations tie one by one, in all directions.
  void look_at_equations() {
    std::map<std::pair<base::NodeId, base::NodeId>, std::set<int>> ties;
    std::map<base::NodeId, base::SourceSpan> spans;
    for (const model::Mpc& mpc : model_.mpcs) {
      const auto* tie = std::get_if<model::ConstraintEquation>(&mpc);
      if (tie == nullptr || tie->terms.size() != 2 || tie->terms[0].dof != tie->terms[1].dof ||
          tie->terms[0].coefficient != -tie->terms[1].coefficient) {
        continue;
      }
      const auto [low, high] = std::minmax(tie->terms[0].node, tie->terms[1].node);
      ties[{low, high}].insert(tie->terms[0].dof);
      spans.emplace(low, tie->span);
      spans.emplace(high, tie->span);
    }
    for (std::size_t i = 0; i < pairs_.size() && !ties.empty(); ++i) {
      const std::set<base::NodeId> one = nodes_of(pairs_[i].one);
      const std::set<base::NodeId> two = nodes_of(pairs_[i].two);
      std::set<base::NodeId> tied;
      for (const auto& [nodes, dofs] : ties) {
        const bool across = (one.contains(nodes.first) && two.contains(nodes.second)) ||
                            (two.contains(nodes.first) && one.contains(nodes.second));
        if (across && dofs.size() == static_cast<std::size_t>(mesh_.dim)) {
          tied.insert({nodes.first, nodes.second});
        }
      }
      const Faces faces = faces_within(pairs_[i].one, tied);
      if (!faces.empty()) {
        say_tied(model_.contacts[i], spans.at(nodes_of(faces.front()).front()), faces.size());
      }
    }
  }

  [[nodiscard]] std::set<base::NodeId> nodes_of(const Faces& faces) const {
    std::set<base::NodeId> nodes;
    for (const model::Face& face : faces) {
      for (const base::NodeId n : nodes_of(face)) {
        nodes.insert(n);
      }
    }
    return nodes;
  }

  // The contact brings the force over; a load on the same faces brings it once more.
  void look_at_loads() {
    for (std::size_t k = 0; k < model_.cases.size(); ++k) {
      for (const model::Load& load : model_.cases[k].loads) {
        const bool pushes = load.type == model::LoadType::bearing ||
                            load.type == model::LoadType::pressure ||
                            load.type == model::LoadType::traction;
        if (pushes && load.faces.valid()) {
          look_at_load(k, load);
        }
      }
    }
  }

  void look_at_load(std::size_t load_case, const model::Load& load) {
    const Faces faces = sorted_faces(mesh_, load.faces);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      bool acts = false;
      for (std::size_t s = 0; s < loaded_.size(); ++s) {
        acts = acts || (loaded_[s][load_case] != 0.0 && mounted_[s][i]);
      }
      const SurfaceFacePair& pair = pairs_[i];
      const std::size_t shared =
          facing(common(faces, pair.one), pair.two) + facing(common(faces, pair.two), pair.one);
      if (acts && shared > 0) {
        c_.diagnostics.warning(
            load.span, "W351",
            fmt::format("case {} loads {} of {} that contact {} presses on as well: both "
                        "act there",
                        model_.cases[load_case].name, count_of(shared),
                        mesh_.set_with_id(load.faces).name, model_.contacts[i].name),
            "a pin that is modelled is loaded itself; BEARING and PRESSURE stand for one that "
            "is not");
        return;
      }
    }
  }

  DeckContext& c_;
  const model::Model& model_;
  const model::Mesh& mesh_;
  std::vector<SurfaceFacePair> pairs_;      ///< [contact]
  std::vector<std::vector<bool>> mounted_;  ///< [step][contact] at its end
  std::vector<std::vector<double>> loaded_; ///< [step][case] at its end
};

} // namespace

void check_surfaces(DeckContext& context) {
  if (context.diagnostics.has_errors()) {
    return;
  }
  const model::Model& model = context.model;
  const bool whole = std::ranges::all_of(model.contacts, [](const model::Contact& contact) {
    return contact.slave.valid() && (contact.master.valid() || contact.rigid.valid());
  });
  if (!model.contacts.empty() && whole) {
    SurfaceConflictCheck(context).look();
  }
}

} // namespace spricka::deck
