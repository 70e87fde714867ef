// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "contact/condensed_body.hpp"
#include "contact/constraint.hpp"
#include "contact/contact_compliances.hpp"
#include "contact/sliding_motions.hpp"
#include "solve/contact_problem.hpp"
#include "solve/friction_problem.hpp"
#include "solve/friction_unique.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace spricka::contact {

/// All constraint rows of an increment on all bodies, condensed to compliances once; then any
/// subset of rows, loads and gaps is one small quadratic problem.
class ContactSystem {
public:
  /// `bodies` and `rows` must outlive the system; freedoms = dim * node_count. By their surfaces
  /// `sliding` tells which rigid modes no pressure resists.
  ContactSystem(std::vector<const CondensedBody*> bodies, std::vector<const ConstraintRow*> rows,
                int dim, std::size_t freedoms, const std::vector<ContactRowSurfaces>& sliding = {},
                const PersistentRowSet& lasting = {});

  struct IncrementProblem {
    std::vector<std::size_t> rows;  ///< the rows in force
    std::vector<bool> equality;     ///< [rows in force]
    base::Vector gap;               ///< [rows in force] g at zero displacement, weighted
    std::vector<base::Vector> load; ///< [body][m] condensed loads
    /// [body][m] what they move each body by, S+ f; empty, all or one: to be solved for.
    std::vector<base::Vector> motion;
    double load_scale = 0.0;
    std::vector<bool> start;                  ///< [rows in force] closed; empty: all
    std::vector<solve::FrictionRow> friction; ///< by places in `rows`; empty: nothing rubs
    std::vector<solve::SlipState> touch;      ///< [rows in force] with friction, instead of `start`
    base::Vector alpha; ///< with friction: where bodies that nothing holds stay; empty: at zero
    solve::PredictedContactForces expected; ///< with friction
  };
  struct IncrementSolution {
    solve::ContactSolution contact;      ///< lambda, gap, closed by rows in force
    std::vector<solve::SlipState> touch; ///< [rows in force] with friction; else empty
    bool slides = false;         ///< the mode that is not held would be held by more friction
    std::vector<base::Vector> u; ///< [body][m] external displacements
    /// [body][m] what contact forces leave over on motions by which surfaces slide on themselves;
    /// empty: nothing
    std::vector<base::Vector> resting_force;
  };
  [[nodiscard]] IncrementSolution solve(const IncrementProblem& problem,
                                        const solve::ContactSettings& settings) const;
  /// The same without `u` and `resting_force`, which cost a solution of each body.
  [[nodiscard]] IncrementSolution solve_rows(const IncrementProblem& problem,
                                             const solve::ContactSettings& settings) const;
  /// Adds these to a solution of the rows.
  void add_displacements(const IncrementProblem& problem, IncrementSolution& solution) const;
  /// What is left of a problem once the bodies are condensed: compliances and gaps of its rows.
  [[nodiscard]] solve::ContactProblem condense_problem(const IncrementProblem& problem) const;

  /// W and B of some rows, b and h zero, all of them equalities.
  [[nodiscard]] solve::ContactProblem
  make_equality_problem(const std::vector<std::size_t>& rows) const;

  /// Whether a sufficient test finds that an increment with these rows has only one solution.
  [[nodiscard]] solve::UniquenessResult prove_uniqueness(const IncrementProblem& problem) const;

  /// sum weight . u for a row, from external displacements; other freedoms count as zero.
  [[nodiscard]] double row_opening(std::size_t row, const std::vector<base::Vector>& u) const;
  /// The same of all rows for several displacements [body][m, k]: [row, k].
  [[nodiscard]] base::Matrix row_openings(const std::vector<base::Matrix>& u) const;
  [[nodiscard]] const base::Matrix& row_compliance_matrix() const {
    return compliances_.W;
  } ///< [row, row] compliance
  [[nodiscard]] const base::Matrix& openings_by_rigid_modes() const {
    return compliances_.B;
  } ///< [row, mode]
  [[nodiscard]] double compliance_flops() const {
    return compliances_.flops;
  } ///< of rows on whole bodies
  /// Adds what forces [k] of a row load the bodies with [body][m, k].
  void add_row_force(std::size_t row, const Eigen::RowVectorXd& force,
                     std::vector<base::Matrix>& load) const;
  [[nodiscard]] const std::vector<const CondensedBody*>& bodies() const { return bodies_; }
  /// Which body and which combination of its modes an entry of alpha belongs to.
  [[nodiscard]] std::size_t body_of_mode(Eigen::Index mode) const;
  [[nodiscard]] Eigen::Index first_mode(std::size_t body) const { return mode_start_[body]; }

private:
  /// What the loads of a problem alone move a body by.
  [[nodiscard]] base::Vector motion_of(const IncrementProblem& problem, std::size_t body) const;
  [[nodiscard]] std::vector<base::Vector> resting_force(const std::vector<std::size_t>& rows,
                                                        const base::Vector& lambda) const;
  void let_slide(const std::vector<ContactRowSurfaces>& sliding, int dim,
                 const std::vector<std::pair<std::int32_t, std::int32_t>>& place);
  std::vector<const CondensedBody*> bodies_;
  std::vector<std::vector<BodyRowEntry>> rows_;
  std::vector<Eigen::Index> mode_start_; ///< [body + 1]
  ContactCompliances compliances_;
  base::Matrix slid_; ///< [row, mode] what B would have of surfaces that slide on themselves
};

} // namespace spricka::contact
