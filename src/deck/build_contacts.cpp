// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/dimension_rules.hpp"
#include "deck/sets.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

// The declared normal gap: INTERFERENCE and DIAMETRAL press the surfaces into each other.
std::optional<double> declared_gap(const CheckedCard& card) {
  if (card.has_key("GAP")) {
    return card.number_value("GAP");
  }
  if (card.has_key("INTERFERENCE")) {
    return -card.number_value("INTERFERENCE");
  }
  if (card.has_key("DIAMETRAL")) {
    return -0.5 * card.number_value("DIAMETRAL");
  }
  return std::nullopt;
}

bool share_a_face(const model::FaceSet& a, const model::FaceSet& b) {
  std::vector<model::Face> sorted = a.faces;
  std::ranges::sort(sorted);
  return std::ranges::any_of(b.faces, [&](const model::Face& f) {
    return std::binary_search(sorted.begin(), sorted.end(), f);
  });
}

struct ShapeWord {
  std::string_view word;
  model::RigidTargetShape shape;
  bool two_points = false;
  bool round = false; ///< has a radius
  int dim = 3;        ///< of the bodies that meet it
};
constexpr std::array rigid_shapes{
    ShapeWord{"LINE", model::RigidTargetShape::line, true, false, 2},
    ShapeWord{"ARC", model::RigidTargetShape::arc, false, true, 2},
    ShapeWord{"PLANE", model::RigidTargetShape::plane, true, false},
    ShapeWord{"CYLINDER", model::RigidTargetShape::cylinder, true, true},
    ShapeWord{"CONE", model::RigidTargetShape::cone, true, true},
    ShapeWord{"SPHERE", model::RigidTargetShape::sphere, false, true},
};

void rigid(DeckContext& c, const CheckedCard& card) {
  const auto shape = std::ranges::find_if(
      rigid_shapes, [&](const ShapeWord& s) { return card.key_has_word("SHAPE", s.word); });
  model::RigidTarget rigid;
  rigid.name = card.word_value("NAME");
  rigid.shape = shape->shape;
  rigid.first = {card.number_value("X0"), card.number_value("Y0"), card.number_value("Z0")};
  rigid.second = {card.number_value("X1"), card.number_value("Y1"), card.number_value("Z1")};
  rigid.radius = card.number_value("R");
  rigid.second_radius = card.number_value("R1");
  rigid.span = card.span;
  const bool cone = rigid.shape == model::RigidTargetShape::cone;
  if (shape->two_points && rigid.first == rigid.second) {
    c.error(card.span, "E109", fmt::format("the two points of the {} are the same", shape->word));
  } else if (shape->round && rigid.radius == 0.0 && !cone) {
    c.error(card.find("R")->span, "E109",
            fmt::format("R: the radius of {} {} is not 0",
                        shape->shape == model::RigidTargetShape::arc ? "an" : "a", shape->word),
            "positive for a shaft, negative for a bore");
  } else if (cone &&
             (rigid.radius * rigid.second_radius < 0.0 || rigid.radius == rigid.second_radius)) {
    c.error(card.find("R1")->span, "E109", "R and R1 of a CONE differ, and have one sign",
            "positive for a shaft, negative for a bore; with equal radii it is a CYLINDER");
  }
  c.model.rigids.push_back(std::move(rigid));
}

// The surface or rigid target that MASTER means.
void master_of(DeckContext& c, const CheckedCard& card, model::Contact& contact) {
  const NameReference master = card.name_reference("MASTER");
  const NameDefinition* meant = find_referenced_definition(c, EntityKind::surface, master);
  if (meant == nullptr) {
    return;
  }
  if (meant->kind != EntityKind::rigid) {
    contact.master = resolve_face_set(c, master).value_or(base::FaceSetId());
    return;
  }
  contact.rigid = base::RigidId(meant->index);
  const int dim =
      std::ranges::find(rigid_shapes, c.model.rigids[meant->index].shape, &ShapeWord::shape)->dim;
  if (dim != c.model.mesh.dim && c.mesh_sound) {
    c.error(master.span, "E313",
            fmt::format("{} is a rigid target in {}", master.name, dimension_rules.at(dim).where),
            std::string(dimension_rules.at(c.model.mesh.dim).rigid_targets));
  }
}

} // namespace

void build_contacts(DeckContext& context) {
  context.for_each_sound_card("RIGID", [&](const CheckedCard& card) { rigid(context, card); });
  context.for_each_sound_card("CONTACT", [&](const CheckedCard& card) {
    model::Contact contact;
    contact.name = card.word_value("NAME");
    contact.type = card.key_has_word("TYPE", "BONDED") ? model::ContactType::bonded
                                                       : model::ContactType::unilateral;
    contact.gap = declared_gap(card);
    contact.mu = card.number_value("MU");
    contact.pairing = card.key_has_word("PAIRING", "NODE") ? model::PairingMethod::node
                                                           : model::PairingMethod::segment;
    contact.multiplier = card.key_has_word("MULTIPLIER", "CORNER") ? model::MultiplierNodes::corners
                                                                   : model::MultiplierNodes::nodes;
    if (contact.multiplier == model::MultiplierNodes::corners && context.is_certainly_plane()) {
      context.error(card.find("MULTIPLIER")->span, "E313",
                    "MULTIPLIER=CORNER is one of contacts between solids");
    }
    contact.recovery = card.key_has_word("RECOVERY", "CONSISTENT")
                           ? model::PressureRecovery::consistent
                           : model::PressureRecovery::lumped;
    contact.span = card.span;
    contact.slave =
        resolve_face_set(context, card.name_reference("SLAVE")).value_or(base::FaceSetId());
    const NameReference master = card.name_reference("MASTER");
    master_of(context, card, contact);
    if (contact.slave.valid() && contact.master.valid() &&
        share_a_face(context.model.mesh.set_with_id(contact.slave),
                     context.model.mesh.set_with_id(contact.master))) {
      context.error(master.span, "E316",
                    fmt::format("SLAVE and MASTER of {} have faces in common", contact.name));
    }
    context.model.contacts.push_back(contact);
  });
}

} // namespace spricka::deck
