// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/refine/wide_bars.hpp"

#include "model/model.hpp"
#include "sense/k_consistency.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

/// The crack that a front's name begins with: "C1", or "C1.2" of two tips or parts.
base::CrackId crack_of(const model::Model& model, const std::string& front) {
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    const std::string& name = model.cracks[c].name;
    if (front == name || front.starts_with(name + ".")) {
      return base::CrackId(c);
    }
  }
  return {};
}

std::optional<double> tolerance_of(const model::Model& model, base::CrackId crack) {
  for (const model::TipMeshSettings& tip : model.tip_nets) {
    if (tip.crack == crack) {
      return tip.tolerance;
    }
  }
  return std::nullopt;
}

// K below this part of the largest of the run is what round-off leaves of unloaded steps.
constexpr double no_K = 1e-9;

double largest_K(const results::FrontResult& front) {
  double most = 0.0;
  for (const results::FrontPointResult& point : front.points) {
    // The plane takes two values: with three the last digit differs.
    most = std::max(most, front.is_tip() ? std::hypot(point.K1, point.K2)
                                         : std::hypot(point.K1, point.K2, point.K3));
  }
  return most;
}

template <class F> void for_each_front(const results::RunResult& run, F&& f) {
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        f(increment, step, front);
      }
    }
  }
}

// The bars of a front that are the furthest beyond what is allowed.
void add_bars(const FrontWithTolerance& at, ToleranceShortfall& worst) {
  for (const results::FrontPointResult& point : at.front.points) {
    for (std::size_t k = 0; k < 3 && at.K > 0.0 && !point.at_surface; ++k) {
      const double part = point.bar[k].size() / at.K;
      // The floor of a bar falls with no mesh: what is asked for must leave room above it.
      worst.below_floor = worst.below_floor || point.bar[k].floor >= 0.99 * at.tolerance * at.K;
      if (part / at.tolerance > worst.ratio) {
        const double a = at.front.a > 0.0 ? at.front.a : at.increment.a;
        worst.ratio = part / at.tolerance;
        worst.bar = part;
        worst.wanted = at.tolerance;
        worst.where = fmt::format("K{} of {}, step {}, {}", k + 1, at.front.name, at.step.step,
                                  at.front.is_tip() ? fmt::format("a = {:.6g}", a)
                                                    : fmt::format("point {}", point.number));
      }
    }
  }
}

} // namespace

std::vector<FrontWithTolerance> fronts_with_tolerance(const model::Model& model,
                                                      const results::RunResult& run) {
  double largest = 0.0;
  for_each_front(run, [&](const auto&, const auto&, const results::FrontResult& front) {
    largest = std::max(largest, largest_K(front));
  });
  std::vector<FrontWithTolerance> list;
  for_each_front(run, [&](const results::CrackLengthResult& increment,
                          const results::LoadStepResult& step, const results::FrontResult& front) {
    const base::CrackId crack = crack_of(model, front.name);
    const std::optional<double> tolerance = tolerance_of(model, crack);
    const double K = largest_K(front);
    if (tolerance && (K > no_K * largest || !front.invalid_reason.empty())) {
      list.push_back({increment, step, front, crack, K, *tolerance});
    }
  });
  return list;
}

std::vector<ExcessiveErrorBar> find_excessive_error_bars(const model::Model& model,
                                                         const results::RunResult& run) {
  std::vector<ExcessiveErrorBar> list;
  for (const FrontWithTolerance& at : fronts_with_tolerance(model, run)) {
    const double allowed = at.tolerance * at.K;
    for (std::size_t m = 0; m < 2 && at.front.has_error_bar(); ++m) {
      const results::KErrorBar& bar = at.front.single_point().bar[m];
      if (bar.size() > allowed && allowed > 0.0) {
        list.push_back({at, bar, allowed});
      }
    }
  }
  return list;
}

ToleranceShortfall find_tolerance_shortfall(const model::Model& model,
                                            const results::RunResult& run) {
  ToleranceShortfall worst;
  for (const FrontWithTolerance& at : fronts_with_tolerance(model, run)) {
    const std::string where = fmt::format("{}, step {}", at.front.name, at.step.step);
    if (!at.front.has_error_bar()) {
      worst.no_bar = fmt::format("{}: {}", where, at.front.missing_bar_reason);
      continue;
    }
    if (at.front.is_tip()) {
      const std::string parted = sense::describe_k_mismatch(at.step, at.front);
      worst.parted = parted.empty() ? worst.parted : fmt::format("{}: {}", where, parted);
    }
    add_bars(at, worst);
  }
  return worst;
}

} // namespace spricka::analysis
