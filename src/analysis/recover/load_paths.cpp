// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/load_paths.hpp"

#include "analysis/recover/closed_run.hpp"
#include "analysis/recover/path_functions.hpp"
#include "analysis/scene/free_faces.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "analysis/steps/history_program.hpp"
#include "contact/slave_places.hpp"
#include "crack/stress_intensity.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

std::string why_stopped(const solve::SolutionPath& found, const StepSolver& solver) {
  switch (found.status) {
  case solve::PathStatus::complete:
    return {};
  case solve::PathStatus::unheld_mode:
    return solver.describe_unsupported_motion(found.unheld);
  case solve::PathStatus::no_start:
    return "the loads and fits at its beginning have no solution";
  case solve::PathStatus::inconsistent:
    return "bonded contacts contradict each other";
  case solve::PathStatus::unfinished:
    return fmt::format("the pivots did not come to an end ({})", found.pivots);
  case solve::PathStatus::drift:
    break;
  }
  return "round-off grew too large: the contact is nearly singular";
}

// The part of the gaps of these rows [rows] that neither fits nor loads scale.
base::Vector gap_without_fits_and_loads(const model::Model& model, const Discretisation& scene,
                                        const base::Vector& offset,
                                        const std::vector<std::size_t>& rows) {
  base::Vector rest(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t r = rows[i];
    const auto c = scene.table.contact_index(r);
    const base::ContactId contact(c);
    // A declared gap that no step names has the factor 1 on all of the path: nothing scales it.
    const bool scaled = scene.contacts[c].gap && is_fit_set_by_steps(model, contact);
    rest[static_cast<Eigen::Index>(i)] =
        offset[static_cast<Eigen::Index>(r)] + (scaled ? 0.0 : scene.contact_row(r).gap);
  }
  return rest;
}

// Whether all that a path begins with is scaled by its factors.
bool is_homogeneous(const model::Model& model, const Discretisation& scene,
                    const LoadPathEndStep& from, const LoadPathEndStep& to,
                    const base::Vector& gap_offset_at_mounting) {
  // The right-hand side of a tie has no factor (solve.33).
  if (scene.ties->has_constants()) {
    return false;
  }
  // What no factor of the steps scales: gaps without FIT, or left over from a MOUNT.
  const base::Vector rest =
      gap_without_fits_and_loads(model, scene, gap_offset_at_mounting, from.problem.rows);
  const double size =
      std::max(from.problem.gap.size() > 0 ? from.problem.gap.cwiseAbs().maxCoeff() : 0.0,
               to.problem.gap.size() > 0 ? to.problem.gap.cwiseAbs().maxCoeff() : 0.0);
  return rest.size() == 0 || rest.cwiseAbs().maxCoeff() <= 1e-12 * size;
}

// Contacts on a path that begins or goes by at `end`: their closed ranges, and what changes.
void follow_contacts(const Discretisation& scene, const solve::SolutionPath& found,
                     const LoadPathEndStep& end, results::LoadPathResult& path) {
  const std::vector<std::size_t>& rows = end.problem.rows;
  std::size_t first = 0; // of a contact among the rows in force
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    std::size_t last = first;
    // Rows in force stand in the order of the table; of a pair the normal ones come first.
    while (last < rows.size() && rows[last] < scene.table.first[c + 1]) {
      ++last;
    }
    const contact::PairConstraints& pair = scene.pairs[c];
    const std::size_t normal = std::min(pair.normal.size(), last - first);
    if (normal == 0) {
      continue; // not mounted
    }
    results::LoadPathContact contact;
    contact.name = scene.contacts[c].name;
    contact.round = contact::uses_angular_coordinate(pair);
    contact.rows = static_cast<int>(normal);
    std::unordered_map<std::int32_t, double> place_of;
    for (const results::ContactPoint& p : end.result.contacts[c].points) {
      place_of[p.node.value] = contact.round ? p.theta : p.arc;
    }
    std::vector<double> place;
    std::vector<bool> closed;
    for (std::size_t i = 0; i < normal; ++i) {
      place.push_back(place_of[pair.normal[i].node.value]);
      closed.push_back(found.closed[first + i]);
    }
    const LongestClosedContactRange run(place, contact.round);
    auto change = found.changes.begin();
    for (std::size_t k = 0; k < found.segments.size(); ++k) {
      // Changes of a segment happen at its beginning.
      for (; change != found.changes.end() && change->segment == k; ++change) {
        const auto row = static_cast<std::size_t>(change->row);
        if (row < first || row >= first + normal) {
          continue;
        }
        closed[row - first] = change->closes;
        const double t = found.segments[k].from;
        path.changes.push_back(
            {t, contact.name, pair.normal[row - first].node, place[row - first], change->closes});
        if (!change->closes && !contact.opening) {
          contact.opening = t;
        }
      }
      const auto [from, to] = run.find(closed);
      contact.from.push_back(from);
      contact.to.push_back(to);
      contact.closed.push_back(static_cast<int>(std::ranges::count(closed, true)));
    }
    // A value for each knot: one more than there are segments.
    contact.from.push_back(contact.from.back());
    contact.to.push_back(contact.to.back());
    contact.closed.push_back(contact.closed.back());
    path.contacts.push_back(std::move(contact));
    first = last;
  }
  std::ranges::stable_sort(path.changes, {}, &results::ContactStatusChange::t);
}

// Whether a row of the table is one between the faces of a crack.
bool between_faces(const Discretisation& scene, std::size_t row) {
  return std::ranges::any_of(scene.crack_face_pairs, [&](const auto& crack_face) {
    return crack_face && row >= scene.table.first[crack_face->pair] &&
           row < scene.table.first[crack_face->pair + 1];
  });
}

} // namespace

LoadPathSolver::LoadPathSolver(const model::Model& model, const Discretisation& scene,
                               const std::vector<SubstructuredBody>& bodies, const KFunctionals& K)
    : model_(model), scene_(scene), functionals_(model, scene, bodies, K) {}

void LoadPathSolver::store_step_end_state(std::size_t step, const StepSolver& solver,
                                          const results::LoadStepResult& result) {
  const bool wanted =
      std::ranges::any_of(model_.load_paths, [&](const model::LoadPathDefinition& path) {
        return path.from.index() == step || path.to.index() == step;
      });
  if (!wanted) {
    return;
  }
  LoadPathEndStep& end = ends_[step];
  if (solver.contact_system() != nullptr) {
    end.problem = solver.contact_problem();
  }
  end.case_factor = solver.factors().case_factor;
  end.result.fronts = result.fronts;
  // A step that was taken over is corrected already; K of a path is, as a whole, at the end.
  for (results::FrontResult& front : end.result.fronts) {
    std::ranges::for_each(front.points, results::put_back_raw_K);
  }
  end.result.contacts = result.contacts;
}

solve::ParametricProblem
LoadPathSolver::parametric_path_problem(const model::LoadPathDefinition& card,
                                        const StepSolver& solver) {
  const LoadPathEndStep& from = ends_.at(card.from.index());
  const LoadPathEndStep& to = ends_.at(card.to.index());
  solve::ParametricProblem p;
  p.f0 = functionals_.evaluate_without_contact(from.case_factor, solver);
  p.df = functionals_.evaluate_without_contact(to.case_factor, solver) - p.f0;
  if (solver.contact_system() == nullptr) {
    p.at_zero.W.resize(0, 0);
    p.at_zero.B.resize(0, 0);
    p.of_force.resize(p.f0.size(), 0);
    p.of_mode.resize(p.f0.size(), 0);
    return p;
  }
  p.at_zero = solver.contact_system()->condense_problem(from.problem);
  const solve::ContactProblem at_one = solver.contact_system()->condense_problem(to.problem);
  p.db = at_one.b - p.at_zero.b;
  p.dh = at_one.h - p.at_zero.h;
  // One end may be without load: the larger scale serves all of the path.
  p.at_zero.load_scale = std::max(from.problem.load_scale, to.problem.load_scale);
  const auto n = static_cast<Eigen::Index>(from.problem.rows.size());
  p.of_force.resize(p.f0.size(), n);
  const ContactAndRigidModeFunctionals& by = functionals_.contact_functionals(solver);
  p.of_mode = by.of_mode;
  if (p.f0.size() == 0) {
    p.of_mode.resize(0, p.dh.size());
  }
  for (Eigen::Index i = 0; i < n && p.f0.size() > 0; ++i) {
    p.of_force.col(i) =
        by.of_row.col(static_cast<Eigen::Index>(from.problem.rows[static_cast<std::size_t>(i)]));
  }
  return p;
}

results::LoadPathResult LoadPathSolver::path(const model::LoadPathDefinition& card,
                                             const StepSolver& solver) {
  const LoadPathEndStep& from = ends_.at(card.from.index());
  const LoadPathEndStep& to = ends_.at(card.to.index());
  results::LoadPathResult out;
  out.name = card.name;
  out.from = model_.steps[card.from.index()].name;
  out.to = model_.steps[card.to.index()].name;
  if (depends_on_load_order(model_)) {
    out.stopped = "with friction K depends on the way, so that there is no map: the growth follows "
                  "its loads one after another";
    return out;
  }
  const solve::ParametricProblem posed = parametric_path_problem(card, solver);
  solve::SolutionPath found;
  if (posed.db.size() > 0 || posed.dh.size() > 0) {
    solve::SolutionPathSettings settings;
    settings.start.max_block_iterations = model_.control.max_iterations;
    found = solve::follow_solution_path(posed, 0.0, card.beyond, settings, from.problem.start);
  } else { // no contact: one line
    found.segments.push_back({0.0, card.beyond, posed.f0, posed.df});
    found.end = card.beyond;
  }
  out.pivots = found.pivots;
  out.factorisations = found.factorisations;
  out.residual = found.residual;
  out.stopped = why_stopped(found, solver);
  if (!out.stopped.empty()) {
    out.notes.push_back(results::invalid_result_note(
        fmt::format("it ends at t = {:.6g} of {:.6g}: {}", found.end, card.beyond, out.stopped)));
  }
  if (found.segments.empty()) {
    return out;
  }
  for (const double t : found.jumps) {
    out.notes.push_back(
        results::make_note(fmt::format("at t = {:.6g} nothing holds a body: it moves until contact "
                                       "stops it, which changes no K",
                                       t)));
  }
  out.t = path_knots(found);
  out.homogeneous = is_homogeneous(model_, scene_, from, to, solver.gap_offset_at_mounting());
  // Between knots all is linear: the largest overlaps are at knots.
  for (const solve::SolutionPathSegment& s : found.segments) {
    functionals_.add_overlapping_crack_lines(s.value, overlapping_);
    functionals_.add_overlapping_crack_lines(s.value + (s.to - s.from) * s.slope, overlapping_);
  }
  add_front_K_to_path(model_, scene_, found, from, to, out);
  follow_contacts(scene_, found, from, out);
  return out;
}

base::Vector
LoadPathSolver::evaluate_increment_K(const contact::ContactSystem::IncrementProblem& problem,
                                     const contact::ContactSystem::IncrementSolution& solution,
                                     const StepSolver& solver) {
  base::Vector value = functionals_.evaluate_increment(problem, solution, solver);
  functionals_.add_overlapping_crack_lines(value, overlapping_);
  base::Vector free; // without the forces between faces of cracks, all others as they are
  if (scene_.has_tips() && continues_K_below_closing(model_)) {
    free = value;
    const base::Matrix& of_row = functionals_.contact_functionals(solver).of_row;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
      if (between_faces(scene_, problem.rows[i])) {
        free -= of_row.col(static_cast<Eigen::Index>(problem.rows[i])) *
                solution.contact.lambda[static_cast<Eigen::Index>(i)];
      }
    }
  }
  smooth_K_on_all_fronts(scene_, value);
  zero_K1_at_closed_points(scene_, problem.rows, solution.contact.closed, value);
  const crack::KLayout layout = scene_.k_layout();
  for (std::size_t t = 0; t < layout.points() && free.size() > 0; ++t) {
    if (free[layout.at(t, 1)] < 0.0) {
      layout.segment_of_point(value, t) = layout.segment_of_point(free, t);
    }
  }
  return value.head(layout.count());
}

std::vector<results::LoadPathResult> LoadPathSolver::solve_paths(const StepSolver& solver) {
  std::vector<results::LoadPathResult> out;
  for (const model::LoadPathDefinition& card : model_.load_paths) {
    out.push_back(path(card, solver));
  }
  return out;
}

} // namespace spricka::analysis
