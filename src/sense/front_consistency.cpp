// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/front_consistency.hpp"

#include "sense/k_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

// As a part of the largest K of the front. Tubes that have error bars part by up to 0.4 % at the
// points of sound decks, and next to the surface by 1.5 % where the front leans; tetrahedra up to
// the front by 4 %.
constexpr double of_tubes = 0.02;
constexpr double of_others = 0.05;
// K below this part of the largest of the run is what round-off leaves of unloaded steps.
constexpr double no_front_K = 1e-6;

// Roots of energy release rates: K but for a factor of the material.
double root(double G) {
  return std::copysign(std::sqrt(std::abs(G)), G);
}

double largest_root(const results::FrontResult& front) {
  double most = 0.0;
  for (const results::FrontPointResult& place : front.points) {
    most = std::max(most, place.at_surface ? 0.0 : root(place.G_from_K));
  }
  return most;
}

// Of K, as a part of the largest of the front.
double bar_at(const results::FrontResult& front, const results::FrontPointResult& place,
              double largest) {
  const double K = std::hypot(place.K1, place.K2, place.K3);
  if (!results::has_error_bar(front) || !(K > 0.0)) {
    return 0.0;
  }
  const double bar = std::hypot(place.bar[0].size(), place.bar[1].size(), place.bar[2].size());
  return bar / K * root(place.G_from_K) / largest;
}

struct Parted {
  double apart = 0.0; ///< as a part of the largest K of the front
  double ratio = 0.0; ///< of what it may be
  const results::StepResult* step = nullptr;
  const results::FrontResult* front = nullptr;
  const results::FrontPointResult* place = nullptr;
  int others = 0; ///< other results of this front that part
};

// The worst place of one front at one step; none: ratio <= 1.
Parted worst_place(const results::StepResult& step, const results::FrontResult& front) {
  Parted worst{.step = &step, .front = &front};
  const double largest = largest_root(front);
  for (const results::FrontPointResult& place : front.points) {
    if (place.at_surface || place.closed || !(largest > 0.0)) {
      continue;
    }
    const double apart = std::abs(root(place.G) - root(place.G_from_K)) / largest;
    const double ratio = apart / std::max(results::has_error_bar(front) ? of_tubes : of_others,
                                          bar_at(front, place, largest));
    if (ratio > worst.ratio) {
      worst.apart = apart;
      worst.ratio = ratio;
      worst.place = &place;
    }
  }
  return worst;
}

// Whether K of the front is what round-off leaves of a step that does not load it.
bool is_round_off(const results::StepResult& step, const results::FrontResult& front) {
  const double largest = largest_root(front);
  const auto most = std::ranges::find_if(front.points, [&](const results::FrontPointResult& place) {
    return !place.at_surface && root(place.G_from_K) == largest;
  });
  if (!(largest > 0.0) || most == front.points.end() || !(front.a > 0.0)) {
    return !(largest > 0.0);
  }
  const double K = std::hypot(most->K1, most->K2, most->K3);
  return K <= k_round_off_level(step, K * K / most->G_from_K, front.a);
}

std::string parted_text(const Parted& one) {
  const results::FrontPointResult& at = *one.place;
  return fmt::format(
      "{}, step {}, a = {:.6g}, at ({:.6g}, {:.6g}, {:.6g}) of its front: two ways to compute K "
      "differ by more than {}: G = {:.5g} and G of K1, K2 and K3, {:.5g}, are {:.2g} % of K "
      "apart{}",
      one.front->name, one.step->step, one.front->a, at.x.x(), at.x.y(), at.x.z(),
      results::has_error_bar(*one.front) ? "its error bar" : "on a sound mesh", at.G, at.G_from_K,
      100.0 * one.apart,
      one.others > 0 ? fmt::format("; the same holds for {} other result{} of this front",
                                   one.others, one.others > 1 ? "s" : "")
                     : "");
}

} // namespace

std::vector<std::string> front_consistency_warnings(const results::RunResult& run) {
  double largest = 0.0;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        largest = std::max(largest, largest_root(front));
      }
    }
  }
  std::map<std::string, Parted> worst;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        Parted one = worst_place(step, front);
        if (!front.invalid_reason.empty() || !(one.ratio > 1.0) ||
            largest_root(front) <= no_front_K * largest || is_round_off(step, front)) {
          continue;
        }
        const auto [at, fresh] = worst.try_emplace(front.name, one);
        if (!fresh) {
          one.others = at->second.others + 1;
          at->second.others = one.others;
          at->second = one.ratio > at->second.ratio ? one : at->second;
        }
      }
    }
  }
  std::vector<std::string> texts;
  texts.reserve(worst.size());
  for (const auto& [name, one] : worst) {
    texts.push_back(parted_text(one));
  }
  return texts;
}

} // namespace spricka::sense
