// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace spricka::mesh {

/// Positions of the numbers in a list, as files give them to nodes and elements: an array where
/// they lie close together, else a hash table. The first of equal numbers counts.
class LabelIndex {
public:
  template <class Label> explicit LabelIndex(const std::vector<Label>& labels) {
    std::uint64_t highest = 0;
    for (const Label label : labels) {
      highest = std::max(highest, static_cast<std::uint64_t>(label));
    }
    if (highest < 4 * labels.size() + 1024) {
      near_.assign(static_cast<std::size_t>(highest) + 1, -1);
    } else {
      far_.reserve(labels.size());
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto label = static_cast<std::uint64_t>(labels[i]);
      if (near_.empty()) {
        doubled_ = !far_.emplace(label, i).second || doubled_;
      } else if (auto& at = near_[label]; at < 0) {
        at = static_cast<std::int32_t>(i);
      } else {
        doubled_ = true;
      }
    }
  }

  /// The index of a label; empty where the list does not hold it.
  template <class Label> [[nodiscard]] std::optional<std::size_t> find(Label number) const {
    const auto label = static_cast<std::uint64_t>(number); // negative ones are far away
    if (!near_.empty()) {
      return label < near_.size() && near_[label] >= 0
                 ? std::optional(static_cast<std::size_t>(near_[label]))
                 : std::nullopt;
    }
    const auto it = far_.find(label);
    return it == far_.end() ? std::nullopt : std::optional(it->second);
  }

  /// A number stands twice in the list.
  [[nodiscard]] bool has_duplicates() const { return doubled_; }

private:
  std::vector<std::int32_t> near_;
  std::unordered_map<std::uint64_t, std::size_t> far_;
  bool doubled_ = false;
};

} // namespace spricka::mesh
