// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"

#include <optional>

namespace spricka::model {

/// A plane of symmetry across an axis, through the middle of all bodies, of which one side is
/// modelled.
struct MirrorPlane {
  int axis = 0;      ///< 0 x, 1 y, 2 z: its normal
  bool above = true; ///< the side with the larger coordinates is kept, else the other
  /// Where it lies, once the other side has been left away [length].
  std::optional<double> at;
  base::SourceSpan span;
};

} // namespace spricka::model
