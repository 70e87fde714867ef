// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/bar_along_front.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::analysis {

namespace {

// Found by comparison with known values (manual, error_bar.md).
struct FrontBarShares {
  double own = 1.4;     ///< of the error estimated at the point
  double others = 0.25; ///< of the rms of those along the front
  double floor = 3e-4;  ///< of the largest K along it
};
constexpr FrontBarShares of_raw_K{};
constexpr FrontBarShares of_best_K{.own = 0.5, .others = 0.2, .floor = 1.5e-4};
// Of what a row of nodes more or less at an edge of a contact does: where contact ends on both
// surfaces, and where on one.
constexpr double share_of_ends = estimate::share_of_set_change;
constexpr double share_of_sharp = 0.3;

// Points with an estimate: within the body, with a domain.
bool has_estimate(const results::FrontPointResult& place) {
  return !place.at_surface && (place.G != 0.0 || place.K1 != 0.0 || place.K2 != 0.0);
}

// Faces that touch hold K1 at 0 whatever the mesh finds for it: there is nothing to estimate.
bool held_at_zero(const results::FrontPointResult& place, std::size_t mode) {
  return place.closed && mode == 0;
}

// The nearest point with an estimate stands for one at the surface, between points.
void fill_surface(results::FrontResult& front) {
  const std::size_t n = front.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t away = 1; !has_estimate(front.points[i]) && away < n; ++away) {
      if (i >= away && has_estimate(front.points[i - away])) {
        front.points[i].bar = front.points[i - away].bar;
        break;
      }
      if (i + away < n && has_estimate(front.points[i + away])) {
        front.points[i].bar = front.points[i + away].bar;
        break;
      }
    }
  }
}

} // namespace

void add_front_error_bars(const base::Vector& eta, const std::vector<std::array<double, 3>>& best,
                          const ContactEdgeKChange& edges, Eigen::Index first,
                          double coarse_contact, const estimate::ErrorBarUse& use,
                          results::FrontResult& front) {
  double size = 0.0;
  double most = 0.0;       // that would be taken out
  bool bears = use.closes; // or a body on the faces does
  std::array<double, 3> squares{};
  std::array<double, 3> counts{};
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    results::FrontPointResult& place = front.points[i];
    if (!has_estimate(place)) {
      continue;
    }
    const std::array<double, 3> K{place.K1, place.K2, place.K3};
    size = std::max(size, std::hypot(K[0], K[1], K[2]));
    bears =
        bears || edges.sharp.segment<3>(first + static_cast<Eigen::Index>(3 * i)).maxCoeff() > 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (held_at_zero(place, k)) {
        continue;
      }
      counts[k] += 1.0;
      const Eigen::Index at = first + static_cast<Eigen::Index>(3 * i + k);
      place.bar[k].eta = eta[at];
      place.bar[k].set_change = edges.ends[at];
      place.bar[k].edge = share_of_ends * edges.ends[at] + share_of_sharp * edges.sharp[at];
      place.bar[k].best = best[i][k];
      squares[k] += std::pow(best[i][k] - K[k], 2);
      most = std::max(most, std::abs(best[i][k] - K[k]));
    }
  }
  const bool of_best = use.corrected && most <= estimate::largest_correction * size;
  // How far faces are closed, which K of such a front hangs on, is what no estimate sees.
  const FrontBarShares& shares = of_best && !bears ? of_best_K : of_raw_K;
  for (results::FrontPointResult& place : front.points) {
    const std::array<double, 3> K{place.K1, place.K2, place.K3};
    for (std::size_t k = 0; k < 3 && has_estimate(place); ++k) {
      if (held_at_zero(place, k)) {
        continue;
      }
      results::KErrorBar& bar = place.bar[k];
      bar.of_best = of_best;
      bar.mesh = shares.own * std::abs(bar.best - K[k]) +
                 shares.others * std::sqrt(squares[k] / counts[k]);
      bar.edge += coarse_contact * size;
      bar.floor = shares.floor * size;
    }
  }
  fill_surface(front);
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    results::FrontPointResult& place = front.points[i];
    for (std::size_t k = 0; k < 3; ++k) {
      place.bar[k].best = best[i][k]; // what a bar from the next point must not bring along
    }
    place.bar[0] = held_at_zero(place, 0) ? results::KErrorBar{} : place.bar[0];
  }
}

} // namespace spricka::analysis
