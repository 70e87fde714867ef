// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/adjoints.hpp"

#include "analysis/scene/front_functionals.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

namespace spricka::analysis {

namespace {

// What K may feel of a motion that nothing holds, over all it feels: quadrature leaves 1e-7.
constexpr double felt_motion = 1e-4;

// Zero loads in the shape that condense_load() gives: a body that no K feels needs no half solve.
CondensedLoad no_load(const SubstructuredBody& body, Eigen::Index columns) {
  CondensedLoad load;
  load.region = base::Matrix::Zero(body.region.map.size(), columns);
  for (const std::unique_ptr<Substructure>& part : body.parts) {
    load.part.emplace_back(base::Matrix::Zero(part->map.size(), columns));
  }
  load.external = base::Matrix::Zero(body.contact_unknowns(), columns);
  return load;
}

bool touches(const fe::Body& body, int dim, const base::Matrix& nodal) {
  return std::ranges::any_of(body.nodes, [&](base::NodeId n) {
    return (nodal.middleRows(static_cast<Eigen::Index>(n.index()) * dim, dim).array() != 0.0).any();
  });
}

} // namespace

KAdjoints::KAdjoints(const model::Model& model, const Discretisation& scene,
                     const std::vector<SubstructuredBody>& bodies)
    : model_(model), scene_(scene), bodies_(bodies) {}

void KAdjoints::condense_rows() {
  const crack::KLayout layout = scene_.k_layout();
  base::Matrix nodal(K_rows(model_, scene_));
  for (std::size_t t = 0; t < layout.points(); ++t) {
    rows_.emplace_back(layout.columns(nodal, t));
  }
  by_force_ = K_by_forces(model_, scene_).transpose();
  scene_.ties->transfer_to_masters(nodal);
  for (const SubstructuredBody& body : bodies_) {
    condensed_.push_back(touches(body.body, scene_.cracked.mesh.dim, nodal)
                             ? condense_load(body, *scene_.ties, nodal)
                             : no_load(body, nodal.cols()));
  }
}

std::vector<estimate::IntensityAdjoint>
KAdjoints::solve_closed_set(const StepSolver& solver, const std::vector<bool>& closed,
                            const contact::FixedActiveSet* held) {
  if (rows_.empty()) {
    condense_rows();
  }
  const crack::KLayout layout = scene_.k_layout();
  const Eigen::Index columns = layout.count();
  std::vector<base::Matrix> external(bodies_.size());
  base::Matrix w = base::Matrix::Zero(static_cast<Eigen::Index>(closed.size()), columns);
  std::string why_not;
  if (held != nullptr && !held->is_consistent()) {
    why_not = "the closed contacts contradict each other";
  } else if (held != nullptr) {
    if (free_.u.empty()) {
      for (const std::size_t b : solver.condensed_bodies()) {
        external_.push_back(condensed_[b].external);
      }
      free_ = contact::unconstrained_response(*solver.contact_system(), external_);
    }
    // K has a term of the forces between faces, for which z leaves a gap there (sensitivity.13).
    const contact::FixedActiveSet::ActiveSetResponse found =
        held->solve_response(free_.opening + by_force_, free_.on_mode);
    double size = 0.0;
    for (const base::Matrix& load : external_) {
      size = std::max(size, load.cwiseAbs().maxCoeff());
    }
    if (found.left_over > felt_motion * size) {
      why_not = "K depends on a motion that no closed contact holds";
    }
    // (sensitivity.3) and (sensitivity.4): w on the closed rows, z on the externals.
    w = found.force;
    std::vector<base::Matrix> u = held->displacement(external_, found);
    for (std::size_t i = 0; i < u.size(); ++i) {
      external[solver.condensed_bodies()[i]] = std::move(u[i]);
    }
  }
  base::Matrix z = base::Matrix::Zero(rows_.front().rows(), columns);
  for (std::size_t b = 0; b < bodies_.size() && why_not.empty(); ++b) {
    // z is a change of displacements: constants of ties have no part in it.
    recover_body(bodies_[b], external[b], condensed_[b], 0.0, z);
  }
  std::vector<estimate::IntensityAdjoint> out(rows_.size());
  for (std::size_t t = 0; t < rows_.size(); ++t) {
    out[t].why_not = why_not;
    out[t].rows = rows_[t];
    out[t].by_force = layout.columns(by_force_, t);
    out[t].closed = closed;
    if (!why_not.empty()) {
      continue;
    }
    out[t].z = layout.columns(z, t);
    out[t].w = layout.columns(w, t);
  }
  return out;
}

ClosedContactRows closed_rows(const StepSolver& solver, const Discretisation& scene) {
  ClosedContactRows rows;
  rows.closed.assign(scene.table.size(), false);
  if (solver.contact_system() != nullptr) {
    const contact::ContactSystem::IncrementProblem problem = solver.contact_problem();
    rows.rubs = !problem.friction.empty();
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
      // A next problem would begin with the rows that the last one ended with.
      rows.closed[problem.rows[i]] = problem.start.empty() ? problem.equality[i] : problem.start[i];
    }
  }
  return rows;
}

std::unique_ptr<contact::FixedActiveSet> constrain_rows(const StepSolver& solver,
                                                        const std::vector<bool>& closed) {
  if (solver.contact_system() == nullptr) {
    return nullptr;
  }
  std::vector<std::size_t> rows;
  for (std::size_t r = 0; r < closed.size(); ++r) {
    if (closed[r]) {
      rows.push_back(r);
    }
  }
  return std::make_unique<contact::FixedActiveSet>(*solver.contact_system(), std::move(rows));
}

const std::vector<estimate::IntensityAdjoint>&
KAdjoints::solve_last_step(const StepSolver& solver) {
  const std::size_t count = scene_.cracked.fronts.size();
  const auto [closed, rubs] = closed_rows(solver, scene_);
  if (rubs) {
    held_.reset();
    last_.assign(count, {});
    for (estimate::IntensityAdjoint& adjoint : last_) {
      adjoint.why_not = depends_on_history;
    }
  } else if (count > 0 &&
             (last_.empty() || !last_.front().is_available() || last_.front().closed != closed)) {
    held_ = constrain_rows(solver, closed);
    last_ = solve_closed_set(solver, closed, held_.get());
  }
  return last_;
}

} // namespace spricka::analysis
