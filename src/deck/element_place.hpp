// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/context.hpp"

namespace spricka::deck {

/// The card and rows that made an element, by its index.
const ElementOrigin& element_origin(const DeckContext& context, std::size_t element);

/// Its row of an $ELEMENT table, or the card that meshed it.
base::SourceSpan element_source_span(const DeckContext& context, std::size_t element);

} // namespace spricka::deck
