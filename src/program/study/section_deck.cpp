// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/section_deck.hpp"

#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/study/section_loads.hpp"
#include "program/study/section_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using base::Vec3;
using deck::DeckCard;
using deck::DeckText;

constexpr double near = 1e-6; // of a thickness, a length or 1

// Cards whose work the written mesh does, or that are about patches in space.
bool is_replaced(std::string_view card) {
  constexpr std::array names{"NET",  "ENDNET", "IMPORT", "MESH",    "COOR",   "ELEMENT",
                             "NSET", "ESET",   "FSET",   "FREEDOM", "TIPNET", "VCE"};
  return std::ranges::find(names, card) != names.end();
}

class SectionMaker {
public:
  SectionMaker(const model::Model& model, const DeckText& given, sense::PlaneSection section,
               const std::string& state)
      : model_(model), given_(given), section_(std::move(section)), state_(state),
        mesh_(model, section_.mesh) {
    made_.view.plane = section_.plane;
  }

  SectionDeck run() {
    made_.reason = find_varying_load(model_, section_);
    refuse_ties();
    refuse_parts();
    DeckText after;
    for (const DeckCard& card : given_) {
      take(card, after);
    }
    hold(after);
    if (model_.growth) {
      refuse("fronts grow, farther in the middle than at the faces");
    }
    if (!made_.reason.empty()) {
      return std::move(made_);
    }
    put_together(after);
    return std::move(made_);
  }

private:
  [[nodiscard]] const sense::SectionPlane& plane() const { return section_.plane; }

  void refuse(const std::string& reason) {
    if (made_.reason.empty()) {
      made_.reason = reason;
    }
  }

  void refuse_ties() {
    if (!model_.mpcs.empty()) {
      refuse("$MPC ties freedoms of space");
    }
    if (!model_.mirrors.empty()) {
      refuse("$SYMMETRY: the whole deck is needed");
    }
  }

  void refuse_parts() {
    for (const model::Contact& contact : model_.contacts) {
      for (const base::FaceSetId id : {contact.slave, contact.master}) {
        if (id.valid() && !section_.whole[id.index()]) {
          refuse(fmt::format("contact {}: a surface of it takes a part of the thickness, or a flat "
                             "face",
                             contact.name));
        }
      }
    }
  }

  void take(const DeckCard& card, DeckText& after) {
    if (card.name == "PROPERTY") {
      DeckCard plane_card = card;
      plane_card.set("STATE", state_);
      if (!plane().round) {
        plane_card.set("THICK", twelve_digits(plane().depth()));
      }
      keep(plane_card, after);
    } else if (card.name == "LOAD") {
      keep(load_in_section(card, plane(), made_.reason), after);
    } else if (card.name == "RIGID") {
      keep(rigid(card), after);
    } else if (card.name == "CRACK") {
      keep(crack(card), after);
    } else if (card.name == "CONTACT") {
      DeckCard contact = card;
      contact.erase("MULTIPLIER");
      keep(contact, after);
    } else if (!is_replaced(card.name)) {
      keep(card, after);
    }
  }

  void keep(const DeckCard& card, DeckText& after) {
    if (card.net.empty()) {
      after.push_back(card);
    } else {
      mesh_.add_card(card);
    }
  }

  // A plane along the axis is a line, a cylinder along it a circle; about it, they are lines.
  DeckCard rigid(const DeckCard& card) {
    const auto own = std::ranges::find_if(model_.rigids, [&](const model::RigidTarget& rigid) {
      return grammar::to_upper(rigid.name) == card.word_value("NAME");
    });
    const std::string name = card.word_value("NAME");
    if (own != model_.rigids.end() && !plane().round) {
      const Vec3 along = (own->second - own->first).normalized();
      const double turned = std::abs(along[plane().axis]);
      const Vec3 first = plane().section_coordinates(own->first);
      if (own->shape == model::RigidTargetShape::cylinder && turned > 1.0 - near) {
        return rigid_circle(name, first, own->radius);
      }
      if (own->shape == model::RigidTargetShape::plane && turned < near) {
        const Vec3 way = half_line(first, direction(along));
        return rigid_line(name, first - way, first + way);
      }
    }
    refuse(fmt::format("the rigid target {} does not run along the axis", name));
    return card;
  }

  // A direction of space in the section.
  [[nodiscard]] Vec3 direction(const Vec3& v) const {
    return plane().section_coordinates(v) - plane().section_coordinates(Vec3::Zero());
  }

  // From a place on a line to its end, far beyond all bodies, which the normal points to and which
  // are on its left.
  [[nodiscard]] Vec3 half_line(const Vec3& at, const Vec3& normal) const {
    double size = 0.0;
    for (const Vec3& x : section_.mesh.x) {
      size = std::max(size, (x - at).norm());
    }
    return 2.0 * size * Vec3(normal.y(), -normal.x(), 0.0);
  }

  // A straight front through the thickness is a tip, where the crack leaves the body its mouth.
  DeckCard crack(const DeckCard& card) {
    const auto own = std::ranges::find_if(model_.cracks, [&](const model::CrackDefinition& crack) {
      return grammar::to_upper(crack.name) == card.word_value("NAME");
    });
    DeckCard flat = card;
    if (own == model_.cracks.end() || plane().round || !runs_through(*own)) {
      refuse(fmt::format("crack {} has no straight front through the thickness",
                         card.word_value("NAME")));
      return flat;
    }
    constexpr std::array of_space{"FRONT", "A",  "C",  "X0", "Y0", "Z0",     "NORMAL", "X1",
                                  "Y1",    "Z1", "X2", "Y2", "Z2", "CLOSED", "LINE",   "STATE"};
    for (const char* key : of_space) {
      flat.erase(key);
    }
    const Vec3 tip = plane().section_coordinates(own->points.front());
    const Vec3 within = plane().section_coordinates(own->plane.place);
    const std::optional<Vec3> mouth =
        (within - tip).norm() > 0.0 ? sense::find_exit_point(section_.mesh, own->net, tip, within)
                                    : std::nullopt;
    if (!mouth) {
      refuse(fmt::format("crack {} reaches no surface", card.word_value("NAME")));
      return flat;
    }
    flat.data =
        fmt::format("  {}  {}\n  {}  {}\n", twelve_digits(mouth->x()), twelve_digits(mouth->y()),
                    twelve_digits(tip.x()), twelve_digits(tip.y()));
    const Vec3 normal = direction(own->plane.normal);
    const Vec3 way = tip - *mouth;
    const double left = way.x() * normal.y() - way.y() * normal.x();
    made_.view.sign_of_K2[card.word_value("NAME")] = left > 0.0 ? 1.0 : -1.0;
    return flat;
  }

  [[nodiscard]] bool runs_through(const model::CrackDefinition& crack) const {
    if (crack.kind != model::CrackDefinitionKind::drawn || crack.plane.closed ||
        crack.points.empty()) {
      return false;
    }
    const double room = near * plane().depth();
    double first = plane().last;
    double last = plane().first;
    for (const Vec3& x : crack.points) {
      first = std::min(first, plane().normal_coordinate(x));
      last = std::max(last, plane().normal_coordinate(x));
      if ((plane().section_coordinates(x) - plane().section_coordinates(crack.points.front()))
              .norm() > room) {
        return false;
      }
    }
    return first <= plane().first + room && last >= plane().last - room;
  }

  void hold(DeckText& after) {
    for (const model::FreedomAssignment& freedom : model_.freedoms) {
      const std::vector<base::NodeId>& nodes = model_.mesh.set_with_id(freedom.nodes).nodes;
      std::array<bool, 2> held{freedom.dof.at(static_cast<std::size_t>(plane().space_axis(0))),
                               freedom.dof.at(static_cast<std::size_t>(plane().space_axis(1)))};
      if (plane().round) {
        held[0] = holds_radius(model_, section_, freedom);
      }
      if (!held[0] && !held[1]) {
        continue;
      }
      const std::vector<base::NodeId> own =
          project_nodes_onto_section(section_, model_.mesh, nodes);
      if (own.empty()) {
        refuse("a support lies away from the section");
        continue;
      }
      constexpr std::array classes{"LOCAL", "EXTERNAL", "SUPPRESSED", "PRESCRIBED", "LOCAL"};
      DeckCard card = deck::make_card(
          "FREEDOM", {{"CLASS", classes.at(static_cast<std::size_t>(freedom.cls))},
                      {"DOF", std::string(held[0] ? "X" : "") + (held[1] ? "Y" : "")}});
      for (const std::string& name : mesh_.add_node_set(fmt::format("HELD_{}", ++supports_), own)) {
        card.data += "  " + name + "\n";
      }
      append_card(after, std::move(card));
    }
    if (plane().round && !ends_are_held(model_, section_)) {
      refuse("the ends of the sector are not held across");
    }
  }

  // Units and parameters first, then the mesh.
  void put_together(DeckText& after) {
    const auto rest = std::stable_partition(after.begin(), after.end(), [](const DeckCard& card) {
      return card.name == "DECK" || card.name == "PARAMETER";
    });
    const DeckText mesh = mesh_.text();
    after.insert(rest, mesh.begin(), mesh.end());
    made_.text = std::move(after);
  }

  const model::Model& model_;
  const DeckText& given_;
  sense::PlaneSection section_;
  std::string state_;
  MeshCards mesh_;
  SectionDeck made_;
  int supports_ = 0;
};

} // namespace

SectionDeck section_deck(const model::Model& model, const DeckText& text,
                         const std::string& state) {
  SectionDeck none;
  if (model.mesh.dim != 3) {
    none.reason = "the bodies are plane";
    return none;
  }
  const bool round = state == "AXI";
  std::vector<sense::PlaneSection> sections =
      round ? sense::revolved_sections(model.mesh) : sense::extruded_sections(model.mesh);
  // Where flat faces are held it is plane strain; the thinner a body, the plainer its stress.
  std::ranges::stable_sort(sections,
                           [&](const sense::PlaneSection& a, const sense::PlaneSection& b) {
                             const bool fits_a = ends_are_held(model, a) == (state != "STRESS");
                             const bool fits_b = ends_are_held(model, b) == (state != "STRESS");
                             return fits_a != fits_b ? fits_a : a.plane.depth() < b.plane.depth();
                           });
  for (sense::PlaneSection& section : sections) {
    SectionDeck made = SectionMaker(model, text, std::move(section), state).run();
    if (made.text) {
      return made;
    }
    none.reason = none.reason.empty() ? made.reason : none.reason;
  }
  if (sections.empty()) {
    none.reason = round ? "the bodies are no sectors of one angle about an axis"
                        : "the bodies are not the same all along an axis";
  }
  return none;
}

} // namespace spricka::program
