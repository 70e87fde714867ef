// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/finite_results.hpp"

#include "results/k_quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double largest = 1e150; // squares and their sums are numbers

bool good(double v) {
  return std::abs(v) < largest; // false for what is no number
}

template <class Values> bool all_good(const Values& values) {
  return std::all_of(values.begin(), values.end(), good);
}

bool all_good(const std::vector<results::Stress>& stresses) {
  return std::ranges::all_of(stresses,
                             [](const results::Stress& s) { return all_good<results::Stress>(s); });
}

// All numbers that a record of points keeps, by the table of its quantities.
template <class Record, class Quantities>
bool members_good(const Record& record, const Quantities& quantities) {
  return std::ranges::all_of(
      quantities, [&](const auto& q) { return q.member == nullptr || good(record.*q.member); });
}

bool fronts_good(const results::FrontResult& front) {
  return std::ranges::all_of(front.points, [](const results::FrontPointResult& point) {
    return members_good(point, results::k_quantities) && all_good(point.K1_domain);
  });
}

bool path_good(const base::PiecewiseLinear& K) {
  return K.empty() || (good(K.smallest_value()) && good(K.largest_value()));
}

bool contacts_good(const results::ContactResult& c) {
  const auto point_good = [](const results::ContactPoint& p) {
    return members_good(p, results::point_quantities);
  };
  return all_good(std::array{c.min_pressure, c.max_pressure, c.mean_pressure, c.max_penetration,
                             c.friction_work}) &&
         all_good(c.force_on_slave) && all_good(c.moment_on_slave) &&
         std::ranges::all_of(c.points, point_good);
}

std::string words(std::string_view what) {
  return fmt::format("{} beyond the range of numbers (1e150): loads, factors, moduli or lengths "
                     "are",
                     what);
}

} // namespace

std::string find_nonfinite_result(const results::LoadStepResult& step) {
  if (!all_good(step.u)) {
    return words("displacements are");
  }
  if (!all_good(step.reaction) || !good(step.energy)) {
    return words("forces or energies are");
  }
  if (!std::ranges::all_of(step.fronts, fronts_good)) {
    return words("K or G is");
  }
  if (!std::ranges::all_of(step.contacts, contacts_good)) {
    return words("contact pressures or gaps are");
  }
  if (!all_good(step.stress) || !all_good(step.element_stress)) {
    return words("stresses are");
  }
  return {};
}

std::string find_nonfinite_result(const results::LoadPathResult& path) {
  for (const results::LoadPathFront& front : path.fronts) {
    for (const results::LoadPathFrontPoint& point : front.points) {
      if (!std::ranges::all_of(point.K, path_good)) {
        return words("K along the load path is");
      }
    }
  }
  return {};
}

} // namespace spricka::analysis
