// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/load_paths.hpp"

#include "analysis/recover/closed_run.hpp"
#include "analysis/recover/path_functions.hpp"
#include "analysis/scene/front_surroundings.hpp"
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

// Functionals that are condensed at a time.
constexpr Eigen::Index most_columns = 64;

std::string why_stopped(const solve::SolutionPath& found, const StepSolver& solver) {
  switch (found.status) {
  case solve::PathStatus::complete:
    return {};
  case solve::PathStatus::unheld_mode:
    return solver.unsupported_motion(found.unheld);
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

} // namespace

LoadPathSolver::LoadPathSolver(const model::Model& model, const Discretisation& scene,
                               const std::vector<SubstructuredBody>& bodies)
    : model_(model), scene_(scene), bodies_(bodies), watches_(watch_faces(model, scene)) {}

void LoadPathSolver::record_step(std::size_t step, const StepSolver& solver,
                                 const results::StepResult& result) {
  const bool wanted =
      std::ranges::any_of(model_.load_paths, [&](const model::LoadPathDefinition& path) {
        return path.from.index() == step || path.to.index() == step;
      });
  if (!wanted) {
    return;
  }
  LoadPathEnd& end = ends_[step];
  if (solver.contact_system() != nullptr) {
    end.problem = solver.contact_problem();
  }
  end.case_factor = solver.factors().case_factor;
  end.result.fronts = result.fronts;
  end.result.contacts = result.contacts;
}

LoadPathSolver::ContactForceFunctionals LoadPathSolver::functionals(const StepSolver& solver) {
  const Eigen::Index count = functional_count();
  ContactForceFunctionals out;
  if (solver.contact_system() == nullptr || count == 0) {
    return out;
  }
  K_rows_ = displacement_K_functionals(model_, scene_);
  const contact::ContactSystem& system = *solver.contact_system();
  Eigen::Index modes = 0;
  for (const std::size_t b : solver.condensed_bodies()) {
    modes += bodies_[b].condensed->modes().cols();
  }
  const auto rows = static_cast<Eigen::Index>(scene_.table.size());
  out.of_row.resize(count, rows);
  out.of_mode.resize(count, modes);
  for (Eigen::Index first = 0; first < count;) {
    base::Matrix nodal = functional_columns(first, most_columns);
    // A functional is condensed as a load is (solve.32).
    scene_.ties->transfer_forces_to_masters(nodal);
    std::vector<base::Matrix> external;
    std::vector<base::Matrix> moved;
    for (const std::size_t b : solver.condensed_bodies()) {
      external.push_back(condense_load(bodies_[b], *scene_.ties, nodal).external);
      moved.push_back(bodies_[b].condensed->displacements_under_forces(external.back()));
    }
    for (Eigen::Index k = 0; k < nodal.cols(); ++k) {
      std::vector<base::Vector> u;
      for (std::size_t i = 0; i < moved.size(); ++i) {
        u.emplace_back(moved[i].col(k));
        const base::Matrix& Q = bodies_[solver.condensed_bodies()[i]].condensed->modes();
        out.of_mode.row(first + k).segment(system.first_mode(i), Q.cols()) =
            external[i].col(k).transpose() * Q;
      }
      for (Eigen::Index r = 0; r < rows; ++r) {
        out.of_row(first + k, r) = system.opening(static_cast<std::size_t>(r), u);
      }
    }
    first += nodal.cols();
  }
  // Between faces in contact a unit of a row changes K without moving anything, too (crack.33).
  out.of_row.topRows(first_watched()) += contact_force_K_functionals(model_, scene_);
  return out;
}

// K and faces of the bodies alone, without contact forces and rigid motions.
base::Vector LoadPathSolver::free_values(const base::Vector& case_factor) const {
  base::Vector u = scene_.case_displacement * case_factor;
  for (const SubstructuredBody& body : bodies_) {
    base::Vector external;
    if (body.condensed) {
      external = body.condensed->displacements_under_forces(body.external_load * case_factor);
    }
    recover_body(body, external, case_factor, u);
  }
  base::Vector values(functional_count());
  values.head(first_watched()) = evaluate_K_values(model_, scene_, u, case_factor);
  values.tail(2 * static_cast<Eigen::Index>(watches_.size())) = watched(u);
  return values;
}

solve::ParametricProblem LoadPathSolver::problem(const LoadPathEnd& from, const LoadPathEnd& to,
                                                 const StepSolver& solver) const {
  solve::ParametricProblem p;
  p.f0 = free_values(from.case_factor);
  p.df = free_values(to.case_factor) - p.f0;
  if (solver.contact_system() == nullptr) {
    p.at_zero.W.resize(0, 0);
    p.at_zero.B.resize(0, 0);
    p.of_force.resize(p.f0.size(), 0);
    p.of_mode.resize(p.f0.size(), 0);
    return p;
  }
  p.at_zero = solver.contact_system()->condensed(from.problem);
  const solve::ContactProblem at_one = solver.contact_system()->condensed(to.problem);
  p.db = at_one.b - p.at_zero.b;
  p.dh = at_one.h - p.at_zero.h;
  // One end may be without load: the larger scale serves all of the path.
  p.at_zero.load_scale = std::max(from.problem.load_scale, to.problem.load_scale);
  const auto n = static_cast<Eigen::Index>(from.problem.rows.size());
  p.of_force.resize(p.f0.size(), n);
  p.of_mode = rows_->of_mode;
  if (p.f0.size() == 0) {
    p.of_mode.resize(0, p.dh.size());
  }
  for (Eigen::Index i = 0; i < n && p.f0.size() > 0; ++i) {
    p.of_force.col(i) = rows_->of_row.col(
        static_cast<Eigen::Index>(from.problem.rows[static_cast<std::size_t>(i)]));
  }
  return p;
}

bool LoadPathSolver::homogeneous(const LoadPathEnd& from, const LoadPathEnd& to,
                                 const StepSolver& solver) const {
  // The right-hand side of a tie has no factor (solve.33).
  if (scene_.ties->has_constants()) {
    return false;
  }
  // What no factor of the steps scales: gaps without FIT, or left over from a MOUNT.
  const base::Vector rest = solver.gap_without_fits_and_loads(from.problem.rows);
  const double size =
      std::max(from.problem.gap.size() > 0 ? from.problem.gap.cwiseAbs().maxCoeff() : 0.0,
               to.problem.gap.size() > 0 ? to.problem.gap.cwiseAbs().maxCoeff() : 0.0);
  return rest.size() == 0 || rest.cwiseAbs().maxCoeff() <= 1e-12 * size;
}

void LoadPathSolver::contacts(const solve::SolutionPath& found, const LoadPathEnd& end,
                              results::LoadPathResult& path) const {
  const std::vector<std::size_t>& rows = end.problem.rows;
  std::size_t first = 0; // of a contact among the rows in force
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    std::size_t last = first;
    // Rows in force stand in the order of the table; of a pair the normal ones come first.
    while (last < rows.size() && rows[last] < scene_.table.first[c + 1]) {
      ++last;
    }
    const contact::PairConstraints& pair = scene_.pairs[c];
    const std::size_t normal = std::min(pair.normal.size(), last - first);
    if (normal == 0) {
      continue; // not mounted
    }
    results::LoadPathContact contact;
    contact.name = scene_.contacts[c].name;
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
    const LongestClosedRange run(place, contact.round);
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

solve::ParametricProblem
LoadPathSolver::parametric_path_problem(const model::LoadPathDefinition& card,
                                        const StepSolver& solver) {
  if (!rows_) {
    rows_ = functionals(solver);
  }
  return problem(ends_.at(card.from.index()), ends_.at(card.to.index()), solver);
}

results::LoadPathResult LoadPathSolver::path(const model::LoadPathDefinition& card,
                                             const StepSolver& solver) {
  const LoadPathEnd& from = ends_.at(card.from.index());
  const LoadPathEnd& to = ends_.at(card.to.index());
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
        results::note(fmt::format("at t = {:.6g} nothing holds a body: it moves until contact "
                                  "stops it, which changes no K",
                                  t)));
  }
  out.t = path_knots(found);
  out.homogeneous = homogeneous(from, to, solver);
  look_at_faces(found);
  fronts(found, from, to, out);
  contacts(found, from, out);
  return out;
}

std::vector<results::LoadPathResult> LoadPathSolver::solve_paths(const StepSolver& solver) {
  std::vector<results::LoadPathResult> out;
  for (const model::LoadPathDefinition& card : model_.load_paths) {
    out.push_back(path(card, solver));
  }
  return out;
}

} // namespace spricka::analysis
