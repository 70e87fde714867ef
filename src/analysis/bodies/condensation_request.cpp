// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/condensation_request.hpp"

#include "model/model.hpp"

#include <algorithm>

namespace spricka::analysis {

solve::CondensationSettings condensation_settings(const CondensationRequest& request) {
  // Stress intensity factors need a solution for each place of a front, contact one for each row.
  constexpr int modes_in_space = 6;
  const bool few_solutions = fe::rigid_mode_count(request.model) == modes_in_space &&
                             request.rows.empty() && request.model.contacts.empty() &&
                             request.model.cracks.empty();
  return {.engine = request.engine,
          .besides = contact_solution_memory(request.rows),
          .solutions = few_solutions ? static_cast<double>(request.model.cases.size()) : 0.0};
}

double contact_solution_memory(const std::vector<const contact::ConstraintRow*>& rows) {
  const bool rubs =
      std::ranges::any_of(rows, [](const contact::ConstraintRow* row) { return row->tangential; });
  const auto n = static_cast<double>(rows.size());
  return (rubs ? 4.0 : 3.0) * 8.0 * n * n;
}

std::vector<std::int64_t> equation_numbers(const fe::DofMap& map,
                                           std::span<const std::int32_t> freedom) {
  std::vector<std::int64_t> rows;
  rows.reserve(freedom.size());
  for (const std::int32_t f : freedom) {
    rows.push_back(map.row[static_cast<std::size_t>(f)]);
  }
  return rows;
}

bool keeps_parts_as_dense_blocks(const fe::DofMap& map,
                                 std::span<const solve::CondensedNetBlock> blocks) {
  return !map.ties && solve::is_two_level_cheaper(blocks, map.size(), map.external_count());
}

base::Matrix rows_of_freedoms(const base::Matrix& nodal, const std::vector<std::int32_t>& freedom,
                              std::size_t from) {
  base::Matrix out(static_cast<Eigen::Index>(freedom.size() - from), nodal.cols());
  for (std::size_t i = from; i < freedom.size(); ++i) {
    out.row(static_cast<Eigen::Index>(i - from)) = nodal.row(freedom[i]);
  }
  return out;
}

} // namespace spricka::analysis
