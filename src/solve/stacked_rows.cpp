// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/stacked_rows.hpp"
#include "base/index.hpp"

#include <algorithm>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

// Externals that only the block has must be this part of the top to be worth a floor of their own.
constexpr double least_early = 0.25;

} // namespace

TwoLevelRows divide_rows_by_level(const base::SymmetricCsc& K, std::int64_t externals,
                                  std::span<const CondensedNetBlock> blocks) {
  std::vector<bool> in_block(at(K.n), false);
  std::vector<bool> coupled(at(K.n), false);
  for (const CondensedNetBlock& b : blocks) {
    for (const std::int64_t row : b.rows) {
      if (row >= 0) {
        in_block[at(row)] = true;
      }
    }
  }
  for (std::int64_t j = 0; j < K.n; ++j) {
    // The diagonal comes first in a column and couples nothing.
    for (std::int64_t p = K.start[at(j)] + 1; p < K.start[at(j) + 1]; ++p) {
      coupled[at(j)] = true;
      coupled[at(K.row[at(p)])] = true;
    }
  }
  TwoLevelRows rows;
  rows.external = externals;
  for (std::int64_t i = 0; i < K.n; ++i) {
    if (i < K.n - externals && !in_block[at(i)]) {
      rows.below.push_back(i);
      continue;
    }
    if (coupled[at(i)]) {
      rows.touched.push_back(index(rows.top.size()));
    }
    rows.top.push_back(i);
  }
  return rows;
}

std::vector<Eigen::Index> upper_level_positions(const CondensedNetBlock& b,
                                                const std::vector<std::int64_t>& top) {
  std::vector<Eigen::Index> place;
  place.reserve(b.rows.size());
  for (const std::int64_t row : b.rows) {
    // `top` ascends, as its rows were taken in the order of K.
    place.push_back(row < 0 ? -1 : std::ranges::lower_bound(top, row) - top.begin());
  }
  return place;
}

UnknownPlaces lower_level_places(const UnknownPlaces& places, const TwoLevelRows& rows) {
  UnknownPlaces below;
  below.position = places.position;
  const auto add = [&](std::int64_t row) {
    below.node.push_back(places.node[at(row)]);
    below.axis.push_back(places.axis[at(row)]);
  };
  std::ranges::for_each(rows.below, add);
  for (const Eigen::Index t : rows.touched) {
    add(rows.top[at(t)]);
  }
  return below;
}

base::SymmetricCsc lower_level_matrix(const base::SymmetricCsc& K, const TwoLevelRows& rows) {
  std::vector<std::int64_t> place(at(K.n), -1);
  std::int64_t next = 0;
  for (const std::int64_t row : rows.below) {
    place[at(row)] = next++;
  }
  for (const Eigen::Index t : rows.touched) {
    place[at(rows.top[at(t)])] = next++;
  }
  struct Entry {
    std::int64_t row;
    double value;
  };
  std::vector<std::vector<Entry>> column(at(next));
  for (std::int64_t j = 0; j < K.n; ++j) {
    for (std::int64_t p = K.start[at(j)]; p < K.start[at(j) + 1]; ++p) {
      // Rows change their order: an entry of the lower triangle may lie above it in the new one.
      const auto [c, r] = std::minmax(place[at(j)], place[at(K.row[at(p)])]);
      if (c >= 0) {
        column[at(c)].push_back({r, K.value[at(p)]});
      }
    }
  }
  base::SymmetricCsc A{next, {0}, {}, {}};
  for (std::vector<Entry>& entries : column) {
    std::ranges::sort(entries, {}, &Entry::row);
    for (const Entry& e : entries) {
      A.row.push_back(e.row);
      A.value.push_back(e.value);
    }
    A.start.push_back(static_cast<std::int64_t>(A.row.size()));
  }
  return A;
}

void find_externals_of_block_alone(const base::SymmetricCsc& K,
                                   std::span<const CondensedNetBlock> blocks, TwoLevelRows& rows) {
  // What is kept of early rows is one block's.
  if (blocks.size() != 1) {
    return;
  }
  std::vector<bool> only(rows.top.size(), false);
  for (const Eigen::Index t : upper_level_positions(blocks.front(), rows.top)) {
    if (t >= rows.inner_count()) {
      only[at(t)] = true;
    }
  }
  for (const Eigen::Index t : rows.touched) {
    only[at(t)] = false;
  }
  for (std::size_t t = 0; t < only.size(); ++t) { // a spring of its own would be lost
    only[t] = only[t] && K.value[at(K.start[at(rows.top[t])])] == 0.0;
  }
  for (std::size_t t = 0; t < only.size(); ++t) {
    if (only[t]) {
      rows.early.push_back(index(t));
    }
  }
  if (static_cast<double>(rows.early.size()) < least_early * static_cast<double>(only.size())) {
    rows.early.clear();
  }
}

EarlyLateRowPartition partition_block(const TwoLevelRows& rows, const CondensedNetBlock& block) {
  EarlyLateRowPartition lists;
  const std::vector<Eigen::Index> top = upper_level_positions(block, rows.top);
  for (std::size_t r = 0; r < top.size(); ++r) {
    if (top[r] >= 0) {
      const bool early = std::ranges::binary_search(rows.early, top[r]);
      (early ? lists.early : lists.late).push_back(index(r));
    }
  }
  return lists;
}

void add_upper_level_cost(const TwoLevelRows& rows, bool kept, FactorReport& report) {
  const auto i = static_cast<double>(rows.inner_count());
  const auto e = static_cast<double>(rows.external);
  const auto b = static_cast<double>(rows.early.size());
  const double l = i + e - b;
  // Flops and bytes (8 a number) of full matrices: i inner rows, e externals, b early ones of
  // these, l all that are not early. `memory` is the peak while they are made, `kept_memory` what
  // stays.
  report.flops += i * i * i / 3.0;
  report.factor_entries += 0.5 * i * i + i * e;
  report.kept_memory += 8.0 * (i * i + i * e);
  report.memory += 8.0 * (2.0 * i * i + i * e);
  if (rows.early.empty()) {
    report.flops += i * i * e + i * e * e;
    report.memory += 8.0 * (i * e + 2.0 * e * e);
  } else {
    report.flops += l * l * l / 3.0 + (kept ? 0.0 : b * b * b / 3.0 + b * b * l + b * l * l);
    report.factor_entries += 0.5 * b * b + b * l + 0.5 * l * l;
    report.kept_memory += 8.0 * (b * b + b * l + l * l);
    report.memory += 8.0 * (b * b + b * l + 2.0 * l * l);
  }
}

} // namespace spricka::solve
