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
// The same along fronts in space, as a part of the largest K of the front. Tubes that have error
// bars part by up to 0.4 % at the points of sound decks, and next to the surface by 1.5 % where the
// front leans; tetrahedra up to the front by 4 %.
constexpr double of_tubes = 0.02;
constexpr double of_others = 0.05;
// The same in bars.
constexpr double in_bars = 1.0;
// K below this part of the largest of the run is what round-off leaves of unloaded steps.
constexpr double no_K = 1e-6;
constexpr double k_round_off = 1e-8;

/// One pair of ways.
struct KComparison {
  double apart = 0.0;   ///< as a part of K, along a front of its largest
  double allowed = 0.0; ///< of the same
  std::string what{};   ///< "G = 1.92e-06 and (K1^2 + K2^2)/E' = 1.86e-06 are 1.6 % of K apart"
  std::string place{};  ///< along a front in space: ", at (0, 1, 0) of its front"

  [[nodiscard]] double ratio() const { return apart / allowed; }
  [[nodiscard]] bool parts() const { return apart > allowed; }
};

// Half the width of a bar about raw K of a mode, which two ways to it are measured by.
double raw_bar(const results::FrontPointResult& point, std::size_t mode) {
  return point.bar[mode].size() + std::abs(point.K()[mode] - point.raw_K()[mode]);
}

// hypot(K1, K2) as the mesh has it.
double size_of_tip(const results::FrontResult& front) {
  const std::array<double, 3> K = front.single_point().raw_K();
  return std::hypot(K[0], K[1]);
}

// Of hypot(K1, K2), as a part of it; 0 without a bar.
double bar_of(const results::FrontResult& front, double K) {
  const results::FrontPointResult& tip = front.single_point();
  const std::array<double, 3> of = tip.raw_K();
  return front.has_error_bar()
             ? (std::abs(of[0]) * raw_bar(tip, 0) + std::abs(of[1]) * raw_bar(tip, 1)) / (K * K)
             : 0.0;
}

std::string apart_text(double apart, double bar) {
  return fmt::format("{:.2g} % of K apart{}", 100.0 * apart,
                     bar > 0.0 ? fmt::format(", the error bar is {:.2g} %", 100.0 * bar) : "");
}

// Faces that touch at the tip leave G what the mesh makes of the K1 that they have not, which the
// bar of K2 knows nothing of: as much as judge_faces.cpp lets pass without a warning.
constexpr double of_closed = 0.05;
double left_of_K1(const results::LoadStepResult& step, const results::FrontResult& front) {
  const results::FrontPointResult& tip = front.single_point();
  double most = 0.0;
  for (const double K1 : tip.K1_domain) {
    most = std::max(most, std::abs(K1));
  }
  double pressure = 0.0;
  for (const results::ContactResult& contact : step.contacts) {
    pressure = std::max(pressure, contact.name.ends_with(".FACES") ? contact.max_pressure : 0.0);
  }
  most = std::max(most, of_closed * pressure * std::sqrt(std::numbers::pi * front.a));
  return tip.closed ? most : 0.0;
}

// G counts as the K that it would have, which does not grow without bound where K is next to
// nothing.
KComparison energy(const results::LoadStepResult& step, const results::FrontResult& front,
                   double K) {
  const results::FrontPointResult& tip = front.single_point();
  if (!(tip.G_from_K > 0.0)) {
    return {};
  }
  const double bar = bar_of(front, K);
  // G of the wrong sign is a K of the wrong sign, and as far off.
  const double other = std::copysign(std::sqrt(std::abs(tip.G) / tip.G_from_K), tip.G);
  const double apart = std::abs(other - 1.0);
  return {.apart = apart,
          .allowed = std::max(of_energy, in_bars * bar) + left_of_K1(step, front) / K,
          .what = fmt::format("G = {:.5g} and (K1^2 + K2^2)/E' = {:.5g} are {}", tip.G,
                              tip.G_from_K, apart_text(apart, bar))};
}

KComparison domains(const results::FrontResult& front, double K) {
  const results::FrontPointResult& tip = front.single_point();
  if (tip.closed || tip.K1_domain.size() < 2) {
    return {}; // K1 is 0, what the domains find is not used
  }
  const auto [low, high] = std::ranges::minmax(tip.K1_domain);
  const double bar = front.has_error_bar() ? raw_bar(tip, 0) / K : 0.0;
  const double apart = (high - low) / K;
  return {.apart = apart,
          .allowed = std::max(of_domains, in_bars * bar),
          .what = fmt::format("K1 of the domains goes from {:.5g} to {:.5g}, {}", low, high,
                              apart_text(apart, bar))};
}

KComparison opening(const results::FrontResult& front, double K) {
  const results::FrontPointResult& tip = front.single_point();
  if (!tip.opening || tip.closed) {
    return {};
  }
  const std::array<double, 3>& other = *tip.opening;
  const std::array<double, 3> own = tip.raw_K();
  const double bar = bar_of(front, K);
  const double apart = std::hypot(other[0] - own[0], other[1] - own[1]) / K;
  return {.apart = apart,
          .allowed = std::max(of_opening, in_bars * bar),
          .what = fmt::format(
              "K1 = {:.5g}, K2 = {:.5g}, by the opening of the faces {:.5g}, {:.5g}: {}", own[0],
              own[1], other[0], other[1], apart_text(apart, bar))};
}

KComparison worst_of_tip(const results::LoadStepResult& step, const results::FrontResult& front) {
  const double K = size_of_tip(front);
  KComparison worst;
  for (KComparison& one :
       std::array{energy(step, front, K), domains(front, K), opening(front, K)}) {
    // Of several the one that is furthest beyond what it may be.
    if (one.parts() && (worst.what.empty() || one.ratio() > worst.ratio())) {
      worst = std::move(one);
    }
  }
  return worst;
}

// Roots of energy release rates: K but for a factor of the material.
double root(double G) {
  return std::copysign(std::sqrt(std::abs(G)), G);
}

// The point within the body where K is largest; null: there is none.
const results::FrontPointResult* strongest_point(const results::FrontResult& front) {
  const results::FrontPointResult* strongest = nullptr;
  double most = 0.0;
  for (const results::FrontPointResult& point : front.points) {
    if (!point.at_surface && root(point.G_from_K) > most) {
      most = root(point.G_from_K);
      strongest = &point;
    }
  }
  return strongest;
}

// Of K, as a part of the largest of the front.
double bar_at(const results::FrontResult& front, const results::FrontPointResult& point,
              double largest) {
  const std::array<double, 3> own = point.raw_K();
  const double K = std::hypot(own[0], own[1], own[2]);
  if (!front.has_error_bar() || !(K > 0.0)) {
    return 0.0;
  }
  const double bar = std::hypot(raw_bar(point, 0), raw_bar(point, 1), raw_bar(point, 2));
  return bar / K * root(point.G_from_K) / largest;
}

// Energy by the points of a front in space.
KComparison worst_along(const results::FrontResult& front, double largest) {
  KComparison worst{.allowed = 1.0};
  const results::FrontPointResult* at = nullptr;
  for (const results::FrontPointResult& point : front.points) {
    if (point.at_surface || point.closed) {
      continue;
    }
    const KComparison one{.apart = std::abs(root(point.G) - root(point.G_from_K)) / largest,
                          .allowed = std::max(front.has_error_bar() ? of_tubes : of_others,
                                              bar_at(front, point, largest))};
    if (one.parts() && one.ratio() > worst.ratio()) {
      worst = one;
      at = &point;
    }
  }
  if (at != nullptr) {
    worst.what = fmt::format("G = {:.5g} and G of K1, K2 and K3, {:.5g}, are {:.2g} % of K apart",
                             at->G, at->G_from_K, 100.0 * worst.apart);
    worst.place =
        fmt::format(", at ({:.6g}, {:.6g}, {:.6g}) of its front", at->x.x(), at->x.y(), at->x.z());
  }
  return worst;
}

// K of a front, in space but for a factor of the material.
double size_of(const results::FrontResult& front) {
  if (front.is_tip()) {
    return size_of_tip(front);
  }
  const results::FrontPointResult* strongest = strongest_point(front);
  return strongest != nullptr ? root(strongest->G_from_K) : 0.0;
}

// K that round-off leaves of displacements that do not open a crack of size `a` [length], or of
// pressure that keeps its faces closed where nothing else moves; E' as `E` [stress].
double round_off_level(const results::LoadStepResult& step, double E, double a) {
  double pressure = 0.0;
  for (const results::ContactResult& contact : step.contacts) {
    pressure = std::max(pressure, std::abs(contact.max_pressure));
  }
  const double moved = step.u.size() > 0 ? step.u.lpNorm<Eigen::Infinity>() : 0.0;
  return k_round_off * std::max(E * moved / std::sqrt(a), pressure * std::sqrt(a));
}

// Whether K of a front is what round-off leaves of a step that does not load it.
bool is_round_off(const results::LoadStepResult& step, const results::FrontResult& front) {
  const results::FrontPointResult* strongest = strongest_point(front);
  if (strongest == nullptr) {
    return true;
  }
  if (!(front.a > 0.0) || (front.is_tip() && step.u.size() == 0)) { // not known
    return front.is_tip();
  }
  // Of K1 and K2 alone as exact as of a tip's.
  const std::array<double, 3> own = strongest->raw_K();
  const double K = own[2] == 0.0 ? std::hypot(own[0], own[1]) : std::hypot(own[0], own[1], own[2]);
  return K <= round_off_level(step, K * K / strongest->G_from_K, front.a); // E' is in G
}

// The two ways that part most; `what` is empty: none do, or K is no answer.
KComparison worst_of(const results::LoadStepResult& step, const results::FrontResult& front) {
  const double size = size_of(front);
  if (front.two_materials || !front.invalid_reason.empty() || !(size > 0.0) ||
      is_round_off(step, front)) {
    return {};
  }
  return front.is_tip() ? worst_of_tip(step, front) : worst_along(front, size);
}

/// The results of one front of which two ways part.
struct PartedFront {
  KComparison worst;
  const results::LoadStepResult* step = nullptr;
  const results::FrontResult* front = nullptr;
  int others = -1; ///< beside the worst
};

std::string parted_text(const PartedFront& parted) {
  const results::FrontResult& front = *parted.front;
  const bool tip = front.is_tip();
  return fmt::format(
      "{}, step {}, a = {:.6g}{}: two ways to compute K differ by more than {}: {}{}", front.name,
      parted.step->step, front.a, parted.worst.place,
      front.has_error_bar() ? "its error bar"
      : tip                 ? "on a sound mesh, and there is no error bar"
                            : "on a sound mesh",
      parted.worst.what,
      parted.others > 0
          ? fmt::format("; the same holds for {} other result{} of this {}", parted.others,
                        parted.others > 1 ? "s" : "", tip ? "tip" : "front")
          : "");
}

} // namespace

std::string describe_k_mismatch(const results::LoadStepResult& step,
                                const results::FrontResult& tip) {
  return worst_of(step, tip).what;
}

std::vector<std::string> k_consistency_warnings(const results::RunResult& run) {
  double largest = 0.0;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        largest = std::max(largest, size_of(front));
      }
    }
  }
  std::map<std::string, PartedFront> parted;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        KComparison one = worst_of(step, front);
        if (one.what.empty() || !(size_of(front) > no_K * largest)) {
          continue;
        }
        PartedFront& found = parted[front.name];
        ++found.others;
        if (found.front == nullptr || one.ratio() > found.worst.ratio()) {
          found.worst = std::move(one);
          found.step = &step;
          found.front = &front;
        }
      }
    }
  }
  std::vector<std::string> texts;
  texts.reserve(parted.size());
  for (const auto& [name, one] : parted) {
    texts.push_back(parted_text(one));
  }
  return texts;
}

} // namespace spricka::sense
