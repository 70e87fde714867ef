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

std::size_t step_index(const model::Model& model, std::string_view name) {
  const auto found = std::ranges::find(model.steps, name, &model::Step::name);
  return static_cast<std::size_t>(found - model.steps.begin());
}

/// A moment of a step or of a load path: where it is and under which factors.
struct BetaMoment {
  std::string where; ///< "step," or "path,t"
  std::string factors;
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
  return results::axis_ends(*crack, points, front.is_loop);
}

// "a", in space "a,c"; empty cells where there is none.
std::string size_cells(const std::vector<FrontAxisEnd>& ends, bool tip) {
  if (tip) {
    return fmt::format("{}", ends.front().size);
  }
  const std::array<double, 2> half = results::half_axes(ends);
  const auto cell = [](double size) { return size > 0.0 ? fmt::format("{}", size) : ""; };
  return cell(half[0]) + "," + cell(half[1]);
}

// K_at: K of a mode (0, 1) at a point and at one of the moments.
template <class KAt>
std::string beta_rows(int increment, const model::Model& model, const results::FrontResult& front,
                      const std::vector<Vec3>& points, const std::vector<BetaMoment>& moments,
                      const KAt& K_at) {
  const std::vector<FrontAxisEnd> ends = ends_of(model, front, points);
  const std::string sizes = size_cells(ends, points.size() == 1);
  std::string text;
  for (const FrontAxisEnd& end : ends) {
    for (std::size_t k = 0; k < moments.size(); ++k) {
      const auto K = [&](std::size_t mode) {
        return end.interpolate(K_at(end.from, mode, k), K_at(end.to, mode, k));
      };
      const double K1 = K(0);
      text +=
          fmt::format("{},{},{},{}{},{},{},{}\n", increment, end.tip, sizes, moments[k].where,
                      moments[k].factors, K1, K(1), K1 / std::sqrt(std::numbers::pi * end.size));
    }
  }
  return text;
}

// K as the smooth function along the front: at the surface what goes on from inside.
std::string step_rows(int increment, const model::Model& model, const results::StepResult& step,
                      const BetaCsvFactors& factors) {
  const std::vector<BetaMoment> end{{step.step + ",", factor_cells(factors)}};
  std::string text;
  for (const results::FrontResult& front : step.fronts) {
    if (front.two_materials) {
      continue;
    }
    std::vector<Vec3> points;
    for (const results::FrontPointResult& point : front.points) {
      points.push_back(point.x);
    }
    text += beta_rows(increment, model, front, points, end,
                      [&](std::size_t i, std::size_t mode, std::size_t /*moment*/) {
                        return front.points[i].smooth.at(mode);
                      });
  }
  return text;
}

std::string path_rows(int increment, const model::Model& model, const results::LoadPathResult& path,
                      const BetaCsvFactors& from, const BetaCsvFactors& to) {
  std::vector<BetaMoment> knots;
  for (const double t : path.t) {
    knots.push_back({fmt::format("{},{}", path.name, t), factor_cells(between(from, to, t))});
  }
  std::string text;
  for (const results::LoadPathFront& front : path.fronts) {
    std::vector<Vec3> points;
    for (const results::LoadPathFrontPoint& point : front.points) {
      points.push_back(point.is.x);
    }
    text +=
        beta_rows(increment, model, front.is, points, knots,
                  [&](std::size_t i, std::size_t mode, std::size_t knot) {
                    const results::LoadPathFrontPoint& point = front.points[i];
                    return (point.is.at_surface ? point.smooth : point.K).at(mode).at_knot(knot);
                  });
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
      text += step_rows(increment.number, model, step, factors[step_index(model, step.step)]);
    }
    for (const results::LoadPathResult& path : increment.paths) {
      text += path_rows(increment.number, model, path, factors[step_index(model, path.from)],
                        factors[step_index(model, path.to)]);
    }
  }
  write_file(file, text);
}

} // namespace spricka::report
