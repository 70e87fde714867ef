// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace spricka::deck {

/// Deck numbers of one net to indices. Numbers without wide gaps, as nearly all decks have them,
/// live in a plain array.
class LabelMap {
public:
  /// False if the number is taken.
  bool insert(base::Label label, std::size_t index) {
    const auto l = static_cast<std::size_t>(label);
    if (l < 4 * count_ + k_small) {
      if (l >= near_.size()) {
        near_.resize(std::max(l + 1, 2 * near_.size()), -1);
      }
      if (near_[l] >= 0 || far_.contains(label)) {
        return false;
      }
      near_[l] = static_cast<std::int32_t>(index);
    } else if ((l < near_.size() && near_[l] >= 0) || !far_.emplace(label, index).second) {
      return false;
    }
    ++count_;
    highest_ = std::max(highest_, label);
    return true;
  }

  /// The index that was added under a label; empty if none was.
  [[nodiscard]] std::optional<std::size_t> find(base::Label label) const {
    const auto l = static_cast<std::size_t>(label); // wide of the array if negative
    if (l < near_.size() && near_[l] >= 0) {
      return static_cast<std::size_t>(near_[l]);
    }
    const auto it = far_.find(label);
    return it == far_.end() ? std::nullopt : std::optional(it->second);
  }

  [[nodiscard]] base::Label highest() const { return highest_; }
  bool complete = true; ///< false: a table has bad lines, so a missing number says nothing

private:
  static constexpr std::size_t k_small = 1024;
  std::size_t count_ = 0;
  base::Label highest_ = 0;
  std::vector<std::int32_t> near_;
  std::unordered_map<base::Label, std::size_t> far_;
};

} // namespace spricka::deck
