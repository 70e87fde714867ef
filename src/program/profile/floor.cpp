// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/profile/floor.hpp"

#include "analysis/bodies/whole_stiffness.hpp"
#include "analysis/lengths/growth_loop.hpp"
#include "analysis/scene/make_scene.hpp"
#include "base/clock.hpp"
#include "base/diagnostics.hpp"
#include "base/vec.hpp"
#include "growth/crack_lines.hpp"
#include "model/model.hpp"
#include "solve/condense.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Until so much time is spent [s], so that what takes milliseconds is not a matter of chance.
constexpr double enough = 0.2;
constexpr int most_times = 20;

std::optional<analysis::Discretisation> first_scene(const model::Model& given) {
  model::Model model = given;
  const double a =
      analysis::grows_by_law(model) ? 0.0 : growth::growth_loop_crack_lengths(model).front();
  model.cracks = growth::resize_solid_cracks(model, a);
  base::Diagnostics reported_before;
  return analysis::discretise(model, a, {}, reported_before);
}

std::string trouble_of(const solve::FactorReport& report) {
  if (report.status == solve::FactorStatus::engine_failed) {
    return report.trouble;
  }
  return report.status == solve::FactorStatus::out_of_memory
             ? fmt::format("it needs {:.0f} MB of memory, {:.0f} MB can be had",
                           1e-6 * report.memory, 1e-6 * report.memory_left)
             : "its matrix is singular";
}

void once(const model::Model& model, const analysis::Discretisation& scene,
          FactorisationCostFloor& floor) {
  const base::Stopwatch assembling;
  base::SymmetricCsc K = analysis::regularised_global_stiffness(model, scene);
  const double assembly = assembling.cpu_time();
  floor.equations = K.n;
  const solve::Condensation plain(std::move(K), 0, {.engine = solve::EquationEngine::cholesky});
  const solve::FactorReport& report = plain.report();
  if (report.status != solve::FactorStatus::ok) {
    floor.why_not = trouble_of(report);
    return;
  }
  const base::Stopwatch solving;
  const base::Matrix u = plain.recover(base::Matrix(0, 1), base::Matrix::Ones(floor.equations, 1));
  const double solution = solving.cpu_time();
  const bool first = floor.times++ == 0;
  const auto least = [first](double& of, double now) { of = first ? now : std::min(of, now); };
  least(floor.assembly, assembly);
  least(floor.analysis, report.analysis_cpu);
  least(floor.numeric, report.numeric_cpu);
  least(floor.solution, solution);
  floor.entries = report.factor_entries;
  floor.flops = report.flops;
  if (!u.allFinite()) {
    floor.why_not = "its solution is no number";
  }
}

} // namespace

FactorisationCostFloor measure_factorisation_cost_floor(const model::Model& model) {
  FactorisationCostFloor floor;
  try {
    const std::optional<analysis::Discretisation> scene = first_scene(model);
    if (!scene) {
      floor.why_not = "its mesh cannot be made";
      return floor;
    }
    const base::Stopwatch watch;
    do {
      once(model, *scene, floor);
    } while (floor.why_not.empty() && floor.times < most_times && watch.cpu_time() < enough);
    if (floor.why_not.empty() && floor.equations == 0) {
      floor.why_not = "nothing is free to move";
    }
  } catch (const std::bad_alloc&) {
    // The run itself is done: what it found is not lost for this.
    floor.why_not = "there is not enough memory for it";
  }
  return floor;
}

} // namespace spricka::program
