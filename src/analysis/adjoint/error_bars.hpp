// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_state.hpp"
#include "contact/held_contact.hpp"
#include "estimate/adjoint.hpp"
#include "estimate/contact_load.hpp"
#include "estimate/goal_error.hpp"
#include "results/note.hpp"
#include "results/results.hpp"

#include <optional>
#include <string>
#include <vector>

/// Processor ESTIMATE: error bars of K at the ends of the steps of one crack length.
namespace spricka::analysis {

class TipErrorBars {
public:
  /// All must outlive it; nothing is computed before the first step that needs it. `memory`: what
  /// one length leaves for the next, or null.
  TipErrorBars(const model::Model& model, const Discretisation& scene,
               estimate::ModeMatrixCache* memory = nullptr);

  /// Gives the tips of a step, which was solved last, their bars, or says why they have none.
  /// `held`: the contact that the adjoints keep, null where there is none.
  void add_to_tips(const StepState& state, const std::vector<estimate::IntensityAdjoint>& adjoints,
                   const contact::FixedActiveSet* held, results::StepResult& step);

private:
  void prepare();
  [[nodiscard]] bool is_bonded(std::size_t contact) const;
  [[nodiscard]] base::Vector load(const base::Vector& case_factor);
  [[nodiscard]] estimate::ModeMap modes(const StepState& state) const;
  void add_pressures(const StepState& state,
                     const std::vector<estimate::IntensityAdjoint>& adjoints, base::Vector& f,
                     base::Matrix& g) const;
  [[nodiscard]] bool coarse_contact(const StepState& state, const mesh::CrackFront& front) const;
  void tell(const results::TipResult& tip, results::StepResult& step);
  void tell_once(results::Note note, results::StepResult& step);
  void tell_of_meshes(const StepState& state, results::StepResult& step);

  const model::Model& model_;
  const Discretisation& scene_;
  estimate::ModeMatrixCache* memory_;
  bool prepared_ = false;
  std::string why_not_; ///< of the whole mesh
  std::optional<estimate::CubicEnrichment> enrichment_;
  estimate::ModeSupports supports_;
  std::vector<std::vector<estimate::ContactEdge>> contact_edges_; ///< [contact]
  std::vector<std::vector<estimate::ModeWeight>> mode_weights_;   ///< [contact]
  std::vector<std::optional<base::Vector>> case_load_;            ///< [case] on the modes
  base::Matrix goals_;                                            ///< [freedoms of modes, 2 tips]
  std::vector<results::Note> reported_;
};

} // namespace spricka::analysis
