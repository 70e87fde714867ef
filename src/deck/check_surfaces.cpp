// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/facing_surfaces.hpp"
#include "deck/step_actions.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <variant>
#include <vector>

#include <fmt/format.h>

/// Surfaces that two cards speak of: what a contact holds already must not be held, or loaded, by
/// another card as well.
namespace spricka::deck {

namespace {

std::string count_of(std::size_t faces) {
  return fmt::format("{} face{}", faces, faces == 1 ? "" : "s");
}

FacingSurfaces pair_of(const model::Mesh& mesh, const model::Contact& contact) {
  return {sorted_set_faces(mesh, contact.slave),
          contact.master.valid() ? sorted_set_faces(mesh, contact.master) : Faces()};
}

class SurfaceConflictCheck {
public:
  explicit SurfaceConflictCheck(DeckContext& context)
      : c_(context), model_(context.model), mesh_(model_.mesh), ends_(step_end_states(model_)) {
    for (const model::Contact& contact : model_.contacts) {
      pairs_.push_back(pair_of(mesh_, contact));
    }
    if (ends_.empty()) { // without steps: all along
      ends_.push_back(
          {std::vector<double>(model_.cases.size(), 0.0), {}, contacts_mounted_at_start(model_)});
    }
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
  [[nodiscard]] bool together(std::size_t a, std::size_t b) const {
    return std::ranges::any_of(
        ends_, [&](const StepEndState& end) { return end.mounted[a] && end.mounted[b]; });
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
      faces = first.rigid == second.rigid ? common_faces(pairs_[a].one, pairs_[b].one).size() : 0;
    } else {
      const FacingSurfaces swapped{pairs_[b].two, pairs_[b].one};
      faces = std::max(doubly_paired_face_count(mesh_, pairs_[a], pairs_[b]),
                       doubly_paired_face_count(mesh_, pairs_[a], swapped));
    }
    if (faces > 0 && alike(first, second)) {
      c_.warning(
          second.span, "W354",
          fmt::format("contact {} pairs {} that contact {} in line {} pairs already ({}): "
                      "displacements and K are those of one, how the two share the pressure is "
                      "left open",
                      second.name, count_of(faces), first.name, c_.line_number(first.span),
                      surfaces_of(first)),
          "take one of them away");
    } else if (faces > 0) {
      const bool types = first.type != second.type;
      c_.error(second.span, "E351",
               fmt::format("contact {} pairs {} that contact {} in line {} pairs already "
                           "({}){}",
                           second.name, count_of(faces), first.name, c_.line_number(first.span),
                           surfaces_of(first), types ? ": one bonds what the other lets part" : ""),
               "take one of them away; for one after the other DISMOUNT the first in the step that "
               "says MOUNT for the second");
    }
  }

  void say_tied(const model::Contact& contact, base::SourceSpan tie, std::size_t faces) {
    c_.error(contact.span, "E352",
             fmt::format("contact {} pairs {} that the $MPC in line {} ties already ({})",
                         contact.name, count_of(faces), c_.line_number(tie), surfaces_of(contact)),
             "tied surfaces cannot press or part: take the $CONTACT away, or the $MPC");
  }

  void look_at_tie(const model::TransitionTie& tie) {
    if (!tie.slave.valid() || !tie.master.valid()) {
      return;
    }
    const std::vector<base::NodeId>& list = mesh_.set_with_id(tie.slave).nodes;
    const std::set<base::NodeId> nodes(list.begin(), list.end());
    const Faces master = sorted_set_faces(mesh_, tie.master);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const FacingSurfaces& pair = pairs_[i];
      const FacingSurfaces here{faces_with_all_corners_in(mesh_, pair.one, nodes), master};
      const FacingSurfaces turned{faces_with_all_corners_in(mesh_, pair.two, nodes), master};
      const std::size_t faces =
          std::max(doubly_paired_face_count(mesh_, pair, here),
                   doubly_paired_face_count(mesh_, {pair.two, pair.one}, turned));
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
      const FacingSurfaces& pair = pairs_[i];
      const bool both = !pair.two.empty() &&
                        faces_with_all_corners_in(mesh_, pair.one, nodes) == pair.one &&
                        faces_with_all_corners_in(mesh_, pair.two, nodes) == pair.two;
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
      const std::set<base::NodeId> one = face_corner_nodes(mesh_, pairs_[i].one);
      const std::set<base::NodeId> two = face_corner_nodes(mesh_, pairs_[i].two);
      std::set<base::NodeId> tied;
      for (const auto& [nodes, dofs] : ties) {
        const bool across = (one.contains(nodes.first) && two.contains(nodes.second)) ||
                            (two.contains(nodes.first) && one.contains(nodes.second));
        if (across && dofs.size() == static_cast<std::size_t>(mesh_.dim)) {
          tied.insert({nodes.first, nodes.second});
        }
      }
      const Faces faces = faces_with_all_corners_in(mesh_, pairs_[i].one, tied);
      if (!faces.empty()) {
        say_tied(model_.contacts[i], spans.at(mesh::face_nodes(mesh_, faces.front()).all.front()),
                 faces.size());
      }
    }
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
    const Faces faces = sorted_set_faces(mesh_, load.faces);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const bool acts = std::ranges::any_of(ends_, [&](const StepEndState& end) {
        return end.load[load_case] != 0.0 && end.mounted[i];
      });
      const FacingSurfaces& pair = pairs_[i];
      const std::size_t shared = facing_face_count(mesh_, common_faces(faces, pair.one), pair.two) +
                                 facing_face_count(mesh_, common_faces(faces, pair.two), pair.one);
      if (acts && shared > 0) {
        c_.warning(
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
  std::vector<FacingSurfaces> pairs_; ///< [contact]
  std::vector<StepEndState> ends_;
};

} // namespace

void check_conflicting_surfaces(DeckContext& context) {
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
