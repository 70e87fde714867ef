// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/sets.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

// The declared normal gap: INTERFERENCE and DIAMETRAL press the surfaces into each other.
std::optional<double> declared_gap(const BoundCard& card) {
  if (card.has("GAP")) {
    return card.number("GAP");
  }
  if (card.has("INTERFERENCE")) {
    return -card.number("INTERFERENCE");
  }
  if (card.has("DIAMETRAL")) {
    return -0.5 * card.number("DIAMETRAL");
  }
  return std::nullopt;
}

bool share_a_face(const model::FaceSet& a, const model::FaceSet& b) {
  std::vector<model::Face> sorted = a.faces;
  std::sort(sorted.begin(), sorted.end());
  return std::any_of(b.faces.begin(), b.faces.end(), [&](const model::Face& f) {
    return std::binary_search(sorted.begin(), sorted.end(), f);
  });
}

void rigid(Context& c, const BoundCard& card) {
  model::Rigid rigid;
  rigid.name = card.word("NAME");
  rigid.shape = card.is("SHAPE", "ARC") ? model::RigidShape::arc : model::RigidShape::line;
  rigid.first = {card.number("X0"), card.number("Y0"), 0.0};
  rigid.second = {card.number("X1"), card.number("Y1"), 0.0};
  rigid.radius = card.number("R");
  rigid.span = card.span;
  if (rigid.shape == model::RigidShape::line && rigid.first == rigid.second) {
    c.error(card.span, "E109", "the two points of the LINE are the same");
  } else if (rigid.shape == model::RigidShape::arc && rigid.radius == 0.0) {
    c.error(card.find("R")->span, "E109", "R: the radius of an ARC is not 0",
            "positive for a shaft, negative for a bore");
  }
  c.model.rigids.push_back(std::move(rigid));
}

// The surface or rigid target that MASTER means.
void master_of(Context& c, const BoundCard& card, model::Contact& contact) {
  const Reference master = card.reference("MASTER");
  const Definition* meant = look_up(c, Kind::surface, master);
  if (meant == nullptr) {
    return;
  }
  if (meant->kind != Kind::rigid) {
    contact.master = use_face_set(c, master).value_or(base::FaceSetId());
    return;
  }
  contact.rigid = base::RigidId(meant->index);
  if (c.model.mesh.dim == 3 && c.mesh_sound) {
    c.error(master.span, "E313", fmt::format("{} is a rigid target in the plane", master.name));
  }
}

} // namespace

void build_contacts(Context& context) {
  for (const BoundCard& card : context.cards) {
    if (card.spec->name == "RIGID" && !card.bad) {
      rigid(context, card);
    }
  }
  for (const BoundCard& card : context.cards) {
    if (card.spec->name != "CONTACT" || card.bad) {
      continue;
    }
    model::Contact contact;
    contact.name = card.word("NAME");
    contact.type =
        card.is("TYPE", "BONDED") ? model::ContactType::bonded : model::ContactType::unilateral;
    contact.gap = declared_gap(card);
    contact.mu = card.number("MU");
    contact.pairing = card.is("PAIRING", "NODE") ? model::Pairing::node : model::Pairing::segment;
    contact.recovery =
        card.is("RECOVERY", "CONSISTENT") ? model::Recovery::consistent : model::Recovery::lumped;
    contact.span = card.span;
    contact.slave = use_face_set(context, card.reference("SLAVE")).value_or(base::FaceSetId());
    const Reference master = card.reference("MASTER");
    master_of(context, card, contact);
    if (contact.slave.valid() && contact.master.valid() &&
        share_a_face(context.model.mesh.set(contact.slave),
                     context.model.mesh.set(contact.master))) {
      context.error(master.span, "E316",
                    fmt::format("SLAVE and MASTER of {} have faces in common", contact.name));
    }
    context.model.contacts.push_back(contact);
  }
}

} // namespace spricka::deck
