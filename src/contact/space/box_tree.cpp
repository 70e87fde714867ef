// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/space/box_tree.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

namespace spricka::contact {

namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<Point>;
using Entry = std::pair<TreeBox, std::size_t>;

TreeBox tree_box(const ContactBoundingBox& box) {
  return {Point(box.low.x(), box.low.y(), box.low.z()),
          Point(box.high.x(), box.high.y(), box.high.z())};
}

std::vector<Entry> entries(const std::vector<ContactBoundingBox>& boxes) {
  std::vector<Entry> all;
  all.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    all.emplace_back(tree_box(boxes[i]), i);
  }
  return all;
}

} // namespace

struct BoxTree::Tree {
  bg::index::rtree<Entry, bg::index::rstar<16>> boxes;
};

// From a range the tree is packed (Leutenegger, Lopez and Edgington 1997), which is faster to ask
// than one that grew.
BoxTree::BoxTree(const std::vector<ContactBoundingBox>& boxes)
    : tree_(std::make_unique<Tree>(
          Tree{bg::index::rtree<Entry, bg::index::rstar<16>>(entries(boxes))})) {}

BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

std::vector<std::size_t> BoxTree::overlapping_boxes(const ContactBoundingBox& box) const {
  std::vector<std::size_t> found;
  for (auto it = tree_->boxes.qbegin(bg::index::intersects(tree_box(box)));
       it != tree_->boxes.qend(); ++it) {
    found.push_back(it->second);
  }
  std::ranges::sort(found);
  return found;
}

} // namespace spricka::contact
