// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/resting_forces.hpp"

#include <fmt/format.h>

namespace spricka::analysis {

base::Vector sliding_mode_residual_force(const std::vector<SubstructuredBody>& bodies,
                                         const std::vector<std::size_t>& condensed,
                                         const contact::ContactSystem::IncrementSolution& solution,
                                         Eigen::Index size) {
  if (solution.resting_force.empty()) {
    return {};
  }
  base::Vector resting = base::Vector::Zero(size);
  for (std::size_t i = 0; i < solution.resting_force.size(); ++i) {
    const std::vector<std::int32_t>& freedom = bodies[condensed[i]].condensed->external_freedoms();
    for (std::size_t k = 0; k < freedom.size(); ++k) {
      resting[freedom[k]] = solution.resting_force[i][static_cast<Eigen::Index>(k)];
    }
  }
  return resting;
}

std::optional<results::Note> residual_force_note(const base::Vector& resting,
                                                 const base::Vector& contact) {
  constexpr double worth_a_note = 1e-6;
  constexpr double too_much = 1e-3;
  const double share =
      resting.size() > 0 && !contact.isZero(0.0) ? resting.lpNorm<1>() / contact.lpNorm<1>() : 0.0;
  if (!(share > worth_a_note)) {
    return std::nullopt;
  }
  const std::string text = fmt::format(
      "{:.1e} of the contact forces act on motions by which round or plane surfaces slide on "
      "themselves (such as their moment about the axis of a bush) and are left over",
      share);
  return share > too_much ? results::less_exact_note(text) : results::make_note(text);
}

} // namespace spricka::analysis
