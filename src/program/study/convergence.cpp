// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace spricka::program {

namespace {

/// Mean and scatter of log(error / law(size)) for one power.
struct ConvergenceFit {
  double mean = 0.0;
  double scatter = std::numeric_limits<double>::infinity();
};

double law(double size, double reference, double power) {
  const double beyond = reference > 0.0 ? std::pow(reference, power) : 0.0;
  return std::abs(std::pow(size, power) - beyond);
}

ConvergenceFit fit_of(const std::vector<MeshSizeAndError>& points, double reference, double power) {
  ConvergenceFit fit;
  std::vector<double> logs;
  for (const MeshSizeAndError& point : points) {
    logs.push_back(std::log(point.error / law(point.size, reference, power)));
    fit.mean += logs.back() / static_cast<double>(points.size());
  }
  fit.scatter = 0.0;
  for (const double value : logs) {
    fit.scatter += (value - fit.mean) * (value - fit.mean);
  }
  return fit;
}

// The scatter has one minimum, which sections find.
double best_power(const std::vector<MeshSizeAndError>& points, double reference) {
  double low = 0.05;
  double high = 16.0;
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    const bool lower =
        fit_of(points, reference, left).scatter < fit_of(points, reference, right).scatter;
    (lower ? high : low) = lower ? right : left;
  }
  return 0.5 * (low + high);
}

} // namespace

std::optional<ConvergenceRate> fit_convergence_rate(std::span<const MeshSizeAndError> points,
                                                    double floor, double reference) {
  std::vector<MeshSizeAndError> used;
  std::ranges::copy_if(points, std::back_inserter(used), [&](const MeshSizeAndError& point) {
    return std::isfinite(point.error) && point.error > floor && point.size > 1.01 * reference;
  });
  if (used.size() < 3) {
    return std::nullopt;
  }
  const double power = best_power(used, reference);
  return ConvergenceRate{power, std::exp(fit_of(used, reference, power).mean), used.size()};
}

std::vector<double> error_envelope(std::span<const MeshSizeAndError> points) {
  std::vector<double> lasting;
  for (const MeshSizeAndError& point : points) {
    double largest = 0.0;
    for (const MeshSizeAndError& other : points) {
      largest = other.size <= point.size ? std::max(largest, other.error) : largest;
    }
    lasting.push_back(largest);
  }
  return lasting;
}

std::optional<ErrorPlateau> find_error_plateau(std::span<const MeshSizeAndError> points,
                                               double nothing) {
  constexpr double falling = 0.5; // the least power of an error that goes on
  const std::vector<double> lasting = error_envelope(points);
  std::size_t first = points.size();
  for (std::size_t i = points.size(); i-- > 1;) {
    const double finer = std::log(points[i - 1].size / points[i].size);
    const double fallen = std::log(lasting[i - 1] / lasting[i]);
    if (!(lasting[i] > nothing) || !(finer > 0.0) || !(fallen < falling * finer)) {
      break;
    }
    first = i - 1;
  }
  if (first + 1 >= points.size()) {
    return std::nullopt;
  }
  return ErrorPlateau{first, lasting[first]};
}

std::optional<std::size_t> cheapest_run(std::span<const RankedRunCost> runs) {
  constexpr double alike = 1.15;
  double least = std::numeric_limits<double>::infinity();
  for (const RankedRunCost& run : runs) {
    least = std::min(least, run.cpu);
  }
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < runs.size() && std::isfinite(least); ++i) {
    if (runs[i].cpu <= alike * least &&
        (!best ||
         std::pair(runs[i].rank, runs[i].cpu) < std::pair(runs[*best].rank, runs[*best].cpu))) {
      best = i;
    }
  }
  return best;
}

} // namespace spricka::program
