// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/increments_in_memory.hpp"
#include "base/outcome.hpp"
#include "base/source.hpp"
#include "model/forward.hpp"
#include "program/shell/solver_controls.hpp"
#include "results/results.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::program {

/// Growths of a deck's cracks by one law after another: as runs make them, but without stresses,
/// pictures and files. Fronts that were solved serve all laws that lead to them.
class ShellGrowth {
public:
  explicit ShellGrowth(SolverThreadsAndStop controls) : controls_(std::move(controls)) {}

  /// The growth by the law of the model, whose other cards are the same in all calls. With `anew`
  /// every front is solved, whatever is there. Trouble where there is no law or no growth;
  /// `sources` show places of mistakes.
  base::OptionalFailure grow(const model::Model& model, const base::SourceTexts& sources,
                             bool anew);
  /// The law is another one.
  void forget_result() { result_.reset(); }

  /// The growth that grow() has made last.
  [[nodiscard]] const results::RunResult& result() const { return *result_; }
  /// Fronts that it had to solve.
  [[nodiscard]] std::size_t solved_count() const { return solved_; }
  /// Why fronts of earlier growths did not serve it to its end; empty: they did, or there were
  /// none.
  [[nodiscard]] const std::string& why_solved_anew() const { return why_anew_; }

private:
  using GrowthOverFronts = archive::IncrementsInMemory::GrowthOverFronts;

  /// Fronts in their order, as a growth has found them.
  struct FrontPath {
    archive::IncrementsInMemory fronts;
    std::string law;              ///< that all are of; empty: of several
    std::array<double, 2> ends{}; ///< of the growth by it

    explicit FrontPath(const std::function<bool()>& stopped) : fronts(stopped) {}
  };

  base::OptionalFailure grow_over(const model::Model& model, const base::SourceTexts& sources,
                                  FrontPath& path, GrowthOverFronts use);
  bool grow_over_earlier_fronts(const model::Model& model, const base::SourceTexts& sources,
                                const FrontPath*& best);

  SolverThreadsAndStop controls_;
  std::vector<std::unique_ptr<FrontPath>> paths_; ///< the last one first
  std::optional<results::RunResult> result_;
  std::size_t solved_ = 0;
  std::string why_anew_;
};

} // namespace spricka::program
