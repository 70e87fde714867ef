// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_bars.hpp"

#include "analysis/adjoint/bar_along_front.hpp"
#include "analysis/adjoint/coarse_surface_effect.hpp"
#include "analysis/adjoint/front_edges.hpp"
#include "base/parallel.hpp"
#include "contact/space_tractions.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

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

crack::SparseLinearFunctionals goal_rows(const model::Model& model, const Discretisation& scene,
                                         const estimate::SolidEnrichment& enrichment) {
  crack::SupplementaryFunctions others;
  others.count = enrichment.freedoms() / 3;
  others.of_element = [&](base::ElementId e) { return enrichment.element_modes(e); };
  others.signs = [&](base::ElementId e) { return enrichment.element_mode_signs(e); };
  others.slopes = [](base::ElementType type, const base::Vec3& r) {
    return estimate::SolidModes::for_type(type).dpsi(r);
  };
  const crack::KLayout layout = scene.k_layout();
  std::vector<Eigen::Triplet<double>> entries;
  std::size_t first = 0;
  std::vector<crack::SparseLinearFunctionals> of_front(scene.cracked.fronts.size());
  base::parallel_for_ranges(of_front.size(), 1, [&](std::size_t f, std::size_t) {
    of_front[f] = crack::supplementary_K_functionals(model, scene.cracked, scene.cracked.fronts[f],
                                                     scene.domains[f], others);
  });
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    const mesh::CrackFront& front = scene.cracked.fronts[f];
    const crack::SparseLinearFunctionals& own = of_front[f];
    for (Eigen::Index c = 0; c < own.cols(); ++c) {
      for (crack::SparseLinearFunctionals::InnerIterator it(own, c); it; ++it) {
        entries.emplace_back(it.row(), layout.first_mode_index(first) + c,
                             it.value() * enrichment.free_mode_mask()[it.row()]);
      }
    }
    first += front.points.size();
  }
  crack::SparseLinearFunctionals rows(enrichment.freedoms(), layout.count());
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

// Whether rows at a sharp edge of a contact do so much to K of a front that no mesh tells what the
// singular pressure there does (manual, error_bar.md).
bool hangs_on_an_edge(const ContactEdgeKChange& edges, Eigen::Index first,
                      const results::FrontResult& front) {
  constexpr double too_much = 0.2; // of the largest K
  double size = 0.0;
  double most = 0.0;
  Eigen::Index at = first;
  for (const results::FrontPointResult& place : front.points) {
    if (!place.at_surface) {
      size = std::max(size, std::hypot(place.K1, place.K2, place.K3));
      most = std::max(most, edges.sharp.segment<3>(at).maxCoeff());
    }
    at += 3;
  }
  return most > too_much * size;
}

} // namespace

FrontErrorBars::FrontErrorBars(const model::Model& model, const Discretisation& scene)
    : ErrorBarsBase(model, scene) {}

void FrontErrorBars::prepare() {
  prepared_ = true;
  why_not_ = estimate::solid_enrichment_obstacle(model_, scene_.cracked.mesh);
  for (const contact::PairConstraints& pair : scene_.pairs) {
    if (!pair.segments && !pair.normal.empty()) {
      why_not_ = "a contact is one of single nodes (PAIRING=NODE)";
    }
  }
  if (!why_not_.empty()) {
    return;
  }
  enrichment_.emplace(model_, scene_.cracked.mesh, scene_.cls, *scene_.ties);
  goals_ = goal_rows(model_, scene_, *enrichment_);
}

base::Vector FrontErrorBars::load(const StepState& state) {
  base::Vector f = sum_case_loads(state.case_factor, enrichment_->freedoms(), [&](std::size_t c) {
    return enrichment_->distributed_load(model_.cases[c], *scene_.case_heat[c]);
  });
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    if (state.mounted[c]) {
      enrichment_->add_tractions(
          contact::solid_pair_tractions(scene_.pairs[c], state.pair_lambda[c],
                                        [](const model::Face&) { return true; }),
          f);
    }
  }
  return f;
}

std::optional<base::Vector> FrontErrorBars::changes(const FrozenContactStep& step,
                                                    const KFunctionals& K) {
  const base::Vector r =
      load(step.state) - enrichment_->stiffness_forces_on_modes(&step.state.u, nullptr);
  base::Vector start; // of a step that mounts or opens something where no force is
  for (const ReusableFrontEstimate& one : known_) {
    const double factor = r.dot(one.residual) / one.residual.squaredNorm();
    if ((r - factor * one.residual).norm() <= alike * r.norm()) {
      if (one.mounted == step.state.mounted && one.closed == step.contact.closed) {
        return factor * one.solution.eta;
      }
      start = factor * one.solution.modes;
    }
  }
  std::optional<ModeSolution> found = solve(step, K, r, std::move(start));
  if (!found) {
    return std::nullopt;
  }
  base::Vector eta = found->eta;
  if (r.squaredNorm() > 0.0) {
    if (known_.size() == remembered) {
      known_.erase(known_.begin());
    }
    known_.push_back({step.state.mounted, step.contact.closed, r, std::move(*found)});
  }
  return eta;
}

// One back-substitution (estimate.23).
std::optional<FrontErrorBars::ModeResponse>
FrontErrorBars::respond(const FrozenContactStep& step, const KFunctionals& K,
                        const base::Vector& modes) const {
  ModeResponse out;
  base::Vector on_nodes;
  enrichment_->stiffness_product(modes, on_nodes, out.force);
  const FrozenContactResponse change = step.system.solve_response(-on_nodes, {});
  if (!change.why_not.empty()) {
    return std::nullopt;
  }
  const base::Vector v = change.u.col(0);
  out.force += enrichment_->stiffness_forces_on_modes(&v, nullptr);
  out.K = goals_.transpose() * modes + K.of_displacements().transpose() * v +
          K.of_contact_forces() * change.force.col(0);
  return out;
}

// Conjugate gradients on the modes with the nodes eliminated, flexible as their preconditioner is
// no matrix (Golub and Ye 1999).
std::optional<FrontErrorBars::ModeSolution> FrontErrorBars::solve(const FrozenContactStep& step,
                                                                  const KFunctionals& K,
                                                                  base::Vector r,
                                                                  base::Vector start) const {
  ModeSolution found{base::Vector::Zero(r.size()), base::Vector::Zero(K.of_displacements().cols())};
  std::optional<double> before; // what the last step changed of K
  if (start.size() > 0) {
    const std::optional<ModeResponse> of_start = respond(step, K, start);
    if (!of_start) {
      return std::nullopt;
    }
    r -= of_start->force;
    before = largest_inside(scene_, of_start->K);
    found = {std::move(start), of_start->K};
  }
  base::Vector s = enrichment_->apply_preconditioner(r);
  base::Vector p = s;
  double rs = r.dot(s);
  for (int i = 0; i < most_steps && rs > 0.0; ++i) {
    const std::optional<ModeResponse> response = respond(step, K, p);
    if (!response) {
      return std::nullopt;
    }
    const double energy = p.dot(response->force);
    const double alpha = rs / energy;
    const base::Vector more = alpha * response->K;
    found.modes += alpha * p;
    found.eta += more;
    // What is left if changes go on to fall as the last two did: a geometric series.
    const double now = largest_inside(scene_, more);
    const double size = largest_inside(scene_, found.eta);
    if (before && now * now <= left_part * size * (*before - now)) {
      break;
    }
    before = now;
    r -= alpha * response->force;
    s = enrichment_->apply_preconditioner(r);
    p = s - (s.dot(response->force) / energy) * p;
    rs = r.dot(s);
  }
  return found;
}

void FrontErrorBars::estimate_bars(const StepState& state, const base::Vector& eta,
                                   const ContactEdgeKChange& edges, std::size_t f,
                                   std::size_t first_point, results::FrontResult& front,
                                   results::LoadStepResult& result) const {
  const crack::KLayout layout = scene_.k_layout();
  const Eigen::Index first = layout.first_mode_index(first_point);
  if (hangs_on_an_edge(edges, first, front)) {
    front.missing_bar_reason =
        "it hangs on the pressure at the edge of a body that ends near the front";
    return;
  }
  base::Vector better = eta;
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    const results::FrontPointResult& place = front.points[i];
    const Eigen::Index at = layout.first_mode_index(first_point + i);
    better.segment<3>(at) += base::Vec3(place.K1, place.K2, place.K3);
    better[at] = place.closed ? 0.0 : better[at];
  }
  const mesh::CrackFront& is = scene_.cracked.fronts[f];
  const CoarseNeighbourEffect coarse =
      estimate_coarse_neighbour_effect({model_, scene_, state}, is);
  add_front_error_bars(eta, smooth_K_along_front(is, scene_.domains[f], better, first), edges,
                       first, coarse.part,
                       {.corrected = corrects_K(model_),
                        .closes = scene_.crack_face_pairs[is.crack.index()].has_value()},
                       front);
  if (!coarse.why_not.empty()) {
    result.notes.push_back(
        results::less_exact_note(fmt::format("K of {}: {}", front.name, coarse.why_not)));
  }
}

void FrontErrorBars::add_to_fronts(const FrozenContactStep& step, const KFunctionals& K,
                                   results::LoadStepResult& result) {
  if (!prepared_) {
    prepare();
  }
  std::string reason = why_not_.empty() && step.contact.rubs ? depends_on_history : why_not_;
  std::optional<base::Vector> eta;
  if (reason.empty()) {
    eta = changes(step, K);
    reason = eta ? "" : "what closed contacts hold gives way";
  }
  ContactEdgeKChange edges;
  if (reason.empty()) {
    edges = contact_edge_K_changes(scene_, step, K);
  }
  assign_error_bars(reason, result,
                    [&](std::size_t f, std::size_t first_point, results::FrontResult& front) {
                      estimate_bars(step.state, *eta, edges, f, first_point, front, result);
                    });
}

} // namespace spricka::analysis
