// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/mode_solver.hpp"

#include "base/index.hpp"
#include "model/model.hpp"

#include <algorithm>

namespace spricka::analysis {

namespace {

using base::index;

// Steps of conjugate gradients on the modes, and what part of the largest K may be left at the end.
constexpr int most_steps = 12;
constexpr double left_part = 4e-2;
// Residuals are multiples of each other to this part of them, as well as an engine that iterates
// can tell; so many are remembered.
constexpr double alike = 1e-6;
constexpr std::size_t remembered = 8;

// The largest K within the body.
double largest_inside(const Discretisation& scene, const base::Vector& K) {
  double size = 0.0;
  Eigen::Index first = 0;
  for (const mesh::CrackFront& front : scene.cracked.fronts) {
    for (const mesh::FrontPoint& point : front.points) {
      size = point.at_surface ? size : std::max(size, K.segment<3>(first).cwiseAbs().maxCoeff());
      first += 3;
    }
  }
  return size;
}

crack::SparseLinearFunctionals goal_rows(const estimate::SolidEnrichment& enrichment,
                                         const KFunctionals& K) {
  crack::SupplementaryFunctions others;
  others.count = enrichment.freedoms() / 3;
  others.of_element = [&](base::ElementId e) { return enrichment.element_modes(e); };
  others.signs = [&](base::ElementId e) { return enrichment.element_mode_signs(e); };
  others.slopes = [](base::ElementType type, const base::Vec3& r) {
    return estimate::SolidModes::for_type(type).dpsi(r);
  };
  return enrichment.free_mode_mask().asDiagonal() * K.of_supplementary(others);
}

} // namespace

/// Where the conjugate gradients of one step are.
struct CubicModeSolver::Iteration {
  ModeSolution& solution;
  base::Vector residual, direction;
  double size = 0.0;            ///< of the residual, by the preconditioner
  std::optional<double> before; ///< what the last step changed of K
};

CubicModeSolver::CubicModeSolver(const model::Model& model, const Discretisation& scene,
                                 const KFunctionals& K)
    : scene_(scene), enrichment_(model, scene.cracked.mesh, scene.cls, *scene.ties),
      goals_(goal_rows(enrichment_, K)) {}

std::vector<std::optional<base::Vector>>
CubicModeSolver::K_changes(const std::vector<const ModeLoad*>& steps, const KFunctionals& K) {
  std::vector<std::pair<std::shared_ptr<ModeSolution>, double>> answers; // [step] and its factor
  std::vector<ModeSolution*> unsolved;
  for (const ModeLoad* const step : steps) {
    const base::Vector& r = step->residual;
    const auto multiple_of = [&](const ModeLoad& of) {
      const double factor = r.dot(of.residual) / of.residual.squaredNorm();
      return (r - factor * of.residual).norm() <= alike * r.norm() && of.mounted == step->mounted &&
                     of.closed == step->closed
                 ? std::optional(factor)
                 : std::nullopt;
    };
    std::optional<double> factor;
    for (std::size_t i = 0; i < known_.size() && !factor; ++i) {
      factor = multiple_of(known_[i]->of);
      if (factor) {
        answers.emplace_back(known_[i], *factor);
      }
    }
    if (factor) {
      continue;
    }
    answers.emplace_back(std::make_shared<ModeSolution>(ModeSolution{*step, {}}), 1.0);
    unsolved.push_back(answers.back().first.get());
    if (r.squaredNorm() > 0.0) {
      known_.push_back(answers.back().first);
    }
  }
  solve(unsolved, K);
  std::vector<std::optional<base::Vector>> changes;
  changes.reserve(answers.size());
  for (const auto& [solution, factor] : answers) {
    changes.emplace_back();
    if (!solution->failed) {
      changes.back() = factor * solution->change;
    }
  }
  // Of the others only what they were is asked again.
  std::erase_if(known_, [](const auto& solution) { return solution->failed; });
  known_.erase(known_.begin(),
               known_.begin() + index(known_.size() - std::min(known_.size(), remembered)));
  for (const std::shared_ptr<ModeSolution>& solution : known_) {
    solution->of.system.reset();
  }
  return changes;
}

// One back-substitution for all steps (estimate.23).
CubicModeSolver::ModeResponses CubicModeSolver::respond(const std::vector<Iteration*>& steps,
                                                        const KFunctionals& K) const {
  const Eigen::Index count = index(steps.size());
  base::Matrix directions(enrichment_.freedoms(), count);
  ModeResponses out{.force = base::Matrix(enrichment_.freedoms(), count), .K = {}, .failed = {}};
  base::Matrix loads(K.of_displacements().rows(), count);
  std::vector<const FrozenContactSystem*> systems;
  for (Eigen::Index s = 0; s < count; ++s) {
    const Iteration& step = *steps[static_cast<std::size_t>(s)];
    base::Vector on_nodes;
    base::Vector on_modes;
    enrichment_.stiffness_product(step.direction, on_nodes, on_modes);
    directions.col(s) = step.direction;
    loads.col(s) = -on_nodes;
    out.force.col(s) = on_modes;
    systems.push_back(step.solution.of.system.get());
  }
  const FrozenStepResponses change =
      FrozenContactSystem::solve_responses(systems, std::move(loads));
  for (Eigen::Index s = 0; s < count; ++s) {
    const base::Vector v = change.u.col(s);
    out.force.col(s) += enrichment_.stiffness_forces_on_modes(&v, nullptr);
  }
  out.K = goals_.transpose() * directions + K.of_displacements().transpose() * change.u +
          K.of_contact_forces() * change.force;
  out.failed = change.failed;
  return out;
}

// Flexible, as the preconditioner is no matrix (Golub and Ye 1999).
bool CubicModeSolver::advance(Iteration& iteration, const base::Vector& force,
                              const base::Vector& K) const {
  const double energy = iteration.direction.dot(force);
  const double alpha = iteration.size / energy;
  const base::Vector more = alpha * K;
  base::Vector& change = iteration.solution.change;
  change += more;
  // What is left if changes go on to fall as the last two did: a geometric series.
  const double now = largest_inside(scene_, more);
  const double size = largest_inside(scene_, change);
  if (iteration.before && now * now <= left_part * size * (*iteration.before - now)) {
    return false;
  }
  iteration.before = now;
  iteration.residual -= alpha * force;
  const base::Vector s = enrichment_.apply_preconditioner(iteration.residual);
  iteration.direction = s - (s.dot(force) / energy) * iteration.direction;
  iteration.size = iteration.residual.dot(s);
  return iteration.size > 0.0;
}

void CubicModeSolver::solve(const std::vector<ModeSolution*>& steps, const KFunctionals& K) const {
  std::vector<std::unique_ptr<Iteration>> iterations;
  std::vector<Iteration*> active;
  for (ModeSolution* const step : steps) {
    step->change = base::Vector::Zero(K.of_displacements().cols());
    base::Vector s = enrichment_.apply_preconditioner(step->of.residual);
    const double size = step->of.residual.dot(s);
    if (size > 0.0) {
      iterations.push_back(std::make_unique<Iteration>(
          Iteration{*step, step->of.residual, std::move(s), size, std::nullopt}));
      active.push_back(iterations.back().get());
    }
  }
  for (int i = 0; i < most_steps && !active.empty(); ++i) {
    const ModeResponses response = respond(active, K);
    std::vector<Iteration*> next;
    for (std::size_t s = 0; s < active.size(); ++s) {
      active[s]->solution.failed = response.failed[s];
      if (!response.failed[s] &&
          advance(*active[s], response.force.col(index(s)), response.K.col(index(s)))) {
        next.push_back(active[s]);
      }
    }
    active = std::move(next);
  }
}

} // namespace spricka::analysis
