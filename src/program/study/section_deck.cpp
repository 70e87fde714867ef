// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/lexeme.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"
#include "program/study/deck_variant.hpp"
#include "program/study/section_cards.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

using base::Vec3;
using deck::DeckCard;
using deck::DeckCardList;

constexpr double near = 1e-6; // of a thickness, a length or 1

bool is_one_of(std::initializer_list<std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

// What a card names, by its name in upper case; null: the model does not have it.
template <class Named>
const Named* find_by_name(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::ranges::find_if(
      all, [&](const Named& one) { return grammar::to_upper(one.name) == name; });
  return found == all.end() ? nullptr : &*found;
}

class SectionMaker {
public:
  SectionMaker(const model::Model& model, sense::PlaneSectionMesh section, const std::string& state)
      : model_(model), section_(std::move(section)), state_(state) {
    made_.section = {section_.plane, {}};
  }

  // Units and parameters first, then the mesh with the cards of its nets.
  DeckVariant run(const DeckCardList& given) && {
    refuse_what_varies();
    DeckCardList first;
    DeckCardList in_nets;
    DeckCardList after;
    for (const DeckCard& card : given) {
      if (std::optional<DeckCard> flat = flattened(card)) {
        DeckCardList& cards = is_one_of({"DECK", "PARAMETER"}, card.name) ? first
                              : flat->net.empty()                         ? after
                                                                          : in_nets;
        cards.push_back(std::move(*flat));
      }
    }
    hold(after);
    refuse_if(model_.growth.has_value(), "fronts grow, farther in the middle than at the faces");
    if (made_.reason.empty()) {
      const DeckCardList mesh = write_mesh_cards(model_, section_.mesh, in_nets);
      first.insert(first.end(), mesh.begin(), mesh.end());
      first.insert(first.end(), after.begin(), after.end());
      made_.text = std::move(first);
    }
    return std::move(made_);
  }

private:
  [[nodiscard]] const sense::SectionPlane& plane() const { return section_.plane; }

  void refuse_if(bool condition, const std::string& reason) {
    if (condition && made_.reason.empty()) {
      made_.reason = reason;
    }
  }

  void refuse_what_varies() {
    made_.reason = describe_varying_load(model_, section_);
    refuse_if(!model_.mpcs.empty(), "$MPC ties freedoms of space");
    refuse_if(!model_.mirrors.empty(), "$SYMMETRY: the whole deck is needed");
    for (const model::Contact& contact : model_.contacts) {
      for (const base::FaceSetId id : {contact.slave, contact.master}) {
        refuse_if(id.valid() && !section_.whole[id.index()],
                  fmt::format("contact {}: a surface of it takes a part of the thickness, or a "
                              "flat face",
                              contact.name));
      }
    }
  }

  // Empty: the written mesh does its work, or it is about patches in space.
  std::optional<DeckCard> flattened(DeckCard card) {
    if (is_one_of({"NET", "ENDNET", "IMPORT", "MESH", "COOR", "ELEMENT", "NSET", "ESET", "FSET",
                   "FREEDOM", "TIPNET", "VCE"},
                  card.name)) {
      return std::nullopt;
    }
    if (card.name == "PROPERTY") {
      card.set_key("STATE", state_);
      if (!plane().round) {
        card.set_key("THICK", format_twelve_digits(plane().depth()));
      }
    } else if (card.name == "LOAD") {
      project_load_onto_section(card, plane(), made_.reason);
    } else if (card.name == "RIGID") {
      flatten_rigid(card);
    } else if (card.name == "CRACK") {
      flatten_crack(card);
    } else if (card.name == "CONTACT") {
      card.erase("MULTIPLIER");
    }
    return card;
  }

  // A plane along the axis is a line, a cylinder along it a circle; about it, they are lines.
  void flatten_rigid(DeckCard& card) {
    const std::string name = card.word_value("NAME");
    const model::RigidTarget* own = find_by_name(model_.rigids, name);
    if (own != nullptr && !plane().round) {
      const Vec3 along = (own->second - own->first).normalized();
      const double turned = std::abs(along[plane().axis]);
      const Vec3 first = plane().section_coordinates(own->first);
      if (own->shape == model::RigidTargetShape::cylinder && turned > 1.0 - near) {
        card = make_rigid_circle_card(name, first, own->radius);
        return;
      }
      if (own->shape == model::RigidTargetShape::plane && turned < near) {
        const Vec3 way = half_line(first, direction(along));
        card = make_rigid_line_card(name, first - way, first + way);
        return;
      }
    }
    refuse_if(true, fmt::format("the rigid target {} does not run along the axis", name));
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
  void flatten_crack(DeckCard& card) {
    const std::string name = card.word_value("NAME");
    const model::CrackDefinition* own = find_by_name(model_.cracks, name);
    if (own == nullptr || plane().round || !runs_through(*own)) {
      refuse_if(true, fmt::format("crack {} has no straight front through the thickness", name));
      return;
    }
    for (const char* key : {"FRONT", "A", "C", "X0", "Y0", "Z0", "NORMAL", "X1", "Y1", "Z1", "X2",
                            "Y2", "Z2", "CLOSED", "LINE", "STATE"}) {
      card.erase(key);
    }
    const Vec3 tip = plane().section_coordinates(own->points.front());
    const Vec3 within = plane().section_coordinates(own->plane.place);
    const std::optional<Vec3> mouth =
        (within - tip).norm() > 0.0
            ? sense::find_line_exit_from_net(section_.mesh, own->net, tip, within)
            : std::nullopt;
    if (!mouth) {
      refuse_if(true, fmt::format("crack {} reaches no surface", name));
      return;
    }
    card.data = fmt::format("  {}  {}\n  {}  {}\n", format_twelve_digits(mouth->x()),
                            format_twelve_digits(mouth->y()), format_twelve_digits(tip.x()),
                            format_twelve_digits(tip.y()));
    const double left = (tip - *mouth).cross(direction(own->plane.normal)).z();
    made_.section->sign_of_K2[name] = left > 0.0 ? 1.0 : -1.0;
  }

  [[nodiscard]] bool runs_through(const model::CrackDefinition& crack) const {
    if (crack.kind != model::CrackDefinitionKind::drawn || crack.plane.closed ||
        crack.points.empty()) {
      return false;
    }
    const double room = near * plane().depth();
    const Vec3 tip = plane().section_coordinates(crack.points.front());
    double first = plane().last;
    double last = plane().first;
    for (const Vec3& x : crack.points) {
      first = std::min(first, plane().normal_coordinate(x));
      last = std::max(last, plane().normal_coordinate(x));
      if ((plane().section_coordinates(x) - tip).norm() > room) {
        return false;
      }
    }
    return first <= plane().first + room && last >= plane().last - room;
  }

  // Supports, each by a set of its own in the section's mesh.
  void hold(DeckCardList& after) {
    int supports = 0;
    for (const model::NodeSetFreedomRole& freedom : model_.freedoms) {
      const bool x =
          plane().round
              ? support_holds_radius(model_, section_, freedom)
              : freedom.dof.at(static_cast<std::size_t>(plane().space_direction_index(0)));
      const bool y = freedom.dof.at(static_cast<std::size_t>(plane().space_direction_index(1)));
      if (!x && !y) {
        continue;
      }
      std::vector<base::NodeId> own = project_nodes_onto_section(
          section_, model_.mesh, model_.mesh.set_with_id(freedom.nodes).nodes);
      if (own.empty()) {
        refuse_if(true, "a support lies away from the section");
        continue;
      }
      constexpr std::array classes{"LOCAL", "EXTERNAL", "SUPPRESSED", "PRESCRIBED", "LOCAL"};
      const std::string set = unused_set_name(section_.mesh, fmt::format("HELD_{}", ++supports));
      section_.mesh.node_sets.push_back({set, std::move(own), {}});
      append_card(after,
                  deck::make_card("FREEDOM",
                                  {{"CLASS", classes.at(static_cast<std::size_t>(freedom.cls))},
                                   {"DOF", std::string(x ? "X" : "") + (y ? "Y" : "")}},
                                  "  " + set + "\n"));
    }
    refuse_if(plane().round && !ends_are_held(model_, section_),
              "the ends of the sector are not held across");
  }

  const model::Model& model_;
  sense::PlaneSectionMesh section_;
  std::string state_;
  DeckVariant made_;
};

} // namespace

DeckVariant make_section_deck(const model::Model& model, const DeckCardList& text,
                              const std::string& state) {
  if (model.mesh.dim != 3) {
    return make_refused_variant("the bodies are plane");
  }
  DeckVariant none;
  const bool round = state == "AXI";
  std::vector<sense::PlaneSectionMesh> sections =
      round ? sense::find_revolved_sections(model.mesh) : sense::find_extruded_sections(model.mesh);
  // Where flat faces are held it is plane strain; the thinner a body, the plainer its stress.
  std::ranges::stable_sort(sections,
                           [&](const sense::PlaneSectionMesh& a, const sense::PlaneSectionMesh& b) {
                             const bool fits_a = ends_are_held(model, a) == (state != "STRESS");
                             const bool fits_b = ends_are_held(model, b) == (state != "STRESS");
                             return fits_a != fits_b ? fits_a : a.plane.depth() < b.plane.depth();
                           });
  for (sense::PlaneSectionMesh& section : sections) {
    DeckVariant made = SectionMaker(model, std::move(section), state).run(text);
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
