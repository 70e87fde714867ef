// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/refine/front_shortfall.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Bars along fronts fall with about the square of the sizes of tube and patch (manual,
// tolerance.5).
constexpr double order_along = 2.0;
constexpr double aim_along = 0.9;
constexpr double most_in_round = 1.6; // elements of a patch grow with its cube

double largest_K(const results::FrontResult& front) {
  double most = 0.0;
  for (const results::FrontPointResult& place : front.points) {
    most = std::max(most, std::hypot(place.K1, place.K2, place.K3));
  }
  return most;
}

struct WantedFront {
  const results::Increment& increment;
  const results::StepResult& step;
  const results::FrontResult& front;
  std::size_t crack = 0;
  double tolerance = 0.0;
  double K = 0.0; ///< the largest along it
};

void for_each_front(const model::Model& model, const results::RunResult& run,
                    const std::function<void(const WantedFront&)>& look) {
  double largest = 0.0;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        largest = std::max(largest, largest_K(front));
      }
    }
  }
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        const double K = largest_K(front);
        for (const model::TipMeshSettings& tip : model.tip_nets) {
          const std::string& name = model.cracks[tip.crack.index()].name;
          const bool own = front.name == name || front.name.starts_with(name + ".");
          // What is below is what round-off leaves of a step without loads.
          if (own && tip.tolerance && (K > 1e-9 * largest || !front.invalid_reason.empty())) {
            look({increment, step, front, tip.crack.index(), *tip.tolerance, K});
          }
        }
      }
    }
  }
}

} // namespace

ToleranceShortfall front_shortfall(const model::Model& model, const results::RunResult& run) {
  ToleranceShortfall worst;
  for_each_front(model, run, [&](const WantedFront& at) {
    if (!at.front.no_bar.empty()) {
      worst.no_bar = fmt::format("{}, step {}: {}", at.front.name, at.step.step, at.front.no_bar);
      return;
    }
    for (const results::FrontPointResult& place : at.front.points) {
      for (std::size_t k = 0; k < 3 && !place.at_surface; ++k) {
        const double part = place.bar[k].size() / at.K;
        worst.below_floor = worst.below_floor || place.bar[k].floor >= at.tolerance * at.K;
        if (part / at.tolerance > worst.ratio) {
          worst.ratio = part / at.tolerance;
          worst.bar = part;
          worst.wanted = at.tolerance;
          worst.where = fmt::format("K{} of {}, step {}, point {}", k + 1, at.front.name,
                                    at.step.step, place.number);
        }
      }
    }
  });
  return worst;
}

std::vector<double> front_refinement(const model::Model& model, const results::RunResult& run) {
  std::vector<double> finer(model.cracks.size(), 1.0);
  for_each_front(model, run, [&](const WantedFront& at) {
    for (const results::FrontPointResult& place : at.front.points) {
      for (std::size_t k = 0; k < 3 && !place.at_surface && at.front.no_bar.empty(); ++k) {
        const results::KErrorBar& bar = place.bar[k];
        const double room = aim_along * (at.tolerance * at.K - bar.floor);
        const double over = room > 0.0 ? bar.mesh / room : std::pow(most_in_round, order_along);
        finer[at.crack] =
            std::clamp(std::pow(over, 1.0 / order_along), finer[at.crack], most_in_round);
      }
    }
  });
  return finer;
}

} // namespace spricka::analysis
