// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/front_bars.hpp"

#include "analysis/adjoint/bar_along_front.hpp"
#include "analysis/adjoint/front_edges.hpp"
#include "contact/space_tractions.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

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

void FrontErrorBars::prepare(const KFunctionals& K) {
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
  modes_ = std::make_unique<CubicModeSolver>(model_, scene_, K);
}

base::Vector FrontErrorBars::load(const StepState& state) {
  const estimate::SolidEnrichment& enrichment = modes_->enrichment();
  base::Vector f = sum_case_loads(state.case_factor, enrichment.freedoms(), [&](std::size_t c) {
    return enrichment.distributed_load(model_.cases[c], *scene_.case_heat[c]);
  });
  for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
    if (state.mounted[c]) {
      enrichment.add_tractions(
          contact::solid_pair_tractions(scene_.pairs[c], state.pair_lambda[c],
                                        [](const model::Face&) { return true; }),
          f);
    }
  }
  return f;
}

UnfinishedFrontBars FrontErrorBars::begin(const FrozenContactStep& step,
                                          std::shared_ptr<const FrozenContactSystem> system,
                                          const KFunctionals& K) {
  if (!prepared_) {
    prepare(K);
  }
  UnfinishedFrontBars bars;
  bars.why_not = why_not_.empty() && step.contact.rubs ? depends_on_history : why_not_;
  if (!bars.why_not.empty()) {
    return bars;
  }
  const StepState& state = step.state;
  bars.load = {.residual =
                   load(state) - modes_->enrichment().stiffness_forces_on_modes(&state.u, nullptr),
               .mounted = state.mounted,
               .closed = step.contact.closed,
               .system = std::move(system)};
  bars.edges = contact_edge_K_changes(scene_, step, K);
  for (const mesh::CrackFront& front : scene_.cracked.fronts) {
    bars.coarse.push_back(estimate_coarse_neighbour_effect({model_, scene_, state}, front));
  }
  return bars;
}

void FrontErrorBars::estimate_bars(const UnfinishedFrontBars& step, const base::Vector& eta,
                                   std::size_t f, std::size_t first_point,
                                   results::FrontResult& front,
                                   results::LoadStepResult& result) const {
  const crack::KLayout layout = scene_.k_layout();
  const Eigen::Index first = layout.first_mode_index(first_point);
  if (hangs_on_an_edge(step.edges, first, front)) {
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
  const CoarseNeighbourEffect& coarse = step.coarse[f];
  add_front_error_bars(eta, smooth_K_along_front(is, scene_.domains[f], better, first), step.edges,
                       first, coarse.part,
                       {.corrected = corrects_K(model_),
                        .closes = scene_.crack_face_pairs[is.crack.index()].has_value()},
                       front);
  if (!coarse.why_not.empty()) {
    result.notes.push_back(
        results::less_exact_note(fmt::format("K of {}: {}", front.name, coarse.why_not)));
  }
}

void FrontErrorBars::finish(const std::vector<UnfinishedFrontBars>& steps, const KFunctionals& K,
                            const std::vector<results::LoadStepResult*>& results) {
  std::vector<const ModeLoad*> loads;
  for (const UnfinishedFrontBars& step : steps) {
    if (step.why_not.empty()) {
      loads.push_back(&step.load);
    }
  }
  std::vector<std::optional<base::Vector>> etas;
  if (!loads.empty()) {
    etas = modes_->K_changes(loads, K);
  }
  auto eta = etas.begin();
  for (std::size_t s = 0; s < steps.size(); ++s) {
    const UnfinishedFrontBars& step = steps[s];
    const std::optional<base::Vector> change = step.why_not.empty() ? *eta++ : std::nullopt;
    const std::string reason =
        step.why_not.empty() && !change ? "what closed contacts hold gives way" : step.why_not;
    assign_error_bars(reason, *results[s],
                      [&](std::size_t f, std::size_t first_point, results::FrontResult& front) {
                        estimate_bars(step, *change, f, first_point, front, *results[s]);
                      });
  }
}

} // namespace spricka::analysis
