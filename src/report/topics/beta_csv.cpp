// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/beta_csv.hpp"

#include "model/model.hpp"
#include "report/drawing/file.hpp"
#include "results/half_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace spricka::report {

namespace {

using base::Vec3;
using results::FrontAxisEnd;

/// Factors of load cases and fits at the end of a step.
struct BetaCsvFactors {
  std::vector<double> of_case, of_fit;
};

// A fit that no step names is there from the beginning.
std::vector<BetaCsvFactors> factors_of_steps(const model::Model& model) {
  BetaCsvFactors now{std::vector<double>(model.cases.size(), 0.0),
                     std::vector<double>(model.contacts.size(), 1.0)};
  for (const model::Step& step : model.steps) {
    for (const model::Action& action : step.actions) {
      if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        now.of_fit[fit->contact.index()] = 0.0;
      }
    }
  }
  std::vector<BetaCsvFactors> out;
  for (const model::Step& step : model.steps) {
    for (const model::Action& action : step.actions) {
      if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        now.of_fit[fit->contact.index()] = fit->factor;
      } else if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
        now.of_case[load->load_case.index()] = load->factor;
      }
    }
    out.push_back(now);
  }
  return out;
}

BetaCsvFactors between(const BetaCsvFactors& from, const BetaCsvFactors& to, double t) {
  BetaCsvFactors out = from;
  for (std::size_t i = 0; i < out.of_case.size(); ++i) {
    out.of_case[i] += t * (to.of_case[i] - from.of_case[i]);
  }
  for (std::size_t i = 0; i < out.of_fit.size(); ++i) {
    out.of_fit[i] += t * (to.of_fit[i] - from.of_fit[i]);
  }
  return out;
}

std::string factor_cells(const BetaCsvFactors& factors) {
  std::string text;
  for (const double f : factors.of_case) {
    text += fmt::format(",{}", f);
  }
  for (const double f : factors.of_fit) {
    text += fmt::format(",{}", f);
  }
  return text;
}

std::string k_cells(double a, double K1, double K2) {
  return fmt::format(",{},{},{}\n", K1, K2, K1 / std::sqrt(std::numbers::pi * a));
}

std::size_t step_index(const model::Model& model, std::string_view name) {
  const auto found = std::ranges::find(model.steps, name, &model::Step::name);
  return static_cast<std::size_t>(found - model.steps.begin());
}

// Empty cells where there is none.
std::array<std::string, 2> sizes_of(const std::vector<FrontAxisEnd>& ends) {
  const std::array<double, 2> half = results::half_axes(ends);
  const auto cell = [](double size) { return size > 0.0 ? fmt::format("{}", size) : ""; };
  return {cell(half[0]), cell(half[1])};
}

/// One line of the table in space.
struct SpaceRow {
  int increment = 0;
  const FrontAxisEnd& end;
  const std::array<std::string, 2>& sizes;
  std::string where, factors;
  double K1 = 0.0, K2 = 0.0;
};

std::string line_of(const SpaceRow& row) {
  return fmt::format("{},{},{},{},{}{},{},{},{}\n", row.increment, row.end.tip, row.sizes[0],
                     row.sizes[1], row.where, row.factors, row.K1, row.K2,
                     row.K1 / std::sqrt(std::numbers::pi * row.end.size));
}

// K as the smooth function along the front: at the surface what goes on from inside.
std::string front_rows(int increment, const model::Model& model, const results::StepResult& step,
                       const std::string& factors) {
  std::string text;
  for (const results::FrontResult& front : step.fronts) {
    const model::CrackDefinition* crack = results::find_crack_by_front(model, front.name);
    if (crack == nullptr || crack->kind == model::CrackDefinitionKind::front ||
        front.points.size() < 2) {
      continue;
    }
    std::vector<Vec3> points;
    for (const results::FrontPointResult& place : front.points) {
      points.push_back(place.x);
    }
    const std::vector<FrontAxisEnd> ends = results::axis_ends(*crack, points, front.closed);
    const std::array<std::string, 2> sizes = sizes_of(ends);
    for (const FrontAxisEnd& end : ends) {
      const auto K = [&](std::size_t mode) {
        return end.interpolate(front.points[end.from].smooth.at(mode),
                               front.points[end.to].smooth.at(mode));
      };
      text += line_of({increment, end, sizes, step.step + ",", factors, K(0), K(1)});
    }
  }
  return text;
}

std::string path_rows(int increment, const model::Model& model, const results::LoadPathResult& path,
                      const std::array<const BetaCsvFactors*, 2>& directions) {
  std::string text;
  for (const results::LoadPathFront& front : path.fronts) {
    const model::CrackDefinition* crack = results::find_crack_by_front(model, front.is.name);
    if (crack == nullptr || crack->kind == model::CrackDefinitionKind::front ||
        front.points.size() < 2) {
      continue;
    }
    std::vector<Vec3> points;
    for (const results::LoadPathFrontPoint& point : front.points) {
      points.push_back(point.is.x);
    }
    const std::vector<FrontAxisEnd> ends = results::axis_ends(*crack, points, front.is.closed);
    const std::array<std::string, 2> sizes = sizes_of(ends);
    for (const FrontAxisEnd& end : ends) {
      for (std::size_t k = 0; k < path.t.size(); ++k) {
        const auto at = [&](std::size_t i, std::size_t mode) {
          const results::LoadPathFrontPoint& point = front.points[i];
          return (point.is.at_surface ? point.smooth : point.K).at(mode).at_knot(k);
        };
        const auto K = [&](std::size_t mode) {
          return end.interpolate(at(end.from, mode), at(end.to, mode));
        };
        text +=
            line_of({increment, end, sizes, fmt::format("{},{}", path.name, path.t[k]),
                     factor_cells(between(*directions[0], *directions[1], path.t[k])), K(0), K(1)});
      }
    }
  }
  return text;
}

} // namespace

void write_beta_csv(const std::filesystem::path& file, const model::Model& model,
                    const results::RunResult& run) {
  if (model.cracks.empty()) {
    return;
  }
  const bool space = model.mesh.dim == 3;
  std::string text = fmt::format(
      "# units: a{3} [{0}], K1 K2 [{1}], beta [{2}] = K1/sqrt(pi a){4}, factors and t [1]\n"
      "increment,tip,a{5},where,t",
      model.units.length_name, model.units.stress_intensity_name(), model.units.stress_name(),
      space ? " c" : "", space ? ", of tips C K1/sqrt(pi c)" : "", space ? ",c" : "");
  for (const model::LoadCase& load_case : model.cases) {
    text += ",load_" + load_case.name;
  }
  for (const model::Contact& contact : model.contacts) {
    text += ",fit_" + contact.name;
  }
  text += ",K1,K2,beta\n";
  const std::vector<BetaCsvFactors> factors = factors_of_steps(model);
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      text += front_rows(increment.number, model, step,
                         factor_cells(factors[step_index(model, step.step)]));
      for (const results::TipResult& tip : step.tips) {
        if (!tip.two_materials) {
          text += fmt::format("{},{},{},{},{}", increment.number, tip.name, tip.a, step.step, "") +
                  factor_cells(factors[step_index(model, step.step)]) +
                  k_cells(tip.a, tip.K1, tip.K2);
        }
      }
    }
    for (const results::LoadPathResult& path : increment.paths) {
      text +=
          path_rows(increment.number, model, path,
                    {&factors[step_index(model, path.from)], &factors[step_index(model, path.to)]});
      for (const results::LoadPathTip& tip : path.tips) {
        for (std::size_t k = 0; k < path.t.size(); ++k) {
          text += fmt::format("{},{},{},{},{}", increment.number, tip.name, tip.a, path.name,
                              path.t[k]) +
                  factor_cells(between(factors[step_index(model, path.from)],
                                       factors[step_index(model, path.to)], path.t[k])) +
                  k_cells(tip.a, tip.K1.at_knot(k), tip.K2.at_knot(k));
        }
      }
    }
  }
  write_file(file, text);
}

} // namespace spricka::report
