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

/// The crack that a tip's name begins with: "C1", or "C1.2" of two tips.
base::CrackId crack_of(const model::Model& model, const std::string& tip) {
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    const std::string& name = model.cracks[c].name;
    if (tip == name || tip.starts_with(name + ".")) {
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

template <class F>
void for_each_tip(const model::Model& model, const results::RunResult& run, F&& f) {
  double largest = 0.0;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        largest = std::max(largest, std::hypot(tip.K1, tip.K2));
      }
    }
  }
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        const std::optional<double> tolerance = tolerance_of(model, crack_of(model, tip.name));
        const bool loaded =
            std::hypot(tip.K1, tip.K2) > no_K * largest || !tip.invalid_reason.empty();
        if (tolerance && loaded) {
          f(increment, step, tip, *tolerance);
        }
      }
    }
  }
}

} // namespace

std::vector<ExcessiveErrorBar> wide_error_bars(const model::Model& model,
                                               const results::RunResult& run) {
  std::vector<ExcessiveErrorBar> list;
  for_each_tip(model, run,
               [&](const results::Increment& increment, const results::StepResult& step,
                   const results::TipResult& tip, double tolerance) {
                 const double allowed = tolerance * std::hypot(tip.K1, tip.K2);
                 for (std::size_t m = 0; m < 2 && tip.no_bar.empty(); ++m) {
                   if (tip.bar[m].size() > allowed && allowed > 0.0) {
                     list.push_back({.increment = increment,
                                     .step = step,
                                     .tip = tip,
                                     .bar = tip.bar[m],
                                     .mode = static_cast<int>(m) + 1,
                                     .crack = crack_of(model, tip.name),
                                     .allowed = allowed,
                                     .wanted = tolerance});
                   }
                 }
               });
  return list;
}

ToleranceShortfall shortfall(const model::Model& model, const results::RunResult& run) {
  ToleranceShortfall worst;
  for_each_tip(model, run,
               [&](const results::Increment& increment, const results::StepResult& step,
                   const results::TipResult& tip, double tolerance) {
                 if (!tip.no_bar.empty()) {
                   worst.no_bar = fmt::format("{}, step {}: {}", tip.name, step.step, tip.no_bar);
                   return;
                 }
                 if (const std::string parted = sense::describe_tip_mismatch(step, tip);
                     !parted.empty()) {
                   worst.parted = fmt::format("{}, step {}: {}", tip.name, step.step, parted);
                 }
                 const double K = std::hypot(tip.K1, tip.K2);
                 for (std::size_t m = 0; m < 2 && K > 0.0; ++m) {
                   const double part = tip.bar[m].size() / K;
                   // The floor of a bar falls with no mesh.
                   worst.below_floor = worst.below_floor || tip.bar[m].floor >= tolerance * K;
                   if (part / tolerance > worst.ratio) {
                     worst.ratio = part / tolerance;
                     worst.bar = part;
                     worst.wanted = tolerance;
                     worst.where = fmt::format("K{} of {}, step {}, a = {:.6g}", m + 1, tip.name,
                                               step.step, tip.a > 0.0 ? tip.a : increment.a);
                   }
                 }
               });
  return worst;
}

} // namespace spricka::analysis
