// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace spricka::geometry {

/// Axis-aligned boxes of the plane (dim 2) or of space (dim 3) in a tree (R-tree, Guttman 1984;
/// packed, Leutenegger, Lopez and Edgington 1997), so that some are found without asking all. Boxes
/// are told by their number as given. Answers depend on the boxes only; any number of threads may
/// ask at once.
template <int dim> class BoxTree {
public:
  using Point = typename Box<dim>::Point;

  explicit BoxTree(const std::vector<Box<dim>>& boxes = {});
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;

  /// Those that contain x, ascending.
  [[nodiscard]] std::vector<std::size_t> boxes_containing(const Point& x) const {
    return boxes_intersecting({x, x});
  }
  /// Those that have a point in common with `box`, ascending.
  [[nodiscard]] std::vector<std::size_t> boxes_intersecting(const Box<dim>& box) const;
  /// Those no farther than `distance` [length] from x, ascending.
  [[nodiscard]] std::vector<std::size_t> boxes_within(const Point& x, double distance) const;
  /// Those that the segment between two points meets when each is grown by `margin` of its
  /// diagonal, ascending.
  [[nodiscard]] std::vector<std::size_t> boxes_meeting_segment(const Point& from, const Point& to,
                                                               double margin = 0.0) const;

  /// For the nearest of what lies in the boxes: calls `visit` with one after another by their
  /// distance from x, of those as near the lower number first. Only boxes no farther than `reach`
  /// [length] matter, which each call returns anew (the least exact distance so far).
  void visit_nearest(const Point& x, const std::function<double(std::size_t)>& visit,
                     double reach = std::numeric_limits<double>::infinity()) const;

  /// Of what lies in the boxes that with the least `distance` [length] from x, exact but for
  /// round-off; of several as near that with the lowest number. Nothing of no boxes.
  [[nodiscard]] std::optional<std::size_t>
  nearest(const Point& x, const std::function<double(std::size_t)>& distance) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

extern template class BoxTree<2>;
extern template class BoxTree<3>;

} // namespace spricka::geometry
