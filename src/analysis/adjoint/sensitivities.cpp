// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/sensitivities.hpp"

#include "analysis/scene/scene_heat.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "analysis/scene/tip_name.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "analysis/steps/row_opening.hpp"
#include "estimate/modulus.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using results::Sensitivity;

constexpr double same = 1e-10; ///< of the larger: two derivatives are one

std::size_t tip_material(const model::Model& model, const Discretisation& scene, std::size_t t) {
  const base::ElementId near = scene.tips[t].fields.front().elements.front();
  return model.element_property(scene.cracked.mesh, near).material.index();
}

// dK1 and dK2 by a cause (sensitivity.6). K1 stays 0 while the faces touch at the tip.
std::array<double, 2> slope(const Discretisation& scene, const TipParameterDerivative& cause,
                            const estimate::IntensityAdjoint& adjoint, std::size_t t) {
  const std::optional<std::size_t> row = row_at_tip(scene, scene.cracked.fronts[t]);
  base::Vec2 dK = cause.direct.col(static_cast<Eigen::Index>(t));
  if (cause.load.size() > 0) {
    dK += adjoint.z.transpose() * cause.load;
  }
  if (cause.gap.size() > 0) {
    dK += adjoint.w.transpose() * cause.gap;
  }
  return {row && adjoint.closed[*row] ? 0.0 : dK[0], dK[1]};
}

// Sides that differ by round-off only (rows that say what others say choose freely).
void unite(Sensitivity& s) {
  if (!s.below || !s.above) {
    return;
  }
  double apart = 0.0;
  double size = 0.0;
  for (const std::size_t k : {0U, 1U}) {
    apart = std::max(apart, std::abs((*s.above)[k] - (*s.below)[k]));
    size = std::max({size, std::abs((*s.above)[k]), std::abs((*s.below)[k])});
  }
  if (apart <= same * size) {
    s.above = s.below;
  }
}

bool ranged(const TipParameterDerivative& cause) {
  return cause.is.cause == results::SensitivityParameter::load ||
         cause.is.cause == results::SensitivityParameter::fit;
}

} // namespace

TipSensitivityAnalysis::TipSensitivityAnalysis(const model::Model& model,
                                               const Discretisation& scene,
                                               const std::vector<SubstructuredBody>& bodies)
    : model_(model), scene_(scene), bodies_(bodies) {}

void TipSensitivityAnalysis::prepare() {
  if (!advances_.empty()) {
    return;
  }
  case_load_ = loads_with_supports(model_, scene_);
  for (std::size_t t = 0; t < scene_.tips.size(); ++t) {
    of_loads_.push_back(K_from_loads(model_, scene_, t));
    base::Matrix& by_modulus = of_moduli_.emplace_back(base::Matrix::Zero(2, of_loads_[t].cols()));
    if ((of_loads_[t].array() != 0.0).any()) {
      // What loads add to K is a constant and a part that goes with E: twice the modulus shows
      // that.
      model::Model stiffer = model_;
      stiffer.materials[tip_material(model_, scene_, t)].E *= 2.0;
      by_modulus = K_from_loads(stiffer, scene_, t) - of_loads_[t];
    }
    advances_.push_back(std::make_unique<VirtualTipExtension>(model_, scene_, t));
  }
}

TipParameterDerivative TipSensitivityAnalysis::cause(results::SensitivityParameter kind,
                                                     std::string name, double value) const {
  TipParameterDerivative out;
  out.is.cause = kind;
  out.is.name = std::move(name);
  out.is.value = value;
  out.direct = base::Matrix::Zero(2, static_cast<Eigen::Index>(scene_.tips.size()));
  return out;
}

void TipSensitivityAnalysis::add_loads(const StepSolver& solver,
                                       const std::vector<estimate::IntensityAdjoint>& adjoints,
                                       std::vector<TipParameterDerivative>& causes) const {
  const int dim = scene_.cracked.mesh.dim;
  for (std::size_t c = 0; c < model_.cases.size(); ++c) {
    const auto k = static_cast<Eigen::Index>(c);
    TipParameterDerivative one = cause(results::SensitivityParameter::load, model_.cases[c].name,
                                       solver.factors().case_factor[k]);
    one.load = case_load_.col(k);
    const base::Vector given = scene_.case_displacement.col(k);
    // Prescribed displacements pull at the body, open rows and move nodes that K takes
    // (sensitivity.7).
    const bool moves = (given.array() != 0.0).any();
    if (moves) {
      one.gap.resize(static_cast<Eigen::Index>(scene_.table.size()));
      for (std::size_t r = 0; r < scene_.table.size(); ++r) {
        one.gap[static_cast<Eigen::Index>(r)] = row_opening(scene_.contact_row(r), dim, given);
      }
    }
    for (std::size_t t = 0; t < scene_.tips.size(); ++t) {
      auto direct = one.direct.col(static_cast<Eigen::Index>(t));
      direct = of_loads_[t].col(k);
      if (moves) {
        direct += adjoints[t].rows.transpose() * given;
      }
    }
    causes.push_back(std::move(one));
  }
}

void TipSensitivityAnalysis::add_fits(const StepSolver& solver,
                                      std::vector<TipParameterDerivative>& causes) const {
  for (std::size_t c = 0; c < model_.contacts.size(); ++c) {
    const model::Contact& contact = model_.contacts[c];
    if (!contact.gap || !solver.factors().mounted[c]) {
      continue;
    }
    // An interference is a negative gap (sensitivity.7).
    const double interference = -*contact.gap * solver.factors().fit[c];
    TipParameterDerivative one = cause(results::SensitivityParameter::fit, contact.name,
                                       interference == 0.0 ? 0.0 : interference);
    one.gap = base::Vector::Zero(static_cast<Eigen::Index>(scene_.table.size()));
    for (std::size_t i = 0; i < scene_.pairs[c].normal.size(); ++i) {
      one.gap[static_cast<Eigen::Index>(scene_.table.first[c] + i)] =
          -scene_.pairs[c].normal[i].area;
    }
    causes.push_back(std::move(one));
  }
}

void TipSensitivityAnalysis::add_moduli(const StepState& state,
                                        const std::vector<estimate::IntensityAdjoint>& adjoints,
                                        std::vector<TipParameterDerivative>& causes) const {
  // [dim * node, material] thermal loads less internal forces, f^T - K_m u (sensitivity.8).
  base::Matrix loads = -state.internal;
  if (state.temperature.size() > 0) {
    loads += estimate::thermal_loads(model_, scene_.cracked.mesh, state.temperature);
    for (const fe::ScaledTemperature& acting : acting_heat(scene_, state.case_factor)) {
      for (std::size_t m = 0; m < model_.materials.size(); ++m) {
        base::Vector f = base::Vector::Zero(loads.rows());
        fe::add_residual_load(model_, scene_.cracked.mesh, acting, base::MaterialId(m), f);
        loads.col(static_cast<Eigen::Index>(m)) += f;
      }
    }
  }
  for (std::size_t m = 0; m < model_.materials.size(); ++m) {
    const double E = model_.materials[m].E;
    TipParameterDerivative one =
        cause(results::SensitivityParameter::modulus, model_.materials[m].name, E);
    one.load = loads.col(static_cast<Eigen::Index>(m)) / E;
    for (std::size_t t = 0; t < scene_.tips.size(); ++t) {
      if (tip_material(model_, scene_, t) == m) {
        one.direct.col(static_cast<Eigen::Index>(t)) =
            (adjoints[t].rows.transpose() * state.u +
             of_moduli_[t] * state.case_factor.head(of_moduli_[t].cols())) /
            E;
      }
    }
    causes.push_back(std::move(one));
  }
}

void TipSensitivityAnalysis::add_lengths(const StepState& state, const std::vector<bool>& closed,
                                         results::StepResult& result,
                                         std::vector<TipParameterDerivative>& causes) const {
  for (std::size_t t = 0; t < scene_.tips.size(); ++t) {
    const std::string name = result.tips[t].name;
    if (const std::string why_not = advances_[t]->missing_reason(closed); !why_not.empty()) {
      for (results::TipResult& tip : result.tips) {
        tip.sensitivities.notes.push_back(
            fmt::format("no derivative by the length of {}: {}", name, why_not));
      }
      continue;
    }
    TipParameterDerivative one =
        cause(results::SensitivityParameter::length, name, scene_.cracked.fronts[t].a);
    one.load = advances_[t]->load_derivative(state.u, state.case_factor);
    for (std::size_t other = 0; other < scene_.tips.size(); ++other) {
      one.direct.col(static_cast<Eigen::Index>(other)) =
          advances_[t]->explicit_derivative(other, state.u, state.case_factor);
    }
    causes.push_back(std::move(one));
  }
}

// Loads and fits come first; what load cases do to the bodies alone is the same for all steps.
LoadAndGapRates TipSensitivityAnalysis::rates(const StepSolver& solver,
                                              const std::vector<TipParameterDerivative>& causes,
                                              std::size_t count) {
  const auto cases = static_cast<Eigen::Index>(model_.cases.size());
  if (of_cases_.u.empty()) {
    for (const std::size_t b : solver.condensed_bodies()) {
      case_externals_.emplace_back(bodies_[b].external_load.leftCols(cases));
    }
    of_cases_ = contact::unconstrained_response(*solver.contact_system(), case_externals_);
  }
  const auto k = static_cast<Eigen::Index>(count);
  const auto rows = static_cast<Eigen::Index>(scene_.table.size());
  LoadAndGapRates out;
  out.gap = base::Matrix::Zero(rows, k);
  out.load_scale = base::Vector::Zero(k);
  out.free.opening = base::Matrix::Zero(rows, k);
  out.free.on_mode = base::Matrix::Zero(of_cases_.on_mode.rows(), k);
  // Fits change gaps alone: bodies by themselves do not answer to them.
  out.free.opening.leftCols(cases) = of_cases_.opening;
  out.free.on_mode.leftCols(cases) = of_cases_.on_mode;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (causes[i].gap.size() > 0) {
      out.gap.col(at) = causes[i].gap;
    }
    if (causes[i].load.size() > 0) {
      out.load_scale[at] = causes[i].load.lpNorm<1>();
    }
  }
  return out;
}

// The loads of all causes on top, as the contact problem of a direction takes them.
LoadAndGapRates
TipSensitivityAnalysis::all_rates(const StepSolver& solver,
                                  const std::vector<TipParameterDerivative>& causes) {
  LoadAndGapRates out = rates(solver, causes, causes.size());
  const auto k = static_cast<Eigen::Index>(causes.size());
  base::Matrix nodal = base::Matrix::Zero(case_load_.rows(), k);
  for (std::size_t i = model_.cases.size(); i < causes.size(); ++i) {
    if (causes[i].load.size() > 0) {
      nodal.col(static_cast<Eigen::Index>(i)) = causes[i].load;
    }
  }
  scene_.ties->transfer_to_masters(nodal);
  for (std::size_t b = 0; b < solver.condensed_bodies().size(); ++b) {
    base::Matrix load =
        condense_load(bodies_[solver.condensed_bodies()[b]], *scene_.ties, nodal).external;
    // Columns of cases were left zero above: theirs are condensed already.
    load.leftCols(case_externals_[b].cols()) = case_externals_[b];
    out.load.push_back(std::move(load));
  }
  out.free = contact::unconstrained_response(*solver.contact_system(), out.load);
  return out;
}

// Where rows change sides at this very state, each side has its own adjoint; steps end there by
// chance or because nothing is loaded yet.
void TipSensitivityAnalysis::one_sided(const StepSolver& solver, const FrozenContact& contact,
                                       KAdjoints& adjoints,
                                       std::vector<TipParameterDerivative>& causes,
                                       results::StepResult& result) {
  const LoadAndGapRates all = all_rates(solver, causes);
  struct Side {
    std::unique_ptr<contact::FixedActiveSet> held;
    std::vector<estimate::IntensityAdjoint> adjoint;
  };
  std::map<std::vector<bool>, Side> sides;
  for (std::size_t i = 0; i < causes.size(); ++i) {
    std::array<double, 2> range{causes[i].is.value, causes[i].is.value};
    for (const bool up : {false, true}) {
      const std::optional<std::vector<bool>> closed =
          contact.closed_rows_after(all, static_cast<Eigen::Index>(i), up ? 1.0 : -1.0);
      if (!closed) {
        continue;
      }
      // Causes that leave the same rows closed share one factorisation and one adjoint.
      Side& side = sides[*closed];
      if (!side.held) {
        side.held = constrain_rows(solver, *closed);
        side.adjoint = adjoints.solve_closed_set(solver, *closed, side.held.get());
      }
      if (!side.adjoint.front().is_available()) {
        continue;
      }
      range[up ? 1 : 0] += contact.linear_ranges(*side.held, all)[i][up ? 1 : 0];
      for (std::size_t t = 0; t < result.tips.size(); ++t) {
        Sensitivity& s = result.tips[t].sensitivities.of[i];
        (up ? s.above : s.below) = slope(scene_, causes[i], side.adjoint[t], t);
      }
    }
    for (results::TipResult& tip : result.tips) {
      Sensitivity& s = tip.sensitivities.of[i];
      unite(s);
      if (ranged(causes[i])) {
        s.range = range;
      }
    }
  }
}

void TipSensitivityAnalysis::add_to_tips(const StepSolver& solver, const StepState& state,
                                         KAdjoints& adjoints, results::StepResult& result) {
  const std::vector<estimate::IntensityAdjoint>& adjoint = adjoints.solve_last_step(solver);
  if (adjoint.empty()) {
    return;
  }
  if (!adjoint.front().is_available()) {
    for (results::TipResult& tip : result.tips) {
      tip.sensitivities.notes.push_back(adjoint.front().why_not);
    }
    return;
  }
  prepare();
  std::vector<TipParameterDerivative> causes;
  add_loads(solver, adjoint, causes);
  add_fits(solver, causes);
  const std::size_t with_range = causes.size();
  if ((solver.mount_offset().array() != 0.0).any()) {
    for (results::TipResult& tip : result.tips) {
      tip.sensitivities.notes.emplace_back(
          "no derivatives by moduli and crack lengths: parts were mounted on deformed ones");
    }
  } else {
    add_moduli(state, adjoint, causes);
    add_lengths(state, adjoint.front().closed, result, causes);
  }
  for (std::size_t t = 0; t < result.tips.size(); ++t) {
    for (const TipParameterDerivative& one : causes) {
      result.tips[t].sensitivities.of.push_back(one.is);
    }
  }
  std::optional<FrozenContact> contact;
  if (solver.contact_system() != nullptr) {
    contact.emplace(solver, scene_, state);
  }
  if (contact && contact->is_degenerate()) {
    one_sided(solver, *contact, adjoints, causes, result);
    return;
  }
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 2>> reach(causes.size(), {-never, never});
  if (contact) {
    reach = contact->linear_ranges(*adjoints.held_contact(), rates(solver, causes, with_range));
  }
  for (std::size_t t = 0; t < result.tips.size(); ++t) {
    for (std::size_t i = 0; i < causes.size(); ++i) {
      Sensitivity& s = result.tips[t].sensitivities.of[i];
      s.below = s.above = slope(scene_, causes[i], adjoint[t], t);
      // Ranges of moduli and lengths are not computed; without contact there is nothing to end any.
      if (i < with_range || !contact) {
        s.range = {s.value + reach[i][0], s.value + reach[i][1]};
      }
    }
  }
}

} // namespace spricka::analysis
