// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/sets.hpp"

#include <algorithm>

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

} // namespace

void build_contacts(Context& context) {
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
    const Definition* meant = look_up(context, Kind::surface, master);
    if (meant != nullptr && meant->kind != Kind::rigid) {
      contact.master = use_face_set(context, master).value_or(base::FaceSetId());
    }
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
