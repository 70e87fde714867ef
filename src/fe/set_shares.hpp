// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/id.hpp"
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <array>
#include <vector>

/// Element sets of the deck on a mesh with cracks, whose patches do not follow the sets' rims.
namespace spricka::fe {

/// How much of a region lies in an element that its rim cuts: the region's indicator, projected
/// onto linear functions of the element, so that its integral and first moments are kept.
struct CutElementShareFunction {
  base::ElementId element;
  std::array<double, 3> c{}; ///< c0 + c1 (x - at.x) + c2 (y - at.y)
  base::Vec2 at = base::Vec2::Zero();

  [[nodiscard]] double operator()(const base::Vec3& x) const {
    return c[0] + c[1] * (x.x() - at.x()) + c[2] * (x.y() - at.y());
  }
};

/// The elements that a load per volume on a set acts on, and how.
struct ElementSetCoverage {
  std::vector<base::ElementId> elements;    ///< each once: those of the set and those that it cuts
  std::vector<CutElementShareFunction> cut; ///< ascending; all others count as a whole

  /// Of an element; null: as a whole.
  [[nodiscard]] const CutElementShareFunction* find_cut_share_function(base::ElementId e) const;
};

/// The shares of a set of the deck on `mesh`, the deck's own or one with cracks in it: there new
/// elements stand in the place of some of the deck's (mesh/cut/patch.hpp). Integrals of the shares
/// add up to the area of what the set covers on the deck's mesh, and to its first moments but for
/// curved rims.
ElementSetCoverage find_set_coverage(const model::Model& model, const model::Mesh& mesh,
                                     base::ElementSetId set);

} // namespace spricka::fe
