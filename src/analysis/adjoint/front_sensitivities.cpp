// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_sensitivities.hpp"

#include "analysis/adjoint/contact_rates.hpp"
#include "analysis/adjoint/front_advance.hpp"
#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Faces that touch hold K1 at 0.
void hold_closed_points(const crack::KLayout& layout, const results::LoadStepResult& result,
                        base::Matrix& dK) {
  std::size_t point = 0;
  for (const results::FrontResult& front : result.fronts) {
    for (const results::FrontPointResult& place : front.points) {
      const Eigen::Index K1 = layout.at(point++, 1);
      if (place.closed) {
        dK.row(K1).setZero();
      }
    }
  }
}

} // namespace

FrontSensitivityAnalysis::FrontSensitivityAnalysis(const model::Model& model,
                                                   const Discretisation& scene)
    : model_(model), scene_(scene) {}

FrontSensitivityAnalysis::~FrontSensitivityAnalysis() = default;

void FrontSensitivityAnalysis::prepare() {
  if (prepared_) {
    return;
  }
  prepared_ = true;
  case_load_ = reduced_case_loads(model_, scene_);
  of_loads_ = K_added_by_load_cases(model_, scene_);
}

// Moved meshes and their K cost as much as a step: they are made once a step has use for them.
const std::vector<std::unique_ptr<VirtualAxisExtension>>&
FrontSensitivityAnalysis::axis_extensions() {
  for (std::size_t c = 0; c < model_.cracks.size() && !extended_; ++c) {
    if (model_.cracks[c].kind == model::CrackDefinitionKind::ellipse) {
      for (const EllipseAxis axis : {EllipseAxis::a, EllipseAxis::c}) {
        extensions_.push_back(
            std::make_unique<VirtualAxisExtension>(model_, scene_, base::CrackId(c), axis));
      }
    }
  }
  extended_ = true;
  return extensions_;
}

void FrontSensitivityAnalysis::add_axes(const FrozenContactStep& step, const KFunctionals& K,
                                        std::vector<ParameterPartialDerivatives>& causes,
                                        results::LoadStepResult& result) {
  if ((step.solver.gap_offset_at_mounting().array() != 0.0).any()) {
    for (const model::CrackDefinition& crack : model_.cracks) {
      if (crack.kind == model::CrackDefinitionKind::ellipse) {
        add_sensitivity_note(fmt::format("no derivative by the axes of {}: parts were mounted on "
                                         "deformed ones",
                                         crack.name),
                             result);
      }
    }
    return;
  }
  for (const std::unique_ptr<VirtualAxisExtension>& advance : axis_extensions()) {
    if (const std::string why = advance->why_no_derivative(step); !why.empty()) {
      add_sensitivity_note(
          fmt::format("no derivative by the axes of {}: {}", advance->crack_name(), why), result);
    } else {
      causes.push_back(advance->axis_partial_derivatives(step, K));
    }
  }
}

void FrontSensitivityAnalysis::solve(const FrozenContactStep& step, const KFunctionals& K,
                                     const std::vector<ParameterPartialDerivatives>& causes,
                                     results::LoadStepResult& result) const {
  LoadAndGapRates rates;
  rates.gap = gather_load_or_gap_columns(causes, &ParameterPartialDerivatives::gap,
                                         static_cast<Eigen::Index>(scene_.table.size()));
  const FrozenContactResponse change = step.system.solve_response(
      gather_load_or_gap_columns(causes, &ParameterPartialDerivatives::load, step.state.u.size()),
      rates.gap);
  if (!change.why_not.empty()) {
    add_sensitivity_note(change.why_not, result);
    return;
  }
  add_sensitivity_parameters(causes, result);
  // Without contact there is nothing to end any range.
  LinearRanges reach = unbounded_ranges(causes.size());
  if (step.system.fixed_active_set() != nullptr) {
    rates.free = change.free;
    std::ranges::copy(FrozenContact(step.solver, scene_, step.state)
                          .linear_ranges(*step.system.fixed_active_set(), rates),
                      reach.begin());
    for (std::size_t i = 0; i < causes.size(); ++i) {
      if (causes[i].is.cause == results::SensitivityParameter::modulus) {
        reach[i] = std::nullopt; // not computed
      }
    }
  }
  base::Matrix dK =
      K.of_displacements().transpose() * change.u + K.of_contact_forces() * change.force;
  dK += gather_load_or_gap_columns(causes, &ParameterPartialDerivatives::direct, dK.rows());
  hold_closed_points(scene_.k_layout(), result, dK);
  store_derivatives(scene_.k_layout(), dK, reach, result);
}

void FrontSensitivityAnalysis::add_to_fronts(const FrozenContactStep& step, const KFunctionals& K,
                                             results::LoadStepResult& result) {
  if (step.contact.rubs) {
    add_sensitivity_note(depends_on_history, result);
    return;
  }
  if (step.solver.contact_system() != nullptr &&
      FrozenContact(step.solver, scene_, step.state).is_degenerate()) {
    add_sensitivity_note("a pair is about to open or to close at this very state, where K has two "
                         "derivatives",
                         result);
    return;
  }
  prepare();
  const SolvedStepKFunction of{
      model_,
      scene_,
      step.solver,
      step.state,
      case_load_,
      of_loads_,
      [&K](const base::Vector& u) -> base::Vector { return K.of_displacements().transpose() * u; }};
  std::vector<ParameterPartialDerivatives> causes = load_and_fit_partial_derivatives(of);
  if ((step.solver.gap_offset_at_mounting().array() != 0.0).any()) {
    add_sensitivity_note("no derivatives by moduli: parts were mounted on deformed ones", result);
  } else {
    add_modulus_partial_derivatives(of, causes);
  }
  // Loads of parts that are not mounted yet: known before the axes, which cost most.
  if (std::string why = step.system.why_no_response(gather_load_or_gap_columns(
          causes, &ParameterPartialDerivatives::load, step.state.u.size()));
      !why.empty()) {
    add_sensitivity_note(why, result);
    return;
  }
  add_axes(step, K, causes, result);
  solve(step, K, causes, result);
}

} // namespace spricka::analysis
