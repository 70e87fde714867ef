// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

namespace spricka::sense {

/// The plane x, y or z = `at`.
struct Reflection {
  int axis = 0;
  double at = 0.0;   ///< [length]
  double size = 0.0; ///< of the whole model [length]

  [[nodiscard]] base::Vec3 operator()(base::Vec3 x) const {
    x[axis] = 2.0 * at - x[axis];
    return x;
  }
};

} // namespace spricka::sense
