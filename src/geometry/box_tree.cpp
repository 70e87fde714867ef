// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/box_tree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace spricka::geometry {

namespace {

namespace bg = boost::geometry;
template <int dim> using TreePoint = bg::model::point<double, dim, bg::cs::cartesian>;
template <int dim> using TreeBox = bg::model::box<TreePoint<dim>>;
template <int dim> using TreeEntry = std::pair<TreeBox<dim>, std::size_t>;

TreePoint<2> tree_point(const base::Vec2& x) {
  return {x.x(), x.y()};
}

TreePoint<3> tree_point(const base::Vec3& x) {
  return {x.x(), x.y(), x.z()};
}

template <int dim> TreeBox<dim> tree_box(const Box<dim>& box) {
  return {tree_point(box.low), tree_point(box.high)};
}

template <int dim> std::vector<TreeEntry<dim>> tree_entries(const std::vector<Box<dim>>& boxes) {
  std::vector<TreeEntry<dim>> entries;
  entries.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    entries.emplace_back(tree_box(boxes[i]), i);
  }
  return entries;
}

} // namespace

template <int dim> struct BoxTree<dim>::Tree {
  // From a range the tree is packed, which is faster to ask than one that grew.
  explicit Tree(const std::vector<Box<dim>>& all) : boxes(all), packed(tree_entries(all)) {
    constexpr double least_scale = 1e-3; // of all boxes, where they are points
    for (const Box<dim>& box : all) {
      bounds.extend(box);
      longest = std::max(longest, box.diagonal());
      scale += box.diagonal() / static_cast<double>(all.size());
    }
    scale = std::max(scale, least_scale * bounds.diagonal());
  }

  /// Those that meet a box and fulfil a condition, ascending.
  template <class Condition>
  [[nodiscard]] std::vector<std::size_t> find(const Box<dim>& box, Condition&& condition) const {
    std::vector<std::size_t> found;
    for (auto it = packed.qbegin(bg::index::intersects(tree_box(box))); it != packed.qend(); ++it) {
      if (condition(boxes[it->second])) {
        found.push_back(it->second);
      }
    }
    std::ranges::sort(found);
    return found;
  }

  std::vector<Box<dim>> boxes;
  bg::index::rtree<TreeEntry<dim>, bg::index::rstar<16>> packed;
  Box<dim> bounds;
  double longest = 0.0; ///< diagonal
  double scale = 0.0;   ///< mean diagonal
};

template <int dim>
BoxTree<dim>::BoxTree(const std::vector<Box<dim>>& boxes) : tree_(std::make_unique<Tree>(boxes)) {}
template <int dim> BoxTree<dim>::~BoxTree() = default;
template <int dim> BoxTree<dim>::BoxTree(BoxTree&&) noexcept = default;
template <int dim> BoxTree<dim>& BoxTree<dim>::operator=(BoxTree&&) noexcept = default;

template <int dim>
std::vector<std::size_t> BoxTree<dim>::boxes_intersecting(const Box<dim>& box) const {
  return tree_->find(box, [](const Box<dim>&) { return true; });
}

template <int dim>
std::vector<std::size_t> BoxTree<dim>::boxes_within(const Point& x, double distance) const {
  return tree_->find(Box<dim>{x, x}.grown(distance),
                     [&](const Box<dim>& box) { return box.distance(x) <= distance; });
}

template <int dim>
std::vector<std::size_t> BoxTree<dim>::boxes_meeting_segment(const Point& from, const Point& to,
                                                             double margin) const {
  Box<dim> ends{from, from};
  ends.extend({to, to});
  return tree_->find(ends.grown(margin * tree_->longest), [&](const Box<dim>& box) {
    return box.grown(margin * box.diagonal()).meets_segment(from, to);
  });
}

// Shell by shell about x, each twice as thick as the one before: Boost's incremental nearest query
// sorts all it has found again for each leaf, which takes long where many boxes are as near.
template <int dim>
void BoxTree<dim>::visit_nearest(const Point& x, const std::function<double(std::size_t)>& visit,
                                 double reach) const {
  double from = -1.0; // boxes up to this distance are done
  double thickness = tree_->scale;
  double to = tree_->bounds.distance(x) + thickness;
  std::size_t done = 0;
  while (done < tree_->boxes.size() && from < reach) {
    to = std::min(to, reach);
    std::vector<std::pair<double, std::size_t>> shell;
    for (const std::size_t i : boxes_within(x, to)) {
      if (const double distance = tree_->boxes[i].distance(x); distance > from) {
        shell.emplace_back(distance, i);
      }
    }
    std::ranges::sort(shell);
    for (const auto& [distance, i] : shell) {
      if (distance > reach) {
        return;
      }
      reach = visit(i);
    }
    done += shell.size();
    from = to;
    thickness *= 2.0;
    to += thickness;
  }
}

template <int dim>
std::optional<std::size_t>
BoxTree<dim>::nearest(const Point& x, const std::function<double(std::size_t)>& distance) const {
  const double round_off = 1e-12 * tree_->bounds.diagonal();
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  visit_nearest(x, [&](std::size_t i) {
    const double d = distance(i);
    if (d < least || (d == least && best && i < *best)) {
      least = d;
      best = i;
    }
    return least + round_off;
  });
  return best;
}

template class BoxTree<2>;
template class BoxTree<3>;

} // namespace spricka::geometry
