// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/load_paths.hpp"

#include "analysis/recover/path_functions.hpp"
#include "analysis/scene/free_faces.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "analysis/steps/crack_face_overlap.hpp"
#include "analysis/steps/history_program.hpp"
#include "analysis/steps/row_opening.hpp"
#include "contact/crack_face_pairing.hpp"
#include "model/model.hpp"

#include <algorithm>

/// Faces of cracks on load paths.
namespace spricka::analysis {

namespace {

// Whether a row of the table is one between the faces of a crack.
bool between_faces(const Discretisation& scene, std::size_t row) {
  return std::ranges::any_of(scene.crack_face_pairs, [&](const auto& crack_face) {
    return crack_face && row >= scene.table.first[crack_face->pair] &&
           row < scene.table.first[crack_face->pair + 1];
  });
}

} // namespace

std::vector<LoadPathSolver::FaceNodePair> LoadPathSolver::watch_faces(const model::Model& model,
                                                                      const Discretisation& scene) {
  std::vector<FaceNodePair> watches;
  if (!scene.has_tips()) {
    return watches; // in space steps say where faces overlap
  }
  const bool wanted = !model.load_paths.empty() || depends_on_load_order(model);
  for (std::size_t i = 0; i < scene.cracked.faces.size() && wanted; ++i) {
    // Faces that are a pair already cannot overlap; FREE ones may.
    if (!model.cracks[i].faces_in_contact || scene.crack_face_pairs[i]) {
      continue;
    }
    contact::PairConstraints pair = contact::build_crack_face_constraints(
        model, scene.cracked.mesh, scene.cracked.faces[i], true);
    for (std::size_t r = 0; r < pair.normal.size(); ++r) {
      FaceNodePair& watch = watches.emplace_back(FaceNodePair{i, std::move(pair.normal[r]), {}});
      if (!pair.tangent.empty()) {
        watch.along = std::move(pair.tangent[r]);
      }
    }
  }
  return watches;
}

base::Matrix LoadPathSolver::functional_columns(Eigen::Index first, Eigen::Index most) const {
  const auto size =
      static_cast<Eigen::Index>(scene_.cracked.mesh.node_count()) * scene_.cracked.mesh.dim;
  const Eigen::Index K = first_watched();
  if (first < K) {
    return base::Matrix(K_rows_.middleCols(first, std::min(most, K - first)));
  }
  const Eigen::Index columns = std::min(most, functional_count() - first);
  base::Matrix nodal = base::Matrix::Zero(size, columns);
  for (Eigen::Index c = 0; c < columns; ++c) {
    const FaceNodePair& watch = watches_[static_cast<std::size_t>((first + c - K) / 2)];
    const bool along = (first + c - K) % 2 == 1;
    if (along && !watch.along) {
      continue;
    }
    const contact::ConstraintRow& row = along ? *watch.along : watch.apart;
    for (const contact::RowEntry& entry : row.entries) {
      // Over the area of the row its opening is a length.
      nodal.col(c).segment<2>(2 * static_cast<Eigen::Index>(entry.node.index())) +=
          entry.weight.head<2>() / row.area;
    }
  }
  return nodal;
}

base::Vector LoadPathSolver::watched(const base::Vector& u) const {
  base::Vector values = base::Vector::Zero(2 * static_cast<Eigen::Index>(watches_.size()));
  for (std::size_t w = 0; w < watches_.size(); ++w) {
    const FaceNodePair& watch = watches_[w];
    const auto at = 2 * static_cast<Eigen::Index>(w);
    values[at] = row_opening(watch.apart, 2, u) / watch.apart.area;
    if (watch.along) {
      values[at + 1] = row_opening(*watch.along, 2, u) / watch.along->area;
    }
  }
  return values;
}

void LoadPathSolver::look_at_faces(const base::Vector& value) {
  const Eigen::Index K = first_watched();
  for (std::size_t w = 0; w < watches_.size();) {
    const std::size_t line = watches_[w].line;
    std::vector<double> overlap; // along the face
    double largest = 0.0;
    for (; w < watches_.size() && watches_[w].line == line; ++w) {
      const base::Vec2 apart = value.segment<2>(K + 2 * static_cast<Eigen::Index>(w));
      overlap.push_back(std::max(0.0, -apart[0]));
      largest = std::max(largest, apart.norm());
    }
    // As for a step (touching_lines): of the largest displacement of the faces against each other.
    if (resolved_overlap(overlap) > overlap_of_round_off * largest &&
        std::ranges::find(touching_, line) == touching_.end()) {
      touching_.push_back(line);
    }
  }
}

// Between knots all is linear: the largest overlaps are at knots.
void LoadPathSolver::look_at_faces(const solve::SolutionPath& found) {
  for (const solve::SolutionPathSegment& s : found.segments) {
    look_at_faces(s.value);
    look_at_faces(base::Vector(s.value + (s.to - s.from) * s.slope));
  }
}

base::Vector LoadPathSolver::evaluate_K(const contact::ContactSystem::IncrementProblem& problem,
                                        const contact::ContactSystem::IncrementSolution& solution,
                                        const StepSolver& solver) {
  if (!rows_) {
    rows_ = functionals(solver);
  }
  if (of_case_.cols() == 0) {
    of_case_.resize(functional_count(), scene_.case_load.cols());
    for (Eigen::Index c = 0; c < of_case_.cols(); ++c) {
      // Bodies alone are linear in the factors: unit cases now, a product in each increment.
      of_case_.col(c) = free_values(base::Vector::Unit(of_case_.cols(), c));
    }
  }
  base::Vector value = of_case_ * solver.factors().case_factor;
  value += rows_->of_mode * solution.contact.alpha;
  for (std::size_t i = 0; i < problem.rows.size(); ++i) {
    value += rows_->of_row.col(static_cast<Eigen::Index>(problem.rows[i])) *
             solution.contact.lambda[static_cast<Eigen::Index>(i)];
  }
  look_at_faces(value);
  base::Vector free; // without the forces between faces of cracks, all others as they are
  if (scene_.has_tips() && continues_K_below_closing(model_)) {
    free = value;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
      if (between_faces(scene_, problem.rows[i])) {
        free -= rows_->of_row.col(static_cast<Eigen::Index>(problem.rows[i])) *
                solution.contact.lambda[static_cast<Eigen::Index>(i)];
      }
    }
  }
  smooth_fronts(value);
  close_points(problem, solution, value);
  const crack::KLayout layout = scene_.k_layout();
  for (std::size_t t = 0; t < layout.points() && free.size() > 0; ++t) {
    if (free[layout.at(t, 1)] < 0.0) {
      layout.point_entries(value, t) = layout.point_entries(free, t);
    }
  }
  return value.head(layout.count());
}

// What the mesh finds a little below 0 for faces in contact is 0, as in steps (judge_faces).
void LoadPathSolver::smooth_fronts(base::Vector& value) const {
  const crack::KLayout layout = scene_.k_layout();
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene_.cracked.fronts.size(); ++f) {
    const mesh::CrackFront& front = scene_.cracked.fronts[f];
    if (front.is_tip()) {
      continue;
    }
    const bool bear = scene_.crack_face_pairs[front.crack.index()].has_value();
    const auto smooth =
        smooth_K_along_front(front, scene_.domains[f], value, layout.first_index(first));
    for (const std::array<double, 3>& K : smooth) {
      layout.point_entries(value, first++) << (bear ? std::max(0.0, K[0]) : K[0]), K[1], K[2];
    }
  }
}

// Faces that touch do not part there: what is left is the error of the mesh.
void LoadPathSolver::close_points(const contact::ContactSystem::IncrementProblem& problem,
                                  const contact::ContactSystem::IncrementSolution& solution,
                                  base::Vector& value) const {
  const crack::KLayout layout = scene_.k_layout();
  std::size_t first = 0;
  for (std::size_t f = 0; f < scene_.cracked.fronts.size(); ++f) {
    const std::vector<std::optional<std::size_t>> rows = rows_behind(f, problem.rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i] && solution.contact.closed[*rows[i]]) {
        value[layout.at(first + i, 1)] = 0.0;
      }
    }
    first += scene_.cracked.fronts[f].points.size();
  }
}

} // namespace spricka::analysis
