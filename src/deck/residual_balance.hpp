// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Whether stresses that are given as residual ones can be such.
namespace spricka::deck {

struct DeckContext;

/// Warns of lines of $LOAD TYPE=RESIDUAL whose stress has a force or a moment over the section of
/// the body that a flat crack lies in, above 1 % of what its absolute values have there, or no
/// value everywhere on it.
void check_residual_balance(DeckContext& context);

} // namespace spricka::deck
