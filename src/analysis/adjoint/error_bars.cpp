// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/error_bars.hpp"

#include "analysis/adjoint/active_set_change.hpp"
#include "analysis/adjoint/coarse_surface_effect.hpp"
#include "crack/tip_intensity.hpp"
#include "estimate/corner_error.hpp"
#include "estimate/error_bar.hpp"
#include "estimate/mode_load.hpp"
#include "estimate/point_support.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Errors that cancel are worth a note where the bar is more than a thousandth of K: ten times its
// floor.
constexpr double counts = 10.0;
// A node that is held singly gives way by as much again each time its elements halve (estimate.18).
// Where so many halvings change K by more than its bar there is no bar, as an endlessly fine mesh
// has no K.
constexpr double halvings = 4.0;

// Freedoms of nodes that supports, ties or closed contacts hold.
std::vector<bool> fixed_freedoms(const Discretisation& scene, const StepState& state) {
  std::vector<bool> fixed(scene.cls.size(), false);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    fixed[i] =
        scene.cls[i] != model::FreedomRole::local && scene.cls[i] != model::FreedomRole::external;
  }
  // Followers are dependent by their class; here come their masters.
  for (const fe::ConstraintTransformation::DependentRow& row : scene.ties->rows()) {
    for (const fe::FreedomTerm& term : row.terms) {
      fixed[static_cast<std::size_t>(term.freedom)] = true;
    }
  }
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    const std::vector<contact::ConstraintRow>& rows = scene.pairs[c].normal;
    for (std::size_t r = 0; state.mounted[c] && r < rows.size(); ++r) {
      for (const contact::RowEntry& entry : rows[r].entries) {
        if (state.pair_closed[c][r]) {
          fixed[2 * entry.node.index()] = fixed[2 * entry.node.index() + 1] = true;
        }
      }
    }
  }
  return fixed;
}

// What singular corners add to the errors; what supports of single nodes do to K.
estimate::PointSupportRefinementChange
add_corners(const model::Model& model, const Discretisation& scene, const StepState& state,
            const estimate::CornerErrorRequest& request, std::vector<estimate::GoalError>& errors) {
  const std::vector<base::NodeId> front_nodes = scene.cracked.front_nodes();
  const std::vector<bool> tied = nodes_held_by_other_bodies({model, scene, state});
  const estimate::CornerSearchInput setting{.model = model,
                                            .mesh = scene.cracked.mesh,
                                            .edges = request.enrichment.edges(),
                                            .cls = scene.cls,
                                            .ties = *scene.ties,
                                            .front_nodes = front_nodes,
                                            .tied = &tied};
  const std::vector<estimate::SingularCorner> corners = estimate::find_singular_corners(setting);
  estimate::correct_corner_errors(request, corners, errors);
  return estimate::point_support_refinement_change(setting, corners, state.reaction,
                                                   request.goal.z);
}

// K that is 0 whatever the mesh has no bar: K1 where faces touch, both where nothing loads the
// body.
void clear_exact(std::size_t elements, results::FrontPointResult& tip) {
  const bool unloaded = tip.G == 0.0 && tip.K1 == 0.0 && tip.K2 == 0.0 && !tip.closed;
  for (std::size_t k = 0; k < 2; ++k) {
    if (unloaded || (tip.closed && k == 0)) {
      tip.bar[k] = {};
      tip.bar[k].of_element.assign(elements, 0.0);
    }
  }
}

// Why an endlessly fine mesh has no K of tip t; empty: it has.
std::string why_no_limit(const Discretisation& scene,
                         const estimate::PointSupportRefinementChange& giving, std::size_t t,
                         const results::FrontPointResult& tip) {
  for (std::size_t k = 0; k < 2 && giving.node.valid(); ++k) {
    const double bar = tip.bar[k].size();
    const double change = giving.change[scene.k_layout().at(t, static_cast<int>(k) + 1)];
    if (bar > 0.0 && halvings * change > bar) {
      const base::Vec3& x = scene.cracked.mesh.x[giving.node.index()];
      return fmt::format("it depends on how fine the mesh is at ({:.6g}, {:.6g}), where a single "
                         "node is held and stresses have no bound: hold a side instead",
                         x.x(), x.y());
    }
  }
  return {};
}

} // namespace

TipErrorBars::TipErrorBars(const model::Model& model, const Discretisation& scene,
                           estimate::ModeMatrixCache* memory)
    : ErrorBarsBase(model, scene), memory_(memory) {}

void TipErrorBars::prepare() {
  prepared_ = true;
  const model::Mesh& mesh = scene_.cracked.mesh;
  why_not_ = estimate::enrichment_obstacle(model_, mesh);
  if (!why_not_.empty()) {
    return;
  }
  estimate::EdgeTable edges = estimate::make_edge_table(mesh);
  std::vector<bool> framed(edges.edges.size(), false);
  for (const contact::PairConstraints& pair : scene_.pairs) {
    contact_edges_.push_back(estimate::contact_edges_of_pair(edges, pair));
    std::vector<bool> alone(2 * edges.edges.size(), false);
    for (const estimate::ContactEdge& edge : contact_edges_.back()) {
      framed[edge.edge] = true;
      // Only normal modes of target edges that lie opposite none feel the multipliers
      // (estimate.14): elsewhere modes are shared (estimate.10) or held.
      alone[2 * edge.edge] = edge.target_side && !edge.opposite;
    }
    mode_weights_.push_back(estimate::target_mode_weights(edges, pair));
    std::erase_if(mode_weights_.back(),
                  [&](const estimate::ContactModeWeight& w) { return !alone[w.freedom]; });
  }
  enrichment_.emplace(model_, mesh, std::move(edges), std::move(framed),
                      estimate::ModeMatrixLookup{memory_, &scene_.cracked.host});
  supports_ = estimate::find_mode_supports(*enrichment_, scene_.cls, *scene_.ties);
  const crack::KLayout layout = scene_.k_layout();
  goals_.resize(enrichment_->freedoms(), layout.count());
  for (std::size_t t = 0; t < scene_.cracked.fronts.size(); ++t) {
    const mesh::CrackFront& front = scene_.cracked.fronts[t];
    layout.point_columns(goals_, t) =
        enrichment_->mode_functional(crack::K_functional_at_quadrature_points(
            model_, scene_.cracked, front, scene_.domains[t].points.front(),
            model_.cracks[front.crack.index()].state));
  }
}

estimate::ModeFreedomMap TipErrorBars::modes(const StepState& state) const {
  std::vector<estimate::ClosedContactEdge> closed;
  for (std::size_t c = 0; c < contact_edges_.size(); ++c) {
    if (state.mounted[c]) {
      const bool bonded =
          c < model_.contacts.size() && model_.contacts[c].type == model::ContactType::bonded;
      estimate::add_closed_edges(contact_edges_[c], scene_.pairs[c], state.pair_closed[c], bonded,
                                 closed);
    }
  }
  return estimate::map_mode_freedoms(*enrichment_, supports_, closed);
}

// What the multipliers do to the modes of target edges that lie opposite none: of the solution, and
// of the adjoints.
void TipErrorBars::add_pressures(const StepState& state, const StressIntensityAdjoints& adjoint,
                                 base::Vector& f, base::Matrix& g) const {
  for (std::size_t c = 0; c < mode_weights_.size(); ++c) {
    for (const estimate::ContactModeWeight& m : mode_weights_[c]) {
      if (!state.mounted[c]) {
        continue;
      }
      const auto mode = static_cast<Eigen::Index>(m.freedom);
      f[mode] += m.weight * state.pair_lambda[c][static_cast<Eigen::Index>(m.row)];
      g.row(mode) +=
          m.weight * adjoint.w.row(static_cast<Eigen::Index>(scene_.table.first[c] + m.row));
    }
  }
}

// Nodes of a contact that the crack feels stand further apart than half its length.
bool TipErrorBars::coarse_contact(const StepState& state, const mesh::CrackFront& front) const {
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    if (!state.mounted[c]) {
      continue;
    }
    const auto near_and_coarse = [&](const contact::Edge& edge) {
      // A quadratic edge has a node in its middle.
      const double spacing = 0.5 * edge.length;
      const double reach = 2.0 * front.a + 0.5 * edge.length;
      const base::Vec2 middle = contact::point_on_edge(edge, 0.0);
      return spacing > 0.5 * front.a && (middle - front.tip_point().x.head<2>()).norm() < reach;
    };
    if (std::ranges::any_of(scene_.pairs[c].contact.plane.edges, near_and_coarse) ||
        std::ranges::any_of(scene_.pairs[c].target.plane.edges, near_and_coarse)) {
      return true;
    }
  }
  return false;
}

// Where many edges have none opposite (a crack's mouth makes a few) what the mesh misses of the
// normal displacement is not seen.
void TipErrorBars::tell_of_meshes(const StepState& state, results::LoadStepResult& step) {
  for (std::size_t c = 0; c < contact_edges_.size() && c < model_.contacts.size(); ++c) {
    std::size_t paired = 0;
    std::size_t apart = 0;
    for (const estimate::ContactEdge& edge : contact_edges_[c]) {
      paired += !edge.target_side && edge.covered ? 1 : 0;
      apart += !edge.target_side && edge.covered && !edge.opposite ? 1 : 0;
    }
    if (state.mounted[c] && 4 * apart > paired && !scene_.pairs[c].rigid) {
      add_note_once(
          results::make_note(fmt::format("the meshes of contact {} do not match: error bars of K "
                                         "have only a part of the error of its pressures",
                                         model_.contacts[c].name)),
          step);
    }
  }
}

void TipErrorBars::tell_of_cancelling(const results::FrontResult& front,
                                      results::LoadStepResult& step) {
  for (std::size_t k = 0; k < 2; ++k) {
    const results::KErrorBar& bar = front.single_point().bar[k];
    if (bar.cancels && bar.mesh > counts * bar.floor) {
      add_note_once(
          results::make_note(fmt::format("K{} of {}: errors of opposite sign cancel in it; its "
                                         "error bar uses their absolute values",
                                         k + 1, front.name)),
          step);
    }
  }
}

/// What the bars of all tips at the end of a step are made of.
struct TipErrorBars::StepErrors {
  std::vector<estimate::GoalError> goal; ///< by the layout
  ContactEdgeKChange set_change;
  estimate::PointSupportRefinementChange giving;
};

TipErrorBars::StepErrors TipErrorBars::step_errors(const StepState& state,
                                                   const StressIntensityAdjoints& adjoint,
                                                   const contact::FixedActiveSet* held) {
  base::Vector f = sum_case_loads(state.case_factor, enrichment_->freedoms(), [&](std::size_t c) {
    return estimate::mode_load(*enrichment_, model_.cases[c], *scene_.case_heat[c]);
  });
  base::Matrix g = goals_;
  add_pressures(state, adjoint, f, g);
  const estimate::ModeFreedomMap map = modes(state);
  const estimate::GoalErrorInput request{.u = state.u, .z = adjoint.z, .load = f, .goals = g};
  StepErrors errors;
  errors.goal = estimate::estimate_goal_errors(*enrichment_, map, request);
  errors.giving =
      add_corners(model_, scene_, state,
                  {*enrichment_, map, request, fixed_freedoms(scene_, state)}, errors.goal);
  errors.set_change = active_set_K_changes(scene_, state, adjoint, held);
  return errors;
}

void TipErrorBars::estimate_bars(const StepState& state, const StepErrors& errors, std::size_t t,
                                 results::FrontResult& front, results::LoadStepResult& step) {
  if (scene_.domains[t].empty()) {
    front.missing_bar_reason = "there is no domain that K could be taken from";
    return;
  }
  const bool coarse = coarse_contact(state, scene_.cracked.fronts[t]);
  if (coarse) {
    add_note_once(results::make_note(fmt::format(
                      "{}: nodes of a contact surface near the crack are further apart than half "
                      "the crack's length; the error bar uses the absolute values of the errors",
                      front.name)),
                  step);
  }
  results::FrontPointResult& tip = front.single_point();
  const estimate::ErrorBarUse use{
      .coarse = coarse,
      .corrected = corrects_K(model_),
      .closes = scene_.crack_face_pairs[scene_.cracked.fronts[t].crack.index()].has_value()};
  for (const int mode : {1, 2}) {
    const Eigen::Index at = scene_.k_layout().at(t, mode);
    tip.bar[static_cast<std::size_t>(mode - 1)] = estimate::error_bar(
        scene_.cracked.mesh, mode == 1 ? tip.K1 : tip.K2, std::hypot(tip.K1, tip.K2),
        errors.goal[static_cast<std::size_t>(at)],
        {.end = errors.set_change.ends[at], .sharp = errors.set_change.sharp[at]}, use);
  }
  clear_exact(scene_.cracked.mesh.element_count(), tip);
  front.missing_bar_reason = why_no_limit(scene_, errors.giving, t, tip);
  if (!front.missing_bar_reason.empty()) {
    add_note_once(results::invalid_result_note(
                      fmt::format("K of {}: {}", front.name, front.missing_bar_reason)),
                  step);
    return;
  }
  if (std::max(tip.bar[0].size(), tip.bar[1].size()) > 0.0) {
    // What bodies beside the tip do that are too coarse for it.
    const CoarseNeighbourEffect effect = estimate_coarse_neighbour_effect(
        {model_, scene_, state, &enrichment_->edges()}, scene_.cracked.fronts[t]);
    front.missing_bar_reason = effect.why_not;
    for (results::KErrorBar& bar : tip.bar) {
      bar.mesh += bar.size() > 0.0 ? effect.part * std::hypot(tip.K1, tip.K2) : 0.0;
    }
  }
  if (!front.missing_bar_reason.empty()) {
    add_note_once(
        results::less_exact_note(fmt::format("K of {}: {}", front.name, front.missing_bar_reason)),
        step);
    return;
  }
  tell_of_cancelling(front, step);
}

void TipErrorBars::add_to_tips(const StepState& state, const StressIntensityAdjoints& adjoint,
                               const contact::FixedActiveSet* held, results::LoadStepResult& step) {
  if (!prepared_) {
    prepare();
  }
  const std::string& why_not = why_not_.empty() ? adjoint.why_not : why_not_;
  StepErrors errors;
  if (why_not.empty()) {
    errors = step_errors(state, adjoint, held);
    tell_of_meshes(state, step);
  }
  assign_error_bars(why_not, step, [&](std::size_t t, std::size_t, results::FrontResult& front) {
    estimate_bars(state, errors, t, front, step);
  });
}

} // namespace spricka::analysis
