// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/bodies/condense_bodies.hpp"
#include "analysis/scene/scene.hpp"
#include "analysis/steps/step_solver.hpp"
#include "contact/held_contact.hpp"

#include <memory>
#include <string>
#include <vector>

namespace spricka::analysis {

/// Which rows of the table the step that was solved last ended with closed, and whether some rub.
struct ClosedContactRows {
  std::vector<bool> closed; ///< [row of the table]
  bool rubs = false;
};
/// Contact rows that are closed at the end of the last step, equality rows among them; all open
/// where nothing is in contact.
ClosedContactRows closed_contact_rows(const StepSolver& solver, const Discretisation& scene);
/// Why K has neither bars nor derivatives where some rub.
inline constexpr const char* depends_on_history =
    "contacts rub: the change of K depends on the load history";

/// Loads, or other linear functionals of the displacements, condensed on the bodies once.
struct CondensedLoads {
  Eigen::Index freedoms = 0, columns = 0;
  std::vector<CondensedLoad> of_body;   ///< [body]
  std::vector<base::Matrix> external;   ///< [body of the contact system], at first use
  contact::ResponseWithoutContact free; ///< to those, likewise
};
/// Of loads [dim * node, k], of which only those on independent freedoms count once ties are
/// reduced.
CondensedLoads condense_loads(const Discretisation& scene,
                              const std::vector<SubstructuredBody>& bodies, base::Matrix loads);

/// How much of the largest load may be left on motions that nothing holds, and what more means.
struct UnheldLoadLimit {
  double part = 1e-6; ///< more than round-off
  const char* why_not = "no closed contact holds a body against it";
};

/// What displacements and contact forces change by as loads and gaps do, rows that are closed
/// staying so and open ones open: one back-substitution for each column.
struct FrozenContactResponse {
  base::Matrix u;                       ///< [dim * node, k]
  base::Matrix force;                   ///< [row of the table, k]
  contact::ResponseWithoutContact free; ///< without contact forces, where there are contacts
  std::string why_not;                  ///< empty: there is one
};

/// The same to loads at the ends of several steps, each answered by its own closed rows.
struct FrozenStepResponses {
  base::Matrix u;           ///< [dim * node, step]
  base::Matrix force;       ///< [row of the table, step]
  std::vector<bool> failed; ///< [step] there is none: the closed rows give way
};

/// All must outlive it.
class FrozenContactSystem {
public:
  FrozenContactSystem(const StepSolver& solver, const Discretisation& scene,
                      const std::vector<SubstructuredBody>& bodies,
                      const std::vector<bool>& closed);

  /// Loads [dim * node, k] as condense_loads takes them; gaps [row, k], or no columns.
  [[nodiscard]] FrozenContactResponse solve_response(base::Matrix loads,
                                                     const base::Matrix& gaps) const;
  /// The same of condensed loads, which keep what does not depend on the rows; without `free`.
  [[nodiscard]] FrozenContactResponse solve_response(CondensedLoads& loads,
                                                     const base::Matrix& gaps,
                                                     const UnheldLoadLimit& unheld) const;
  /// The response to gaps and to given forces of rows that are open [row, k].
  [[nodiscard]] FrozenContactResponse solve_row_response(const base::Matrix& gaps,
                                                         const base::Matrix& forces) const;
  /// The responses to loads [dim * node, step] by the systems [step] of one crack length, for which
  /// the factors are read once.
  [[nodiscard]] static FrozenStepResponses
  solve_responses(const std::vector<const FrozenContactSystem*>& steps, base::Matrix loads);
  /// Why loads [dim * node, k] have no response, at the cost of what they come to on rigid modes;
  /// empty: they have one, as far as that tells.
  [[nodiscard]] std::string why_no_response(base::Matrix loads) const;
  /// The closed rows held; null where no body has externals.
  [[nodiscard]] const contact::FixedActiveSet* fixed_active_set() const { return held_.get(); }

private:
  /// Of the bodies of the contact system [body][m, k].
  [[nodiscard]] std::vector<base::Matrix> external_loads(const CondensedLoads& loads) const;
  /// Makes what loads do without contact, unless they have it.
  void respond_without_contact(CondensedLoads& loads) const;
  /// Displacements [dim * node, k] by loads and what contacts answer; null: there are none.
  [[nodiscard]] base::Matrix
  displacements(const CondensedLoads& loads,
                const contact::FixedActiveSet::ActiveSetResponse* answer) const;

  const StepSolver& solver_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  std::unique_ptr<contact::FixedActiveSet> held_;
};

} // namespace spricka::analysis
