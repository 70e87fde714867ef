// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/lengths/solve_lengths.hpp"
#include "model/model.hpp"
#include "program/job/job.hpp"
#include "tests/unit/support/run_text.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <utility>

namespace spricka::test {

/// A deck given as text, solved: its model and all that was found.
struct Solved {
  model::Model model;
  results::RunResult run;

  [[nodiscard]] const model::Mesh& mesh() const { return run.increments.front().mesh; }
  [[nodiscard]] const results::LoadStepResult& step(std::size_t i = 0) const {
    return run.increments.front().steps.at(i);
  }
  [[nodiscard]] base::Vec3 vector(const base::Vector& nodal, base::NodeId n) const {
    base::Vec3 v = base::Vec3::Zero();
    const int dim = mesh().dim;
    v.head(dim) = nodal.segment(static_cast<Eigen::Index>(n.index()) * dim, dim);
    return v;
  }
  [[nodiscard]] base::Vec3 u(base::NodeId n) const { return vector(step().u, n); }
  [[nodiscard]] base::Vec3 reaction(base::NodeId n) const { return vector(step().reaction, n); }
  /// The node nearest to a place; of several the first.
  [[nodiscard]] base::NodeId node_at(const base::Vec3& x) const {
    std::size_t best = 0;
    for (std::size_t n = 1; n < mesh().node_count(); ++n) {
      if ((mesh().x[n] - x).norm() < (mesh().x[best] - x).norm() - 1e-9) {
        best = n;
      }
    }
    return base::NodeId(best);
  }
  /// Sum and moment about the origin of all support forces.
  [[nodiscard]] std::pair<base::Vec3, base::Vec3> support() const {
    std::pair<base::Vec3, base::Vec3> sum{base::Vec3::Zero(), base::Vec3::Zero()};
    for (std::size_t n = 0; n < mesh().node_count(); ++n) {
      const base::Vec3 R = reaction(base::NodeId(n));
      sum.first += R;
      sum.second += mesh().x[n].cross(R);
    }
    return sum;
  }
};

/// Empty, with a failure, when the deck cannot be read or solved.
inline std::optional<Solved> solve_text(const std::string& deck,
                                        const analysis::SolveOptions& options) {
  const Folder folder;
  const std::filesystem::path file = folder.path() / "test.deck";
  std::ofstream(file) << deck;
  program::CheckedDeck ready =
      program::read_and_check_deck(file, {}, program::Log(program::LogFormat::text));
  if (!ready.model) {
    ADD_FAILURE() << "the deck is refused";
    return std::nullopt;
  }
  base::Diagnostics diagnostics;
  base::OptionalFailure trouble;
  std::optional<results::RunResult> run =
      analysis::solve_run(*ready.model, options, diagnostics, trouble);
  if (!run) {
    ADD_FAILURE() << "not solved: " << (trouble ? trouble->why : "mistakes in the deck");
    return std::nullopt;
  }
  return Solved{std::move(*ready.model), std::move(*run)};
}

inline std::optional<Solved> solve_text(const std::string& deck, int threads = 1) {
  analysis::SolveOptions options;
  options.threads = threads;
  return solve_text(deck, options);
}

/// Without error bars: K as the mesh has it, to be compared with what is exact of that.
inline std::optional<Solved> solve_text_with_raw_K(const std::string& deck) {
  analysis::SolveOptions options;
  options.error_bars = false;
  return solve_text(deck, options);
}

} // namespace spricka::test
