// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_sensitivities.hpp"

#include "analysis/adjoint/contact_rates.hpp"
#include "analysis/adjoint/front_advance.hpp"
#include "analysis/scene/front_scene.hpp"
#include "analysis/scene/scene_heat.hpp"
#include "analysis/scene/scene_loads.hpp"
#include "analysis/steps/row_opening.hpp"
#include "estimate/modulus.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace spricka::analysis {

namespace {

FrontParameterDerivative cause_of(results::SensitivityParameter kind, std::string name,
                                  double value, Eigen::Index K) {
  FrontParameterDerivative out;
  out.is.cause = kind;
  out.is.name = std::move(name);
  out.is.value = value;
  out.direct = base::Vector::Zero(K);
  return out;
}

std::size_t front_material(const model::Model& model, const Discretisation& scene,
                           const FrontWithDomains& at) {
  const std::vector<base::ElementId> elements = at.fields.elements();
  return elements.empty()
             ? model.materials.size()
             : model.element_property(scene.cracked.mesh, elements.front()).material.index();
}

void note_all(results::StepResult& result, const std::string& text) {
  for (results::FrontResult& front : result.fronts) {
    front.sensitivities.notes.push_back(text);
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
  case_load_ = loads_with_supports(model_, scene_);
  const auto cases = static_cast<Eigen::Index>(model_.cases.size());
  of_loads_ = base::Matrix::Zero(scene_.k_layout().count(), cases);
  const Eigen::Index columns = std::max(cases, scene_.case_load.cols()); // that of ties, too
  const base::Vector still =
      base::Vector::Zero(3 * static_cast<Eigen::Index>(scene_.cracked.mesh.node_count()));
  for (Eigen::Index c = 0; c < cases; ++c) {
    const base::Vector one = base::Vector::Unit(columns, c);
    if (acts_on_fronts(model_, scene_, one)) {
      of_loads_.col(c) = front_K_values(model_, scene_, still, one);
    }
  }
  for (std::size_t c = 0; c < model_.cracks.size(); ++c) {
    if (model_.cracks[c].kind == model::CrackDefinitionKind::ellipse) {
      for (const EllipseAxis axis : {EllipseAxis::a, EllipseAxis::c}) {
        advances_.push_back(
            std::make_unique<VirtualAxisExtension>(model_, scene_, base::CrackId(c), axis));
      }
    }
  }
}

void FrontSensitivityAnalysis::add_loads(const FrozenContactStep& step, const FrontKFunctionals& K,
                                         std::vector<FrontParameterDerivative>& causes) const {
  for (std::size_t c = 0; c < model_.cases.size(); ++c) {
    const auto k = static_cast<Eigen::Index>(c);
    FrontParameterDerivative one =
        cause_of(results::SensitivityParameter::load, model_.cases[c].name,
                 step.solver.factors().case_factor[k], of_loads_.rows());
    one.load = case_load_.col(k);
    one.direct = of_loads_.col(k);
    const base::Vector given = scene_.case_displacement.col(k);
    // Prescribed displacements pull at the body, open rows and move nodes that K takes
    // (sensitivity.7).
    if ((given.array() != 0.0).any()) {
      one.gap.resize(static_cast<Eigen::Index>(scene_.table.size()));
      for (std::size_t r = 0; r < scene_.table.size(); ++r) {
        one.gap[static_cast<Eigen::Index>(r)] = row_opening(scene_.contact_row(r), 3, given);
      }
      one.direct += K.rows.transpose() * given;
    }
    causes.push_back(std::move(one));
  }
}

void FrontSensitivityAnalysis::add_fits(const FrozenContactStep& step,
                                        std::vector<FrontParameterDerivative>& causes) const {
  for (std::size_t c = 0; c < model_.contacts.size(); ++c) {
    const model::Contact& contact = model_.contacts[c];
    if (!contact.gap || !step.solver.factors().mounted[c]) {
      continue;
    }
    // An interference is a negative gap (sensitivity.7).
    const double interference = -*contact.gap * step.solver.factors().fit[c];
    FrontParameterDerivative one =
        cause_of(results::SensitivityParameter::fit, contact.name,
                 interference == 0.0 ? 0.0 : interference, of_loads_.rows());
    one.gap = base::Vector::Zero(static_cast<Eigen::Index>(scene_.table.size()));
    for (std::size_t i = 0; i < scene_.pairs[c].normal.size(); ++i) {
      one.gap[static_cast<Eigen::Index>(scene_.table.first[c] + i)] =
          -scene_.pairs[c].normal[i].area;
    }
    causes.push_back(std::move(one));
  }
}

void FrontSensitivityAnalysis::add_moduli(const FrozenContactStep& step, const FrontKFunctionals& K,
                                          std::vector<FrontParameterDerivative>& causes) const {
  // [dim * node, material] thermal loads less internal forces, f^T - K_m u (sensitivity.8).
  base::Matrix loads = -step.state.internal;
  if (step.state.temperature.size() > 0) {
    loads += estimate::thermal_loads(model_, scene_.cracked.mesh, step.state.temperature);
    for (const fe::ScaledTemperature& acting : acting_heat(scene_, step.state.case_factor)) {
      for (std::size_t m = 0; m < model_.materials.size(); ++m) {
        base::Vector f = base::Vector::Zero(loads.rows());
        fe::add_residual_load(model_, scene_.cracked.mesh, acting, base::MaterialId(m), f);
        loads.col(static_cast<Eigen::Index>(m)) += f;
      }
    }
  }
  // R^T u goes with the modulus at the front; of what loads add the difference to twice the modulus
  // shows what does.
  const base::Vector own = K.rows.transpose() * step.state.u;
  const crack::KLayout layout = scene_.k_layout();
  for (std::size_t m = 0; m < model_.materials.size(); ++m) {
    const double E = model_.materials[m].E;
    FrontParameterDerivative one = cause_of(results::SensitivityParameter::modulus,
                                            model_.materials[m].name, E, of_loads_.rows());
    one.load = loads.col(static_cast<Eigen::Index>(m)) / E;
    base::Vector constant = base::Vector::Zero(of_loads_.rows());
    if (acts_on_fronts(model_, scene_, step.state.case_factor)) {
      model::Model stiffer = model_;
      stiffer.materials[m].E *= 2.0;
      const base::Vector still = base::Vector::Zero(step.state.u.size());
      constant = front_K_values(stiffer, scene_, still, step.state.case_factor) -
                 front_K_values(model_, scene_, still, step.state.case_factor);
    }
    std::size_t first = 0;
    for (const FrontWithDomains& at : scene_.fronts) {
      const auto count = static_cast<Eigen::Index>(3 * at.front.points.size());
      if (front_material(model_, scene_, at) == m) {
        const Eigen::Index begin = layout.first_index(first);
        one.direct.segment(begin, count) =
            (own.segment(begin, count) + constant.segment(begin, count)) / E;
      }
      first += at.front.points.size();
    }
    causes.push_back(std::move(one));
  }
}

void FrontSensitivityAnalysis::add_lengths(const FrozenContactStep& step,
                                           const FrontKFunctionals& K,
                                           std::vector<FrontParameterDerivative>& causes,
                                           results::StepResult& result) const {
  for (const std::unique_ptr<VirtualAxisExtension>& advance : advances_) {
    const std::string why = advance->missing_reason(step);
    if (why.empty()) {
      causes.push_back(advance->axis_derivative(step, K));
      continue;
    }
    const std::string text = "no derivative by the axes of " + advance->crack_name() + ": " + why;
    for (results::FrontResult& front : result.fronts) {
      if (std::ranges::find(front.sensitivities.notes, text) == front.sensitivities.notes.end()) {
        front.sensitivities.notes.push_back(text);
      }
    }
  }
}

void FrontSensitivityAnalysis::solve(const FrozenContactStep& step, const FrontKFunctionals& K,
                                     const std::vector<FrontParameterDerivative>& causes,
                                     results::StepResult& result) const {
  const auto k = static_cast<Eigen::Index>(causes.size());
  const auto rows = static_cast<Eigen::Index>(scene_.table.size());
  base::Matrix loads = base::Matrix::Zero(step.state.u.size(), k);
  LoadAndGapRates rates;
  rates.gap = base::Matrix::Zero(rows, k);
  for (std::size_t i = 0; i < causes.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (causes[i].load.size() > 0) {
      loads.col(at) = causes[i].load;
    }
    if (causes[i].gap.size() > 0) {
      rates.gap.col(at) = causes[i].gap;
    }
  }
  const FrozenContactResponse change = step.system.solve_response(std::move(loads), rates.gap);
  if (!change.why_not.empty()) {
    note_all(result, change.why_not);
    return;
  }
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<std::array<double, 2>> reach(causes.size(), {-never, never});
  if (step.system.held_contact() != nullptr) {
    rates.free = change.free;
    reach = FrozenContact(step.solver, scene_, step.state)
                .linear_ranges(*step.system.held_contact(), rates);
  }
  const base::Matrix dK = K.rows.transpose() * change.u + K.of_force * change.force;
  std::size_t point = 0;
  for (results::FrontResult& front : result.fronts) {
    for (std::size_t i = 0; i < causes.size(); ++i) {
      results::FrontSensitivity one = causes[i].is;
      const auto at = static_cast<Eigen::Index>(i);
      for (std::size_t p = 0; p < front.points.size(); ++p) {
        const Eigen::Index first = scene_.k_layout().first_index(point + p);
        base::Vec3 own = dK.col(at).segment<3>(first) + causes[i].direct.segment<3>(first);
        own[0] = front.points[p].closed ? 0.0 : own[0]; // faces that touch hold K1 at 0
        one.below.push_back({own[0], own[1], own[2]});
      }
      one.above = one.below;
      // Ranges of moduli are not computed; without contact there is nothing to end any.
      if (one.cause != results::SensitivityParameter::modulus ||
          step.system.held_contact() == nullptr) {
        one.range = {one.value + reach[i][0], one.value + reach[i][1]};
      }
      front.sensitivities.of.push_back(std::move(one));
    }
    point += front.points.size();
  }
}

void FrontSensitivityAnalysis::add_to_fronts(const FrozenContactStep& step,
                                             const FrontKFunctionals& K,
                                             results::StepResult& result) {
  if (step.contact.rubs) {
    note_all(result, "contacts rub: the change of K depends on the load history");
    return;
  }
  if (step.solver.contact_system() != nullptr &&
      FrozenContact(step.solver, scene_, step.state).is_degenerate()) {
    note_all(result, "a pair is about to open or to close at this very state, where K has two "
                     "derivatives");
    return;
  }
  prepare();
  std::vector<FrontParameterDerivative> causes;
  add_loads(step, K, causes);
  add_fits(step, causes);
  if ((step.solver.mount_offset().array() != 0.0).any()) {
    note_all(result, "no derivatives by moduli: parts were mounted on deformed ones");
  } else {
    add_moduli(step, K, causes);
  }
  add_lengths(step, K, causes, result);
  solve(step, K, causes, result);
}

} // namespace spricka::analysis
