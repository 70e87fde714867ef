// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "contact/system.hpp"

#include <vector>

/// What contacts with friction remember from increment to increment.
namespace spricka::analysis {

/// What friction did to one pair so far; empty without friction. Slips are weighted and those of
/// the contact side against the target: with their sign, in space their size, and all ways added
/// up.
struct PairFrictionState {
  std::vector<solve::SlipState> touch; ///< [normal row]
  base::Vector slip; ///< [normal row] while in contact, since the pair was mounted
  base::Vector path; ///< [normal row]
  double work = 0.0; ///< taken by friction [force * length]
  double mu = 0.0;
};

/// What an increment leaves for the next one.
struct FrictionState {
  std::vector<solve::SlipState> touch; ///< [table row]
  std::vector<double> slip, path;      ///< [table row]
  std::vector<double> pressure; ///< [table row] of normal rows at the end of the last increment
  std::vector<double> work;     ///< [contact]
  base::Vector alpha;           ///< rigid motions at the end of the last increment
};

class FrictionHistory {
public:
  explicit FrictionHistory(const Discretisation& scene);

  /// Whether this row of the table is the slip of a pair with friction.
  [[nodiscard]] bool is_friction_row(std::size_t row) const { return normal_of_[row] >= 0; }

  /// Adds to a problem whose rows are there what friction needs: pairs of rows and first states.
  void add_friction(contact::ContactSystem::IncrementProblem& problem) const;

  /// Takes a solved increment: states, slips, work of friction.
  void accept_increment(const contact::ContactSystem::IncrementProblem& problem,
                        const contact::ContactSystem::IncrementSolution& solution);

  /// A pair is mounted or leaves: what its rows have slipped counts from here.
  void begin(std::size_t contact);

  /// Friction of a contact at its normal rows: states, slip so far, path and work; in space the
  /// slips of both directions together. Empty without friction.
  [[nodiscard]] PairFrictionState pair_friction_state(std::size_t contact) const;

  [[nodiscard]] const FrictionState& friction_state() const { return memory_; }
  /// Puts back a state that friction_state has given, of the same scene.
  void restore_state(const FrictionState& memory) { memory_ = memory; }

private:
  const Discretisation& scene_;
  std::vector<std::ptrdiff_t> normal_of_; ///< [table row] of a slip with friction, else -1
  std::vector<std::size_t> contact_of_;   ///< [table row]
  std::vector<double> mu_;                ///< [contact]
  FrictionState memory_;
};

} // namespace spricka::analysis
