// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/label.hpp"
#include "mesh/label_index.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace spricka::mesh {

/// Numbers of nodes or elements as a set of a file lists them, in their order: single ones and
/// ranges, which may reach far beyond what there is and are never written out.
class InpLabelList {
public:
  struct InpLabelRange {
    base::Label first = 0;
    base::Label last = 0; ///< met exactly, counting from the first in steps
    base::Label step = 1; ///< negative: downwards

    [[nodiscard]] std::uint64_t count() const {
      return static_cast<std::uint64_t>((last - first) / step) + 1;
    }
    [[nodiscard]] bool holds(base::Label label) const {
      return std::min(first, last) <= label && label <= std::max(first, last) &&
             (label - first) % step == 0;
    }
  };

  void append(base::Label label);
  /// From first to at most last.
  void append_range(base::Label first, base::Label last, base::Label step);
  void append(const InpLabelList& other);

  [[nodiscard]] const std::vector<InpLabelRange>& ranges() const { return ranges_; }
  [[nodiscard]] bool empty() const { return ranges_.empty(); }

private:
  std::vector<InpLabelRange> ranges_;
};

/// Finds what lists name among the numbers of a file's nodes or elements.
class InpLabelFinder {
public:
  explicit InpLabelFinder(const std::vector<base::Label>& labels);

  [[nodiscard]] const LabelIndex& index() const { return index_; }

  struct FoundLabels {
    std::vector<std::size_t> places; ///< each once, in the order of the list
    std::vector<base::Label> others; ///< numbers that are not there, a few of each range
    [[nodiscard]] bool complete() const { return others.empty(); }
  };
  /// Takes time as the numbers there are, however far the ranges reach.
  FoundLabels find(const InpLabelList& list);

private:
  void find_in_far_range(const InpLabelList::InpLabelRange& range, FoundLabels& found);
  void meet(std::size_t place, FoundLabels& found);

  const std::vector<base::Label>& labels_;
  LabelIndex index_;
  std::vector<std::uint32_t> met_; ///< [place] the search that it was met in last
  std::uint32_t search_ = 0;
  std::vector<base::Label> ascending_; ///< made when a far range comes
};

} // namespace spricka::mesh
