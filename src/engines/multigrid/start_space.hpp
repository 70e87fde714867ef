// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <vector>

namespace spricka::engines {

/// Solutions that are known, from which later ones start (Fischer 1998): of A u = b the combination
/// of them with the least error in the strain energy. Loads that are combined of those known need
/// no iteration.
class StartSpace {
public:
  /// A solution u [n] and A u, which is not kept. One that the others make already is left out.
  void add(const base::Vector& u, const base::Vector& Au);
  /// That combination [n] for a right-hand side b [n]; zero while nothing is known.
  [[nodiscard]] base::Vector nearest(const base::Vector& b) const;

private:
  std::vector<base::Vector> solutions_; ///< A-orthonormal
};

} // namespace spricka::engines
