// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/sensitivities.hpp"

#include "analysis/scene/front_functionals.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using results::Sensitivity;

constexpr double same = 1e-10; ///< of the larger: two derivatives are one

// dK of all tips by a cause (sensitivity.6). K1 stays 0 while the faces touch at the tip.
base::Vector slopes(const Discretisation& scene, const ParameterPartialDerivatives& cause,
                    const StressIntensityAdjoints& adjoint) {
  base::Vector out = cause.direct;
  if (cause.load.size() > 0) {
    out += adjoint.z.transpose() * cause.load;
  }
  if (cause.gap.size() > 0) {
    out += adjoint.w.transpose() * cause.gap;
  }
  for (std::size_t t = 0; t < scene.cracked.fronts.size(); ++t) {
    const std::optional<std::size_t> row = contact_row_at_tip(scene, scene.cracked.fronts[t]);
    double& dK1 = out[scene.k_layout().at(t, 1)];
    dK1 = row && adjoint.closed[*row] ? 0.0 : dK1;
  }
  return out;
}

// Sides that differ by round-off only (rows that say what others say choose freely).
void unite(Sensitivity& s) {
  if (s.below.empty() || s.above.empty()) {
    return;
  }
  double apart = 0.0;
  double size = 0.0;
  for (std::size_t p = 0; p < s.below.size(); ++p) {
    for (std::size_t k = 0; k < 3; ++k) {
      apart = std::max(apart, std::abs(s.above[p][k] - s.below[p][k]));
      size = std::max({size, std::abs(s.above[p][k]), std::abs(s.below[p][k])});
    }
  }
  if (apart <= same * size) {
    s.above = s.below;
  }
}

bool ranged(const ParameterPartialDerivatives& cause) {
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
  case_load_ = reduced_case_loads(model_, scene_);
  of_loads_ = K_added_by_load_cases(model_, scene_);
  for (std::size_t t = 0; t < scene_.cracked.fronts.size(); ++t) {
    advances_.push_back(std::make_unique<VirtualTipExtension>(model_, scene_, t));
  }
}

void TipSensitivityAnalysis::add_lengths(const StepState& state, const std::vector<bool>& closed,
                                         std::vector<ParameterPartialDerivatives>& causes,
                                         results::LoadStepResult& result) const {
  for (const std::unique_ptr<VirtualTipExtension>& advance : advances_) {
    if (const std::string why = advance->why_no_derivative(closed); !why.empty()) {
      add_sensitivity_note(
          fmt::format("no derivative by the length of {}: {}", advance->tip_name(), why), result);
    } else {
      causes.push_back(advance->length_partial_derivatives(state));
    }
  }
}

// Loads and fits come first; what load cases do to the bodies alone is the same for all steps.
LoadAndGapRates
TipSensitivityAnalysis::rates(const StepSolver& solver,
                              const std::vector<ParameterPartialDerivatives>& causes,
                              std::size_t count) {
  const auto cases = static_cast<Eigen::Index>(model_.cases.size());
  if (of_cases_.u.empty()) {
    for (const std::size_t b : solver.condensed_body_indices()) {
      case_externals_.emplace_back(bodies_[b].external_load.leftCols(cases));
    }
    of_cases_ = contact::response_without_contact(*solver.contact_system(), case_externals_);
  }
  const auto k = static_cast<Eigen::Index>(count);
  const auto rows = static_cast<Eigen::Index>(scene_.table.size());
  LoadAndGapRates out;
  out.gap = gather_load_or_gap_columns(std::span(causes).first(count),
                                       &ParameterPartialDerivatives::gap, rows);
  out.load_scale = base::Vector::Zero(k);
  out.free.opening = base::Matrix::Zero(rows, k);
  out.free.on_mode = base::Matrix::Zero(of_cases_.on_mode.rows(), k);
  // Fits change gaps alone: bodies by themselves do not answer to them.
  out.free.opening.leftCols(cases) = of_cases_.opening;
  out.free.on_mode.leftCols(cases) = of_cases_.on_mode;
  for (std::size_t i = 0; i < count; ++i) {
    if (causes[i].load.size() > 0) {
      out.load_scale[static_cast<Eigen::Index>(i)] = causes[i].load.lpNorm<1>();
    }
  }
  return out;
}

// The loads of all causes on top, as the contact problem of a direction takes them.
LoadAndGapRates
TipSensitivityAnalysis::all_rates(const StepSolver& solver,
                                  const std::vector<ParameterPartialDerivatives>& causes) {
  LoadAndGapRates out = rates(solver, causes, causes.size());
  base::Matrix nodal =
      gather_load_or_gap_columns(causes, &ParameterPartialDerivatives::load, case_load_.rows());
  nodal.leftCols(static_cast<Eigen::Index>(model_.cases.size())).setZero();
  scene_.ties->transfer_forces_to_masters(nodal);
  for (std::size_t b = 0; b < solver.condensed_body_indices().size(); ++b) {
    base::Matrix load =
        condense_load(bodies_[solver.condensed_body_indices()[b]], *scene_.ties, nodal).external;
    // Columns of cases were left zero above: theirs are condensed already.
    load.leftCols(case_externals_[b].cols()) = case_externals_[b];
    out.load.push_back(std::move(load));
  }
  out.free = contact::response_without_contact(*solver.contact_system(), out.load);
  return out;
}

// Where rows change sides at this very state, each side has its own adjoint; steps end there by
// chance or because nothing is loaded yet.
void TipSensitivityAnalysis::one_sided(const StepSolver& solver, const FrozenContact& contact,
                                       IntensityAdjointSolver& adjoints,
                                       const std::vector<ParameterPartialDerivatives>& causes,
                                       results::LoadStepResult& result) {
  const LoadAndGapRates all = all_rates(solver, causes);
  struct Side {
    std::optional<FrozenContactSystem> system;
    StressIntensityAdjoints adjoint;
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
      if (!side.system) {
        side.system.emplace(solver, scene_, bodies_, *closed);
        side.adjoint = adjoints.solve_with_closed_rows(*side.system, *closed);
      }
      if (!side.adjoint.is_available()) {
        continue;
      }
      range[up ? 1 : 0] +=
          contact.linear_ranges(*side.system->fixed_active_set(), all)[i][up ? 1 : 0];
      store_one_sided_derivative(scene_.k_layout(), slopes(scene_, causes[i], side.adjoint), i,
                                 up ? &Sensitivity::above : &Sensitivity::below, result);
    }
    for (results::FrontResult& tip : result.fronts) {
      Sensitivity& s = tip.sensitivities.by_parameter[i];
      unite(s);
      if (ranged(causes[i])) {
        s.range = range;
      }
    }
  }
}

void TipSensitivityAnalysis::add_to_tips(const StepSolver& solver, const StepState& state,
                                         IntensityAdjointSolver& adjoints,
                                         results::LoadStepResult& result) {
  const StressIntensityAdjoints& adjoint = adjoints.solve_adjoint_of_last_step(solver);
  if (!adjoint.is_available()) {
    add_sensitivity_note(adjoint.why_not, result);
    return;
  }
  prepare();
  const SolvedStepKFunction K{
      model_,
      scene_,
      solver,
      state,
      case_load_,
      of_loads_,
      [&adjoint](const base::Vector& u) -> base::Vector { return adjoint.rows.transpose() * u; }};
  std::vector<ParameterPartialDerivatives> causes = load_and_fit_partial_derivatives(K);
  const std::size_t with_range = causes.size();
  if ((solver.gap_offset_at_mounting().array() != 0.0).any()) {
    add_sensitivity_note(
        "no derivatives by moduli and crack lengths: parts were mounted on deformed ones", result);
  } else {
    add_modulus_partial_derivatives(K, causes);
    add_lengths(state, adjoint.closed, causes, result);
  }
  add_sensitivity_parameters(causes, result);
  // Without contact there is nothing to end any range.
  LinearRanges reach = unbounded_ranges(causes.size());
  if (solver.contact_system() != nullptr) {
    const FrozenContact contact(solver, scene_, state);
    if (contact.is_degenerate()) {
      one_sided(solver, contact, adjoints, causes, result);
      return;
    }
    // Those of moduli and lengths are not computed.
    reach.assign(causes.size(), std::nullopt);
    std::ranges::copy(
        contact.linear_ranges(*adjoints.fixed_active_set(), rates(solver, causes, with_range)),
        reach.begin());
  }
  base::Matrix dK(K.of_loads.rows(), static_cast<Eigen::Index>(causes.size()));
  for (std::size_t i = 0; i < causes.size(); ++i) {
    dK.col(static_cast<Eigen::Index>(i)) = slopes(scene_, causes[i], adjoint);
  }
  store_derivatives(scene_.k_layout(), dK, reach, result);
}

} // namespace spricka::analysis
