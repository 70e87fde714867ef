// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/k_consistency.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

// What two ways may differ by, as a part of K, on meshes whose K is right: G is of second order in
// the error of the displacements round the tip, which K as an integral with smooth fields is not,
// and domains of few elements differ more than their mean is off. Both by comparison with known
// values (manual, error_bar.md).
constexpr double of_energy = 1e-3;
constexpr double of_domains = 1e-3;
constexpr double of_opening = 0.15;
// The same in bars.
constexpr double in_bars = 1.0;
// K below this part of the largest of the run is what round-off leaves of unloaded steps.
constexpr double no_K = 1e-6;
constexpr double k_round_off = 1e-8;

/// One pair of ways.
struct KComparison {
  double apart = 0.0;   ///< as a part of K
  double allowed = 0.0; ///< of the same
  std::string what;

  [[nodiscard]] double ratio() const { return apart / allowed; }
};

// Of hypot(K1, K2), as a part of it; 0 without a bar.
double bar_of(const results::TipResult& tip, double K) {
  return tip.no_bar.empty()
             ? (std::abs(tip.K1) * tip.bar[0].size() + std::abs(tip.K2) * tip.bar[1].size()) /
                   (K * K)
             : 0.0;
}

std::string apart_text(double apart, double bar) {
  return fmt::format("{:.2g} % of K apart{}", 100.0 * apart,
                     bar > 0.0 ? fmt::format(", the error bar is {:.2g} %", 100.0 * bar) : "");
}

// Faces that touch at the tip leave G what the mesh makes of the K1 that they have not, which the
// bar of K2 knows nothing of: as much as judge_faces.cpp lets pass without a warning.
constexpr double of_closed = 0.05;
double left_of_K1(const results::StepResult& step, const results::TipResult& tip) {
  double most = 0.0;
  for (const double K1 : tip.K1_domain) {
    most = std::max(most, std::abs(K1));
  }
  double pressure = 0.0;
  for (const results::ContactResult& contact : step.contacts) {
    pressure = std::max(pressure, contact.name.ends_with(".FACES") ? contact.max_pressure : 0.0);
  }
  most = std::max(most, of_closed * pressure * std::sqrt(std::numbers::pi * tip.a));
  return tip.closed ? most : 0.0;
}

// G counts as the K that it would have, which does not grow without bound where K is next to
// nothing.
KComparison energy(const results::StepResult& step, const results::TipResult& tip, double K) {
  if (!(tip.G_from_K > 0.0)) {
    return {};
  }
  const double bar = bar_of(tip, K);
  // G of the wrong sign is a K of the wrong sign, and as far off.
  const double other = std::copysign(std::sqrt(std::abs(tip.G) / tip.G_from_K), tip.G);
  const double apart = std::abs(other - 1.0);
  return {.apart = apart,
          .allowed = std::max(of_energy, in_bars * bar) + left_of_K1(step, tip) / K,
          .what = fmt::format("G = {:.5g} and (K1^2 + K2^2)/E' = {:.5g} are {}", tip.G,
                              tip.G_from_K, apart_text(apart, bar))};
}

KComparison domains(const results::TipResult& tip, double K) {
  if (tip.closed || tip.K1_domain.size() < 2) {
    return {}; // K1 is 0, what the domains find is not used
  }
  const auto [low, high] = std::ranges::minmax(tip.K1_domain);
  const double bar = tip.no_bar.empty() ? tip.bar[0].size() / K : 0.0;
  const double apart = (high - low) / K;
  return {.apart = apart,
          .allowed = std::max(of_domains, in_bars * bar),
          .what = fmt::format("K1 of the domains goes from {:.5g} to {:.5g}, {}", low, high,
                              apart_text(apart, bar))};
}

KComparison opening(const results::TipResult& tip, double K) {
  if (!tip.K_opening || tip.closed) {
    return {};
  }
  const std::array<double, 2>& other = *tip.K_opening;
  const double bar = bar_of(tip, K);
  const double apart = std::hypot(other[0] - tip.K1, other[1] - tip.K2) / K;
  return {.apart = apart,
          .allowed = std::max(of_opening, in_bars * bar),
          .what = fmt::format(
              "K1 = {:.5g}, K2 = {:.5g}, by the opening of the faces {:.5g}, {:.5g}: {}", tip.K1,
              tip.K2, other[0], other[1], apart_text(apart, bar))};
}

// E' is in G.
bool is_round_off(const results::StepResult& step, const results::TipResult& tip, double K) {
  return !(tip.G_from_K > 0.0) || !(tip.a > 0.0) || step.u.size() == 0 ||
         K <= k_round_off_level(step, K * K / tip.G_from_K, tip.a);
}

KComparison worst_routes(const results::StepResult& step, const results::TipResult& tip) {
  const double K = std::hypot(tip.K1, tip.K2);
  if (tip.two_materials || !tip.invalid_reason.empty() || !(K > 0.0) ||
      is_round_off(step, tip, K)) {
    return {};
  }
  KComparison worst;
  for (KComparison& one : std::array{energy(step, tip, K), domains(tip, K), opening(tip, K)}) {
    // Of several the one that is furthest beyond what it may be.
    if (one.apart > one.allowed && (worst.what.empty() || one.ratio() > worst.ratio())) {
      worst = std::move(one);
    }
  }
  return worst;
}

} // namespace

double k_round_off_level(const results::StepResult& step, double E, double a) {
  double pressure = 0.0;
  for (const results::ContactResult& contact : step.contacts) {
    pressure = std::max(pressure, std::abs(contact.max_pressure));
  }
  const double moved = step.u.size() > 0 ? step.u.lpNorm<Eigen::Infinity>() : 0.0;
  return k_round_off * std::max(E * moved / std::sqrt(a), pressure * std::sqrt(a));
}

std::string describe_tip_mismatch(const results::StepResult& step, const results::TipResult& tip) {
  return worst_routes(step, tip).what;
}

std::vector<KMismatch> find_k_mismatches(const results::RunResult& run) {
  double largest = 0.0;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        largest = std::max(largest, std::hypot(tip.K1, tip.K2));
      }
    }
  }
  std::vector<KMismatch> list;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        std::string what = describe_tip_mismatch(step, tip);
        if (!what.empty() && std::hypot(tip.K1, tip.K2) > no_K * largest) {
          list.push_back({&increment, &step, &tip, std::move(what)});
        }
      }
    }
  }
  return list;
}

std::vector<std::string> k_consistency_warnings(const results::RunResult& run) {
  std::map<std::string, std::pair<KMismatch, double>> worst;
  std::map<std::string, int> count;
  for (KMismatch& one : find_k_mismatches(run)) {
    const std::string name = one.tip->name;
    const double ratio = worst_routes(*one.step, *one.tip).ratio();
    ++count[name];
    const auto [at, fresh] = worst.try_emplace(name, one, ratio);
    if (!fresh && ratio > at->second.second) {
      at->second = {std::move(one), ratio};
    }
  }
  std::vector<std::string> texts;
  for (const auto& [name, entry] : worst) {
    const KMismatch& one = entry.first;
    const int others = count[name] - 1;
    texts.push_back(fmt::format(
        "{}, step {}, a = {:.6g}: two ways to compute K differ by more than {}: {}{}", name,
        one.step->step, one.tip->a,
        one.tip->no_bar.empty() ? "its error bar" : "on a sound mesh, and there is no error bar",
        one.what,
        others > 0 ? fmt::format("; the same holds for {} other result{} of this tip", others,
                                 others > 1 ? "s" : "")
                   : ""));
  }
  return texts;
}

} // namespace spricka::sense
