// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

#include <optional>
#include <vector>

/// Sets by reference. A set card is built when its set is first used, so that the order of the
/// cards is free. Empty results mean an error that is reported already, or a poisoned name.
namespace spricka::deck {

/// A node set; a face set stands for its nodes.
std::optional<base::NodeSetId> resolve_node_set(DeckContext& context,
                                                const NameReference& reference);

/// A face set; a node set stands for the boundary faces all of whose nodes lie in it.
std::optional<base::FaceSetId> resolve_face_set(DeckContext& context,
                                                const NameReference& reference);

/// An element set by its name; no other kind stands for one.
std::optional<base::ElementSetId> resolve_element_set(DeckContext& context,
                                                      const NameReference& reference);

/// The kind of set a reference means, first of `kind`'s meanings first.
std::optional<EntityKind> resolve_set_kind(DeckContext& context, EntityKind kind,
                                           const NameReference& reference);

/// The nodes that the data lines of a card list, each once, in the order they are listed.
std::optional<std::vector<base::NodeId>> collect_listed_nodes(DeckContext& context,
                                                              const CheckedCard& card);

/// A field that names a set, as a reference; empty after an error.
std::optional<NameReference> read_set_name_field(DeckContext& context, const CheckedCard& card,
                                                 const grammar::CardField& field);

} // namespace spricka::deck
