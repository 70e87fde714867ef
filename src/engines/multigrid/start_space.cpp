// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/multigrid/start_space.hpp"

#include <cmath>

namespace spricka::engines {

namespace {

// Of the strain energy of a solution: what is left of it beside the others, if less, is round-off.
constexpr double least_new_part = 1e-10;

} // namespace

void StartSpace::add(const base::Vector& u, const base::Vector& Au) {
  base::Vector left = u;
  const double whole = u.dot(Au);
  double energy = whole;
  for (const base::Vector& known : solutions_) {
    const double part = known.dot(Au);
    left -= part * known;
    energy -= part * part;
  }
  if (whole > 0.0 && energy > least_new_part * whole) {
    solutions_.push_back(left / std::sqrt(energy));
  }
}

base::Vector StartSpace::nearest(const base::Vector& b) const {
  base::Vector u = base::Vector::Zero(b.size());
  for (const base::Vector& known : solutions_) {
    u += known.dot(b) * known;
  }
  return u;
}

} // namespace spricka::engines
