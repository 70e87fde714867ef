// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/mount_memory.hpp"

#include <algorithm>

namespace spricka::run {

namespace {

// Host nodes keep their numbers from length to length, so that rows can be told by them.
bool same_row(const contact::ConstraintRow& a, const contact::ConstraintRow& b) {
  return a.node == b.node && a.tangential == b.tangential && a.area == b.area &&
         std::ranges::equal(a.entries, b.entries,
                            [](const contact::RowEntry& p, const contact::RowEntry& q) {
                              return p.node == q.node && p.weight == q.weight;
                            });
}

} // namespace

bool MountMemory::keep_or_take(const Scene& scene, std::size_t contact, bool rubs,
                               base::Vector& offset) {
  const std::size_t first = scene.table.first[contact];
  const std::size_t count = scene.table.first[contact + 1] - first;
  auto part = offset.segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(count));
  if (next_ == events_.size()) {
    Event event{contact, {}, part};
    for (std::size_t r = 0; r < count; ++r) {
      event.rows.push_back(*scene.table.rows[first + r]);
    }
    events_.push_back(std::move(event));
    ++next_;
    return true;
  }
  const Event& event = events_[next_++];
  bool same = event.contact == contact && event.rows.size() == count;
  for (std::size_t r = 0; same && r < count; ++r) {
    const contact::ConstraintRow& row = *scene.table.rows[first + r];
    same = same_row(event.rows[r], row);
    if (same && !(rubs && row.tangential)) {
      part[static_cast<Eigen::Index>(r)] = event.offset[static_cast<Eigen::Index>(r)];
    }
  }
  return same;
}

} // namespace spricka::run
