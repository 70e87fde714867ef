// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace spricka::mesh {

/// Finds sides of elements by their corner nodes, in whatever order these are given. Made in linear
/// time: sides are kept by their lowest corner.
class SideIndex {
public:
  /// Sides of the elements from `first` on; with `corners` [node] those alone of which all corners
  /// are marked.
  explicit SideIndex(const model::Mesh& mesh, std::size_t first = 0,
                     const std::vector<bool>* corners = nullptr);

  /// The sides with these corners, 2 to 4: none, one on the boundary, two between elements.
  [[nodiscard]] std::span<const model::Face> find(std::span<const base::NodeId> corners) const;

  /// Calls f with all sides that have the same corners, by elements, once for each such group.
  template <class F> void for_same_sides(F&& f) const {
    for (std::size_t n = 0; n + 1 < begin_.size(); ++n) {
      for (std::size_t i = begin_[n]; i < begin_[n + 1];) {
        std::size_t j = i + 1;
        while (j < begin_[n + 1] && others_[j] == others_[i]) {
          ++j;
        }
        f(std::span(faces_).subspan(i, j - i));
        i = j;
      }
    }
  }

  /// Sides that belong to one element only, ascending.
  [[nodiscard]] std::vector<model::Face> unshared_sides() const;

private:
  using Others = std::array<base::NodeId, 3>; ///< the other corners, ascending
  std::vector<std::size_t> begin_;            ///< [node + 1] into the two below
  std::vector<Others> others_;
  std::vector<model::Face> faces_;
};

/// The side with these corners, in whatever order. Between two elements it is that of the element
/// on the left of the corners' own direction (in space: below their normal).
std::optional<model::Face> find_side_below(const model::Mesh& mesh, const SideIndex& sides,
                                           std::span<const base::NodeId> corners);

} // namespace spricka::mesh
