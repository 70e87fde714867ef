// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/beta_csv.hpp"

#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/drawing/file.hpp"
#include "report/topics/dimension_columns.hpp"
#include "results/half_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace spricka::report {

namespace {

using base::Vec3;
using results::FrontAxisEnd;

/// Factors of load cases, then of fits, at one moment.
using BetaCsvFactors = std::vector<double>;

// A fit that no step names is there from the beginning.
std::vector<BetaCsvFactors> factors_of_steps(const model::Model& model) {
  const std::size_t first_fit = model.cases.size();
  BetaCsvFactors now(first_fit, 0.0);
  now.resize(first_fit + model.contacts.size(), 1.0);
  for (const model::Step& step : model.steps) {
    for (const model::StepAction& action : step.actions) {
      if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        now[first_fit + fit->contact.index()] = 0.0;
      }
    }
  }
  std::vector<BetaCsvFactors> out;
  for (const model::Step& step : model.steps) {
    for (const model::StepAction& action : step.actions) {
      if (const auto* fit = std::get_if<model::ApplyFit>(&action)) {
        now[first_fit + fit->contact.index()] = fit->factor;
      } else if (const auto* load = std::get_if<model::ApplyLoad>(&action)) {
        now[load->load_case.index()] = load->factor;
      }
    }
    out.push_back(now);
  }
  return out;
}

BetaCsvFactors between(const BetaCsvFactors& from, const BetaCsvFactors& to, double t) {
  BetaCsvFactors out = from;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] += t * (to[i] - from[i]);
  }
  return out;
}

std::size_t step_index(const model::Model& model, std::string_view name) {
  const auto found = std::ranges::find(model.steps, name, &model::Step::name);
  return static_cast<std::size_t>(found - model.steps.begin());
}

/// A moment of a step, or of a load path at t.
struct BetaMoment {
  std::string where; ///< name of the step or of the path
  std::optional<double> t;
  BetaCsvFactors factors;
};

/// A row of the file: K at a tip, or at an end of an axis, at one moment.
struct BetaRow {
  int increment = 0;
  FrontAxisEnd end;
  std::array<double, 2> half{}; ///< a and c; 0: there is none
  const BetaMoment* moment = nullptr;
  std::array<double, 2> K{}; ///< K1, K2
};

// A tip by its own length; in space the ends of both axes, which cracks drawn by points have not.
std::vector<FrontAxisEnd> ends_of(const model::Model& model, const results::FrontResult& front,
                                  const std::vector<Vec3>& points) {
  if (points.size() == 1) {
    return {{.tip = front.name, .size = front.a}};
  }
  const model::CrackDefinition* crack = results::find_crack_by_front(model, front.name);
  if (crack == nullptr || crack->kind == model::CrackDefinitionKind::front || points.empty()) {
    return {};
  }
  return results::find_front_axis_ends(*crack, points, front.is_loop);
}

/// A point of a front: its place, and K of a mode (0, 1) at one of the moments.
struct BetaPoint {
  Vec3 x;
  std::function<double(std::size_t mode, std::size_t moment)> K;
};

void add_rows(std::vector<BetaRow>& rows, const model::Model& model, int increment,
              const results::FrontResult& front, const std::vector<BetaPoint>& points,
              const std::vector<BetaMoment>& moments) {
  std::vector<Vec3> places;
  std::ranges::transform(points, std::back_inserter(places), &BetaPoint::x);
  const std::vector<FrontAxisEnd> ends = ends_of(model, front, places);
  const std::array<double, 2> half = results::half_axes(ends);
  for (const FrontAxisEnd& end : ends) {
    for (std::size_t k = 0; k < moments.size(); ++k) {
      const auto K = [&](std::size_t mode) {
        return end.interpolate(points[end.from].K(mode, k), points[end.to].K(mode, k));
      };
      rows.push_back({increment, end, half, &moments[k], {K(0), K(1)}});
    }
  }
}

// K as the smooth function along the front: at the surface what goes on from inside.
std::vector<BetaPoint> points_of(const results::FrontResult& front) {
  std::vector<BetaPoint> points;
  for (const results::FrontPointResult& point : front.points) {
    points.push_back({point.x, [&point](std::size_t mode, std::size_t /*moment*/) {
                        return point.smooth.at(mode);
                      }});
  }
  return points;
}

std::vector<BetaPoint> points_of(const results::LoadPathFront& front) {
  std::vector<BetaPoint> points;
  for (const results::LoadPathFrontPoint& point : front.points) {
    points.push_back({point.point_at_start.x, [&point](std::size_t mode, std::size_t knot) {
                        return (point.point_at_start.at_surface ? point.smooth : point.K)
                            .at(mode)
                            .value_at_knot(knot);
                      }});
  }
  return points;
}

Columns<BetaRow> beta_columns(const model::Model& model) {
  Columns<BetaRow> columns;
  columns.exact("increment", &BetaRow::increment);
  columns.exact("tip", [](const BetaRow& row) { return row.end.tip; });
  const std::string_view half_axes = dimension_columns.at(model.mesh.dim).half_axes;
  for (std::size_t i = 0; i < half_axes.size(); ++i) {
    columns.fill_only_if([i](const BetaRow& row) { return row.half.at(i) > 0.0; });
    columns.exact(std::string(1, half_axes[i]), model.units.output_length(),
                  [i](const BetaRow& row) { return row.half.at(i); });
  }
  columns.fill_only_if({});
  columns.exact("where", [](const BetaRow& row) { return row.moment->where; });
  columns.exact("t", [](const BetaRow& row) { return row.moment->t; });
  std::size_t factor = 0;
  const auto add_factor = [&](const std::string& name) {
    columns.exact(name, [i = factor++](const BetaRow& row) { return row.moment->factors[i]; });
  };
  for (const model::LoadCase& load_case : model.cases) {
    add_factor("load_" + load_case.name);
  }
  for (const model::Contact& contact : model.contacts) {
    add_factor("fit_" + contact.name);
  }
  const base::OutputUnit unit = model.units.output_stress_intensity();
  columns.exact("K1", unit, [](const BetaRow& row) { return row.K[0]; });
  columns.exact("K2", unit, [](const BetaRow& row) { return row.K[1]; });
  columns.exact("beta", model.units.output_stress(), [](const BetaRow& row) {
    return row.K[0] / std::sqrt(std::numbers::pi * row.end.size);
  });
  return columns;
}

} // namespace

void write_beta_csv(const std::filesystem::path& file, const model::Model& model,
                    const results::RunResult& run) {
  if (model.cracks.empty()) {
    return;
  }
  const std::vector<BetaCsvFactors> factors = factors_of_steps(model);
  std::deque<std::vector<BetaMoment>> moments; // rows point at them
  std::vector<BetaRow> rows;
  for (const results::CrackLengthResult& increment : run.increments) {
    const auto add = [&](const results::FrontResult& front, const std::vector<BetaPoint>& points) {
      add_rows(rows, model, increment.number, front, points, moments.back());
    };
    for (const results::LoadStepResult& step : increment.steps) {
      moments.push_back({{step.step, std::nullopt, factors[step_index(model, step.step)]}});
      for (const results::FrontResult& front : step.fronts) {
        if (!front.two_materials) {
          add(front, points_of(front));
        }
      }
    }
    for (const results::LoadPathResult& path : increment.paths) {
      moments.emplace_back();
      for (const double t : path.t) {
        moments.back().push_back({path.name, t,
                                  between(factors[step_index(model, path.from)],
                                          factors[step_index(model, path.to)], t)});
      }
      for (const results::LoadPathFront& front : path.fronts) {
        add(front.front_without_points, points_of(front));
      }
    }
  }
  constexpr base::ByDimension axes{std::pair("a", ""),
                                   std::pair("a c", ", of tips C K1/sqrt(pi c)")};
  const auto& [names, of_c] = axes.at(model.mesh.dim);
  const std::string units =
      fmt::format("{} [{}], K1 K2 [{}], beta [{}] = K1/sqrt(pi a){}, factors and t [1]", names,
                  model.units.output_length().name, model.units.output_stress_intensity().name,
                  model.units.output_stress().name, of_c);
  write_file(file, beta_columns(model).csv(units, rows));
}

} // namespace spricka::report
