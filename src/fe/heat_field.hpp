// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/expression_range.hpp"
#include "fe/host_places.hpp"
#include "model/forward.hpp"

#include <memory>
#include <vector>

namespace spricka::fe {

/// Temperature of one load case anywhere in a mesh, whose patches know what host they stand in.
class HeatField {
public:
  HeatField() = default; ///< of nothing
  HeatField(const PatchedMesh& patched, const model::LoadCase& load_case);

  [[nodiscard]] bool empty() const { return parts_.empty(); }
  /// Whether an element may be heated at all, by a temperature that may be more than a constant.
  [[nodiscard]] bool varies(base::ElementId e) const;
  /// At x in element e. Elements of a patch are heated where the host is.
  [[nodiscard]] double operator()(base::ElementId e, const base::Vec2& x) const;
  /// Bounds over a cell, which a rim of a heated set does not cross.
  [[nodiscard]] base::ValueRange range(base::ElementId e, const base::PlaceCell& cell) const;
  /// Whether the rim of a heated set crosses the patches.
  [[nodiscard]] bool cut() const;

private:
  struct Part {
    base::Expression value;
    std::vector<bool> member; ///< [element]
    bool by_place = false;    ///< of new elements the place decides, not the element
  };
  [[nodiscard]] bool acts(std::size_t part, base::ElementId e, const base::Vec2& x) const;
  std::vector<Part> parts_;
  std::vector<std::vector<bool>> host_member_; ///< [part][host element], of those by place
  std::vector<bool> is_new_;                   ///< [element] of a patch
  std::shared_ptr<const HostPlaces> places_;
};

} // namespace spricka::fe
