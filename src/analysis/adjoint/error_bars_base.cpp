// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/adjoint/error_bars_base.hpp"

#include "analysis/steps/history_program.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

bool corrects_K(const model::Model& model) {
  return !depends_on_load_order(model) && (!model.growth || model.growth->corrected);
}

ErrorBarsBase::ErrorBarsBase(const model::Model& model, const Discretisation& scene)
    : model_(model), scene_(scene), case_load_(model.cases.size()) {}

void ErrorBarsBase::assign_error_bars(
    const std::string& why_not, results::LoadStepResult& step,
    const std::function<void(std::size_t, std::size_t, results::FrontResult&)>& estimate) {
  std::size_t first = 0;
  for (std::size_t f = 0; f < step.fronts.size(); ++f) {
    results::FrontResult& front = step.fronts[f];
    front.missing_bar_reason = why_not;
    if (front.missing_bar_reason.empty()) {
      estimate(f, first, front);
    }
    const bool known = front.missing_bar_reason.empty();
    if (known) {
      results::take_out_estimated_errors(front);
    }
    // Of K that is in doubt the mesh's part is no bar, but goes with the load as K does.
    if (!front.invalid_reason.empty()) {
      front.missing_bar_reason = front.invalid_reason;
    }
    if (!front.missing_bar_reason.empty()) {
      add_note_once(results::make_note(fmt::format("K of {} has no error bar{}: {}", front.name,
                                                   known ? "" : " and is as the mesh has it",
                                                   front.missing_bar_reason)),
                    step);
    }
    first += front.points.size();
  }
}

base::Vector
ErrorBarsBase::sum_case_loads(const base::Vector& case_factor, Eigen::Index freedoms,
                              const std::function<base::Vector(std::size_t)>& of_case) {
  base::Vector f = base::Vector::Zero(freedoms);
  for (std::size_t c = 0; c < case_load_.size(); ++c) {
    const double factor = case_factor[static_cast<Eigen::Index>(c)];
    if (factor == 0.0) {
      continue;
    }
    if (!case_load_[c]) {
      // Cases that no step has applied are never integrated.
      case_load_[c] = of_case(c);
    }
    f += factor * *case_load_[c];
  }
  return f;
}

void ErrorBarsBase::add_note_once(results::Note note, results::LoadStepResult& step) {
  if (std::ranges::find(reported_, note) == reported_.end()) {
    reported_.push_back(note);
    step.notes.push_back(std::move(note));
  }
}

} // namespace spricka::analysis
