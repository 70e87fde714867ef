// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/tip_setting.hpp"

namespace spricka::crack {

/// G by a finite shift: (potential energy with the nodes of the field moved by -s q e1 - with them
/// moved by s q e1) / 2s, displacements kept (manual, crack.15). One side of a symmetry line only.
/// What acts on the crack faces works on displacements relative to the tip's, as what comes on top
/// where they become longer is no part of G.
double finite_shift_release_rate(const TipContext& set, const VirtualExtensionField& field,
                                 double s, const base::Vector& u);

} // namespace spricka::crack
