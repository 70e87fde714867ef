// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_label_list.hpp"

#include <algorithm>

namespace spricka::mesh {

void InpLabelList::append(base::Label label) {
  if (!ranges_.empty() && ranges_.back().step == 1 && ranges_.back().last + 1 == label) {
    ++ranges_.back().last;
  } else {
    ranges_.push_back({label, label, 1});
  }
}

void InpLabelList::append_range(base::Label first, base::Label last, base::Label step) {
  ranges_.push_back({first, first + (last - first) / step * step, step});
}

void InpLabelList::append(const InpLabelList& other) {
  const std::vector<InpLabelRange> added = other.ranges_; // the list may be appended to itself
  ranges_.insert(ranges_.end(), added.begin(), added.end());
}

InpLabelFinder::InpLabelFinder(const std::vector<base::Label>& labels)
    : labels_(labels), index_(labels), met_(labels.size(), 0) {}

InpLabelFinder::FoundLabels InpLabelFinder::find(const InpLabelList& list) {
  ++search_;
  FoundLabels found;
  for (const InpLabelList::InpLabelRange& range : list.ranges()) {
    if (range.count() > 2 * labels_.size() + 1024) {
      find_in_far_range(range, found);
      continue;
    }
    base::Label label = range.first;
    for (std::uint64_t i = range.count(); i > 0; --i, label += range.step) {
      if (const auto place = index_.find(label)) {
        meet(*place, found);
      } else {
        found.others.push_back(label);
      }
    }
  }
  return found;
}

// More numbers than there can be: look at those that there are.
void InpLabelFinder::find_in_far_range(const InpLabelList::InpLabelRange& range,
                                       FoundLabels& found) {
  if (ascending_.empty()) {
    ascending_ = labels_;
    std::sort(ascending_.begin(), ascending_.end());
  }
  const bool upwards = range.step > 0;
  const auto low =
      std::lower_bound(ascending_.begin(), ascending_.end(), std::min(range.first, range.last));
  const auto high = std::upper_bound(low, ascending_.end(), std::max(range.first, range.last));
  for (auto i = low; i != high; ++i) {
    const base::Label label = upwards ? *i : *(high - 1 - (i - low));
    if ((label - range.first) % range.step == 0) {
      meet(*index_.find(label), found);
    }
  }
  base::Label lacking = range.first;
  while (index_.find(lacking)) {
    lacking += range.step;
  }
  found.others.push_back(lacking);
}

void InpLabelFinder::meet(std::size_t place, FoundLabels& found) {
  if (met_[place] != search_) {
    met_[place] = search_;
    found.places.push_back(place);
  }
}

} // namespace spricka::mesh
