// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression.hpp"
#include "fe/host_places.hpp"
#include "model/forward.hpp"

#include <memory>
#include <vector>

namespace spricka::fe {

/// Temperature of one load case anywhere in a mesh, whose patches know what host they stand in.
class TemperatureField {
public:
  TemperatureField() = default; ///< of nothing
  TemperatureField(const PatchedMesh& patched, const model::LoadCase& load_case);

  [[nodiscard]] bool empty() const { return parts_.empty(); }
  /// Whether an element may be heated at all, by a temperature that may be more than a constant.
  [[nodiscard]] bool may_vary_inside(base::ElementId e) const;
  /// At x in element e. Elements of a patch in the plane are heated where the host is.
  [[nodiscard]] double operator()(base::ElementId e, const base::Vec3& x) const;
  [[nodiscard]] double operator()(base::ElementId e, const base::Vec2& x) const {
    return (*this)(e, base::Vec3(x.x(), x.y(), 0.0));
  }

private:
  struct HeatedSet {
    base::CompiledExpression value;
    std::vector<bool> member; ///< [element]
    bool by_place = false;    ///< of new elements the place decides, not the element
  };
  [[nodiscard]] bool acts(std::size_t part, base::ElementId e, const base::Vec3& x) const;
  std::vector<HeatedSet> parts_;
  std::vector<std::vector<bool>> host_member_;      ///< [part][host element], of those by place
  std::vector<bool> is_new_;                        ///< [element] of a patch
  std::shared_ptr<const HostElementFinder> places_; ///< in the plane
};

} // namespace spricka::fe
