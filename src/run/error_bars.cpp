// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/error_bars.hpp"

#include "crack/stress_intensity.hpp"
#include "estimate/error_bar.hpp"
#include "estimate/mode_load.hpp"
#include "run/contact_flip.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::run {

namespace {

// Errors that cancel are worth a warning where the bar is more than a thousandth of K: ten times
// its floor.
constexpr double counts = 10.0;

} // namespace

ErrorBars::ErrorBars(const model::Model& model, const Scene& scene, estimate::ModeMemory* memory)
    : model_(model), scene_(scene), memory_(memory) {}

bool ErrorBars::is_bonded(std::size_t contact) const {
  return contact < model_.contacts.size() &&
         model_.contacts[contact].type == model::ContactType::bonded;
}

void ErrorBars::prepare() {
  prepared_ = true;
  const model::Mesh& mesh = scene_.cracked.mesh;
  why_not_ = estimate::not_enriched(model_, mesh);
  if (!why_not_.empty()) {
    return;
  }
  estimate::EdgeTable edges = estimate::find_edges(mesh);
  std::vector<bool> framed(edges.edges.size(), false);
  for (const contact::PairRows& pair : scene_.pairs) {
    contact_edges_.push_back(estimate::contact_edges(edges, pair));
    std::vector<bool> alone(2 * edges.edges.size(), false);
    for (const estimate::ContactEdge& edge : contact_edges_.back()) {
      framed[edge.edge] = true;
      alone[2 * edge.edge] = edge.target_side && !edge.opposite;
    }
    mode_weights_.push_back(estimate::target_mode_weights(edges, pair));
    std::erase_if(mode_weights_.back(),
                  [&](const estimate::ModeWeight& w) { return !alone[w.freedom]; });
  }
  enrichment_.emplace(model_, mesh, std::move(edges), std::move(framed),
                      estimate::KeptModes{memory_, &scene_.cracked.host});
  supports_ = estimate::mode_supports(*enrichment_, scene_.cls, *scene_.ties);
  case_load_.resize(model_.cases.size());
  goals_.resize(enrichment_->freedoms(), 2 * static_cast<Eigen::Index>(scene_.cracked.tips.size()));
  for (std::size_t t = 0; t < scene_.cracked.tips.size(); ++t) {
    const mesh::Tip& tip = scene_.cracked.tips[t];
    goals_.middleCols(2 * static_cast<Eigen::Index>(t), 2) = enrichment_->functional(
        crack::intensity_points(model_, scene_.cracked, tip, scene_.tips[t].fields,
                                model_.cracks[tip.crack.index()].state));
  }
}

base::Vector ErrorBars::load(const base::Vector& case_factor) {
  base::Vector f = base::Vector::Zero(enrichment_->freedoms());
  for (std::size_t c = 0; c < case_load_.size(); ++c) {
    const double factor = case_factor[static_cast<Eigen::Index>(c)];
    if (factor == 0.0) {
      continue;
    }
    if (!case_load_[c]) {
      case_load_[c] = estimate::mode_load(*enrichment_, model_.cases[c], scene_.case_heat[c].get());
    }
    f += factor * *case_load_[c];
  }
  return f;
}

estimate::ModeMap ErrorBars::modes(const StepState& state) const {
  std::vector<estimate::ClosedEdge> closed;
  for (std::size_t c = 0; c < contact_edges_.size(); ++c) {
    if (state.mounted[c]) {
      const bool bonded = is_bonded(c);
      estimate::add_closed(contact_edges_[c], scene_.pairs[c], state.pair_closed[c], bonded,
                           closed);
    }
  }
  return estimate::mode_map(*enrichment_, supports_, closed);
}

// What the multipliers do to the modes of target edges that lie opposite none: of the solution, and
// of the adjoints.
void ErrorBars::add_pressures(const StepState& state,
                              const std::vector<estimate::Adjoint>& adjoints, base::Vector& f,
                              base::Matrix& g) const {
  for (std::size_t c = 0; c < mode_weights_.size(); ++c) {
    for (const estimate::ModeWeight& m : mode_weights_[c]) {
      if (!state.mounted[c]) {
        continue;
      }
      const auto mode = static_cast<Eigen::Index>(m.freedom);
      f[mode] += m.weight * state.pair_lambda[c][static_cast<Eigen::Index>(m.row)];
      for (std::size_t t = 0; t < adjoints.size(); ++t) {
        g.row(mode).segment<2>(2 * static_cast<Eigen::Index>(t)) +=
            m.weight * adjoints[t].w.row(static_cast<Eigen::Index>(scene_.table.first[c] + m.row));
      }
    }
  }
}

// Nodes of a contact that the crack feels stand further apart than half its length.
bool ErrorBars::coarse_contact(const StepState& state, const mesh::Tip& tip) const {
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    if (!state.mounted[c]) {
      continue;
    }
    const auto near_and_coarse = [&](const contact::Edge* edge) {
      const double spacing = 0.5 * edge->length;
      const double reach = 2.0 * tip.a + 0.5 * edge->length;
      const base::Vec2 middle = contact::point_on(*edge, 0.0);
      return spacing > 0.5 * tip.a && (middle - tip.x.head<2>()).norm() < reach;
    };
    if (std::ranges::any_of(contact::edges_of(scene_.pairs[c].contact), near_and_coarse) ||
        std::ranges::any_of(contact::edges_of(scene_.pairs[c].target), near_and_coarse)) {
      return true;
    }
  }
  return false;
}

void ErrorBars::tell_once(const std::string& text, results::StepResult& step) {
  if (std::ranges::find(told_, text) == told_.end()) {
    told_.push_back(text);
    step.notes.push_back(text);
  }
}

// Where many edges have none opposite (a crack's mouth makes a few) what the mesh misses of the
// normal displacement is not seen.
void ErrorBars::tell_of_meshes(const StepState& state, results::StepResult& step) {
  for (std::size_t c = 0; c < contact_edges_.size() && c < model_.contacts.size(); ++c) {
    std::size_t paired = 0;
    std::size_t apart = 0;
    for (const estimate::ContactEdge& edge : contact_edges_[c]) {
      paired += !edge.target_side && edge.covered ? 1 : 0;
      apart += !edge.target_side && edge.covered && !edge.opposite ? 1 : 0;
    }
    if (state.mounted[c] && 4 * apart > paired && !scene_.pairs[c].rigid) {
      tell_once(
          fmt::format("the meshes of contact {} do not match: error bars of K have only a part "
                      "of the error of its pressures",
                      model_.contacts[c].name),
          step);
    }
  }
}

void ErrorBars::tell(const results::TipResult& tip, results::StepResult& step) {
  if (!tip.no_bar.empty()) {
    tell_once(fmt::format("K of {} has no error bar: {}", tip.name, tip.no_bar), step);
    return;
  }
  for (std::size_t k = 0; k < 2; ++k) {
    if (tip.bar[k].cancels && tip.bar[k].mesh > counts * tip.bar[k].floor) {
      tell_once(
          fmt::format("warning: K{} of {}: errors of opposite sign cancel in it; its error bar "
                      "takes them without their signs",
                      k + 1, tip.name),
          step);
    }
  }
}

void ErrorBars::add(const StepState& state, const std::vector<estimate::Adjoint>& adjoints,
                    const contact::HeldContact* held, results::StepResult& step) {
  if (!prepared_) {
    prepare();
  }
  std::string why_not = why_not_;
  for (const estimate::Adjoint& adjoint : adjoints) {
    why_not = why_not.empty() ? adjoint.why_not : why_not;
  }
  std::vector<estimate::GoalError> errors;
  std::vector<ContactFlips> flips;
  if (why_not.empty()) {
    base::Matrix z(state.u.size(), goals_.cols());
    for (std::size_t t = 0; t < adjoints.size(); ++t) {
      z.middleCols(2 * static_cast<Eigen::Index>(t), 2) = adjoints[t].z;
    }
    base::Vector f = load(state.case_factor);
    base::Matrix g = goals_;
    add_pressures(state, adjoints, f, g);
    errors = estimate::goal_errors(*enrichment_, modes(state), {state.u, z, f, g});
    flips = contact_flips(scene_, state, adjoints, held);
    tell_of_meshes(state, step);
  }
  for (std::size_t t = 0; t < step.tips.size(); ++t) {
    results::TipResult& tip = step.tips[t];
    tip.no_bar = tip.doubt.empty() ? why_not : tip.doubt;
    if (tip.no_bar.empty() && scene_.tips[t].fields.empty()) {
      tip.no_bar = "there is no domain that K could be taken from";
    }
    if (tip.no_bar.empty()) {
      const bool coarse = coarse_contact(state, scene_.cracked.tips[t]);
      if (coarse) {
        tell_once(
            fmt::format(
                "warning: {}: nodes of a contact surface near the crack stand further apart "
                "than half the crack's length; the error bar takes errors without their signs",
                tip.name),
            step);
      }
      const std::array<const estimate::GoalError*, 2> own{&errors[2 * t], &errors[2 * t + 1]};
      const std::array<double, 2> K{tip.K1, tip.K2};
      const ContactFlips& flip = flips[t];
      const std::array<estimate::ErrorBar, 2> bars = estimate::error_bars(
          scene_.cracked.mesh, K, own,
          {estimate::Flip{flip.ends[0], flip.sharp[0]}, {flip.ends[1], flip.sharp[1]}}, coarse);
      for (std::size_t k = 0; k < 2; ++k) {
        tip.bar[k] = {own[k]->eta,  own[k]->sum,     flip.ends[static_cast<Eigen::Index>(k)],
                      bars[k].mesh, bars[k].edge,    bars[k].floor,
                      bars[k].best, bars[k].cancels, own[k]->of_element};
      }
      if (tip.closed) {
        tip.bar[0] = {}; // K1 is 0, whatever the mesh
        tip.bar[0].of_element.assign(scene_.cracked.mesh.element_count(), 0.0);
      }
    }
    tell(tip, step);
  }
}

} // namespace spricka::run
