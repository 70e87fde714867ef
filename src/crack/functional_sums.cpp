// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/functional_sums.hpp"

#include <algorithm>

namespace spricka::crack {

double* IntensityFunctionalSums::of_point(std::size_t function, std::size_t point) {
  std::int32_t block = newest_[function];
  while (block != none && blocks_[static_cast<std::size_t>(block)].point != point) {
    block = blocks_[static_cast<std::size_t>(block)].before;
  }
  if (block == none) {
    block = static_cast<std::int32_t>(blocks_.size());
    blocks_.push_back({point, newest_[function]});
    newest_[function] = block;
    values_.resize(values_.size() + block_size(), 0.0);
  }
  return values_.data() + static_cast<std::size_t>(block) * block_size();
}

SparseLinearFunctionals IntensityFunctionalSums::assemble() const {
  // [point] its functions, ascending, and where their coefficients are.
  std::vector<std::vector<std::pair<Eigen::Index, const double*>>> of_points(layout_.points());
  for (std::size_t f = 0; f < newest_.size(); ++f) {
    for (std::int32_t b = newest_[f]; b != none; b = blocks_[static_cast<std::size_t>(b)].before) {
      const auto block = static_cast<std::size_t>(b);
      of_points[blocks_[block].point].emplace_back(static_cast<Eigen::Index>(f),
                                                   values_.data() + block * block_size());
    }
  }
  SparseLinearFunctionals rows(dim_ * static_cast<Eigen::Index>(newest_.size()), layout_.count());
  rows.reserve(std::ranges::count_if(values_, [](double value) { return value != 0.0; }));
  for (Eigen::Index column = 0; column < layout_.count(); ++column) {
    rows.startVec(column);
    const auto point = static_cast<std::size_t>(column / layout_.mode_count());
    const Eigen::Index first = dim_ * (column % layout_.mode_count());
    for (const auto& [function, values] : of_points[point]) {
      for (Eigen::Index c = 0; c < dim_; ++c) {
        if (values[first + c] != 0.0) {
          rows.insertBack(dim_ * function + c, column) = values[first + c];
        }
      }
    }
  }
  rows.finalize();
  return rows;
}

} // namespace spricka::crack
