// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

#include <optional>
#include <vector>

/// Sets by reference. A set card is built when its set is first used, so that the order of the
/// cards is free. Empty results mean an error that is reported already, or a poisoned name.
namespace spricka::deck {

/// A node set; a face set stands for its nodes.
std::optional<base::NodeSetId> use_node_set(Context& context, const Reference& reference);

/// A face set; a node set stands for the boundary faces all of whose nodes lie in it.
std::optional<base::FaceSetId> use_face_set(Context& context, const Reference& reference);

std::optional<base::ElementSetId> use_element_set(Context& context, const Reference& reference);

/// The kind of set a reference means, first of `kind`'s meanings first.
std::optional<Kind> kind_of_set(Context& context, Kind kind, const Reference& reference);

/// The nodes that the data lines of a card list, each once, in the order they are listed.
std::optional<std::vector<base::NodeId>> node_items(Context& context, const BoundCard& card);

/// A field that names a set, as a reference; empty after an error.
std::optional<Reference> set_field(Context& context, const BoundCard& card,
                                   const grammar::Field& field);

} // namespace spricka::deck
