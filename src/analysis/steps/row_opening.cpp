// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/row_opening.hpp"

namespace spricka::analysis {

double row_opening(const contact::ConstraintRow& row, int dim, const base::Vector& u) {
  double sum = 0.0;
  for (const contact::RowEntry& entry : row.entries) {
    const auto at = static_cast<Eigen::Index>(entry.node.index()) * dim;
    for (int c = 0; c < dim; ++c) {
      sum += entry.weight[c] * u[at + c];
    }
  }
  return sum;
}

} // namespace spricka::analysis
