// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace spricka::contact {

struct ContactBoundingBox {
  base::Vec3 low, high;
};

/// Boxes in a tree, so that those which a box meets are found without asking all.
class BoxTree {
public:
  explicit BoxTree(const std::vector<ContactBoundingBox>& boxes);
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;

  /// Those that `box` meets, ascending.
  [[nodiscard]] std::vector<std::size_t> overlapping_boxes(const ContactBoundingBox& box) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

} // namespace spricka::contact
