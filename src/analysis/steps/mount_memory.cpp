// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/mount_memory.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

namespace {

// Host nodes keep their numbers from length to length, so that rows can be told by them.
bool same_row(const contact::ConstraintRow& a, const contact::ConstraintRow& b) {
  return a.node == b.node && a.tangential == b.tangential && a.area == b.area &&
         std::ranges::equal(a.entries, b.entries,
                            [](const contact::RowEntry& p, const contact::RowEntry& q) {
                              return p.node == q.node && p.weight == q.weight;
                            });
}

// Takes one array's values one after another.
template <class T> class Reading {
public:
  Reading(const std::map<std::string, std::vector<T>>& arrays, std::string name)
      : name_(std::move(name)) {
    if (const auto found = arrays.find(name_); found != arrays.end()) {
      values_ = &found->second;
    }
  }
  [[nodiscard]] bool more() const { return left() > 0; }
  [[nodiscard]] std::size_t left() const {
    return values_ != nullptr ? values_->size() - next_ : 0;
  }
  T next() {
    if (!more()) {
      throw base::CorruptStoredField(name_, "it is incomplete");
    }
    return (*values_)[next_++];
  }

private:
  std::string name_;
  const std::vector<T>* values_ = nullptr;
  std::size_t next_ = 0;
};

} // namespace

void MountOffsetMemory::save_state(results::NamedArrays& arrays) const {
  auto& whole = arrays.integers;
  auto& real = arrays.reals;
  for (const MountEvent& event : events_) {
    whole["mount.contact"].push_back(static_cast<std::int64_t>(event.contact));
    whole["mount.rows"].push_back(static_cast<std::int64_t>(event.rows.size()));
    for (std::size_t r = 0; r < event.rows.size(); ++r) {
      const contact::ConstraintRow& row = event.rows[r];
      real["mount.offset"].push_back(event.offset[static_cast<Eigen::Index>(r)]);
      real["mount.area"].push_back(row.area);
      whole["mount.node"].push_back(row.node.value);
      whole["mount.tangential"].push_back(row.tangential ? 1 : 0);
      whole["mount.entries"].push_back(static_cast<std::int64_t>(row.entries.size()));
      for (const contact::RowEntry& entry : row.entries) {
        whole["mount.entry_node"].push_back(entry.node.value);
        for (const double w : entry.weight) {
          real["mount.entry_weight"].push_back(w);
        }
      }
    }
  }
}

MountOffsetMemory MountOffsetMemory::restore_state(const results::NamedArrays& arrays) {
  MountOffsetMemory memory;
  Reading contact(arrays.integers, "mount.contact");
  Reading rows(arrays.integers, "mount.rows");
  Reading offset(arrays.reals, "mount.offset");
  Reading area(arrays.reals, "mount.area");
  Reading node(arrays.integers, "mount.node");
  Reading tangential(arrays.integers, "mount.tangential");
  Reading entries(arrays.integers, "mount.entries");
  Reading entry_node(arrays.integers, "mount.entry_node");
  Reading weight(arrays.reals, "mount.entry_weight");
  while (contact.more()) {
    MountEvent event{static_cast<std::size_t>(contact.next()), {}, {}};
    const std::int64_t count = rows.next();
    if (count < 0 || static_cast<std::size_t>(count) > offset.left()) {
      throw base::CorruptStoredField("mount.offset",
                                     "it is incomplete"); // before room is made for it
    }
    event.offset = base::Vector::Zero(count);
    for (std::int64_t r = 0; r < count; ++r) {
      event.offset[r] = offset.next();
      contact::ConstraintRow row;
      row.area = area.next();
      row.node.value = static_cast<std::int32_t>(node.next());
      row.tangential = tangential.next() != 0;
      for (std::int64_t e = entries.next(); e > 0; --e) {
        contact::RowEntry& entry = row.entries.emplace_back();
        entry.node.value = static_cast<std::int32_t>(entry_node.next());
        for (double& w : entry.weight) {
          w = weight.next();
        }
      }
      event.rows.push_back(std::move(row));
    }
    memory.events_.push_back(std::move(event));
  }
  return memory;
}

bool MountOffsetMemory::store_or_restore_offsets(const Discretisation& scene, std::size_t contact,
                                                 bool rubs, base::Vector& offset) {
  const std::size_t first = scene.table.first[contact];
  const std::size_t count = scene.table.first[contact + 1] - first;
  auto part = offset.segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(count));
  // Nothing is known of this mounting: it belongs to the first length.
  if (next_ == events_.size()) {
    MountEvent event{contact, {}, part};
    for (std::size_t r = 0; r < count; ++r) {
      event.rows.push_back(scene.contact_row(first + r));
    }
    events_.push_back(std::move(event));
    ++next_;
    return true;
  }
  const MountEvent& event = events_[next_++];
  bool same = event.contact == contact && event.rows.size() == count;
  for (std::size_t r = 0; same && r < count; ++r) {
    const contact::ConstraintRow& row = scene.contact_row(first + r);
    same = same_row(event.rows[r], row);
    // Slips of rows that rub count from this length's own state.
    if (same && !(rubs && row.tangential)) {
      part[static_cast<Eigen::Index>(r)] = event.offset[static_cast<Eigen::Index>(r)];
    }
  }
  return same;
}

} // namespace spricka::analysis
