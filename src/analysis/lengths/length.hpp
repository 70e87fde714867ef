// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/adjoints.hpp"
#include "analysis/adjoint/error_bars.hpp"
#include "analysis/adjoint/front_analysis.hpp"
#include "analysis/adjoint/sensitivities.hpp"
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/recover/load_paths.hpp"
#include "analysis/scene/make_scene.hpp"
#include "analysis/steps/contact_memory.hpp"
#include "analysis/steps/mount_memory.hpp"
#include "analysis/steps/step_solver.hpp"
#include "estimate/enrichment.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spricka::analysis {

/// What a crack length is made of, and what one leaves for the next; all must outlive it.
struct CrackLengthContext {
  const model::Model& model;
  CondensationCache& cache;             ///< nets that did not change
  int threads = 1;                      ///< of the condensation
  MountOffsetMemory* mounted = nullptr; ///< at the first length; null: each length mounts anew
  ContactDataForNextLength* contact = nullptr; ///< compliances that lengths share
  estimate::ModeMatrixCache* modes = nullptr;  ///< of the error bars
  const model::Model* with_paths = nullptr;    ///< whose load paths are followed; null: the model's
  CondensationMode condensing = CondensationMode::automatic;
  solve::EquationEngine engine = solve::EquationEngine::automatic;
};

/// One crack length: cut (TOPOLOGY), condensed (STIFFNESS, CONDENSE) and ready to be asked. It owns
/// the scene, its bodies and all processors that stand on them; a run walks the steps of its deck
/// on it, the shell asks it, `check` looks at it without factors.
class CrackLengthAnalysis {
public:
  /// Cracks cut in, pairs made, nothing condensed. Mistakes of the deck that only show here go to
  /// `diagnostics` and give null. A plan that follows patches is brought up to date.
  static std::unique_ptr<CrackLengthAnalysis> create(const CrackLengthContext& parts,
                                                     const std::vector<mesh::CrackLine>& lines,
                                                     CrackRegionPlan& plan,
                                                     base::Diagnostics& diagnostics);
  /// The same with cracks of length `a`; 0: as the deck gives them.
  static std::unique_ptr<CrackLengthAnalysis> create(const CrackLengthContext& parts, double a,
                                                     CrackRegionPlan& plan,
                                                     base::Diagnostics& diagnostics);
  CrackLengthAnalysis(const CrackLengthContext& parts, Discretisation scene);
  CrackLengthAnalysis(const CrackLengthAnalysis&) = delete;
  CrackLengthAnalysis& operator=(const CrackLengthAnalysis&) = delete;

  [[nodiscard]] const model::Model& model() const { return parts_.model; }
  [[nodiscard]] const Discretisation& discretisation() const { return scene_; }
  [[nodiscard]] const std::vector<SubstructuredBody>& bodies() const { return bodies_; }
  /// Size of the first crack: its length, in space its axis A, or how deep it reaches behind an
  /// open front that is drawn [length]; 0: there is none.
  [[nodiscard]] double first_crack_size() const;

  /// What condense() is going to ask for, without loads.
  [[nodiscard]] CondensationRequest condensation_request() const;
  /// Bodies and nets, their freedoms numbered, nothing assembled: enough to be looked at.
  void number_freedoms();
  /// Condenses all bodies; false: a net is singular, `figures.trouble` says which.
  bool condense(CondensationStatistics& figures);
  /// Faces of these crack lines become pairs; the length is to be condensed again.
  void add_face_contact(const std::vector<std::size_t>& lines);

  /// A solver at the unloaded state of the condensed length, which must outlive it.
  [[nodiscard]] std::unique_ptr<StepSolver> make_solver() const;
  /// Crack lines whose faces overlap in u [dim * node] and have no pair yet.
  [[nodiscard]] std::vector<std::size_t> cracks_with_overlapping_faces(const base::Vector& u) const;
  /// VCE and RECOVER: K, pressures, reactions at the end of a step.
  [[nodiscard]] results::LoadStepResult recover_step(const model::Step& step,
                                                     const StepState& state) const;
  /// LOADPATH.
  [[nodiscard]] LoadPathSolver& load_paths() { return processors_->paths; }

  /// ADJOINT: of K at the end of the step that `solver` solved last, in the plane.
  const StressIntensityAdjoints& solve_adjoints(const StepSolver& solver);
  /// ADJOINT, ESTIMATE and SENSITIVITY: error bars and derivatives of K at the end of the step that
  /// `solver` solved last, in the plane by adjoints, in space by direct solutions; nothing without
  /// a crack. What the bars allow is taken out of K. Without `sensitivities` bars alone. In space
  /// bars wait for finish_error_bars(). False: `ended` went no further.
  bool begin_error_bars(const StepSolver& solver, const StepState& state, bool sensitivities,
                        results::LoadStepResult& result, const ProcessorEndCallback& ended);
  /// Whether bars that wait should be finished before the next step: none, some, or too many.
  enum class WaitingBars { none, some, full };
  [[nodiscard]] WaitingBars waiting_bars() const;
  /// ESTIMATE in space: bars of the steps that wait, in their order.
  void finish_error_bars(const std::vector<results::LoadStepResult*>& steps);
  /// Both for a single step.
  bool add_error_bars_and_sensitivities(const StepSolver& solver, const StepState& state,
                                        bool sensitivities, results::LoadStepResult& result,
                                        const ProcessorEndCallback& ended);
  /// ESTIMATE: errors of the nets in the energy norm; `energy`: of strain [element].
  void add_net_errors(const std::vector<double>& energy, results::LoadStepResult& result) const;

  /// The scene of a length that is done with.
  [[nodiscard]] static Discretisation
  take_discretisation(std::unique_ptr<CrackLengthAnalysis> length) {
    return std::move(length->scene_);
  }

private:
  /// What stands on the scene and its condensed bodies.
  struct PostProcessors {
    explicit PostProcessors(const CrackLengthAnalysis& length);
    KFunctionals K;
    LoadPathSolver paths;
    IntensityAdjointSolver adjoints;
    TipErrorBars bars;
    TipSensitivityAnalysis sensitivities;
    FrontErrorsAndSensitivities fronts;
  };

  CrackLengthContext parts_;
  Discretisation scene_;
  std::vector<SubstructuredBody> bodies_;
  std::optional<PostProcessors> processors_; ///< empty: not condensed
};

} // namespace spricka::analysis
