// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "solve/layered_cholesky.hpp"
#include "solve/ordering.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace spricka::solve {

enum class FactorStatus { ok, not_positive_definite, out_of_memory };

struct FactorReport {
  FactorStatus status = FactorStatus::ok;
  std::int64_t failed_row = -1; ///< row of the matrix as given where a pivot was not positive
  double flops = 0.0;           ///< of the numeric phase, exact
  double memory = 0.0;          ///< [bytes] forecast of the largest need, from the symbolic phase
  double memory_left = 0.0;     ///< [bytes] what could be had when it was begun
  double smallest_pivot = 1.0;  ///< of the locals, over the diagonal entry of the matrix
  double kept_memory = 0.0;     ///< [bytes] of the factor, external part included
  double factor_entries = 0.0;  ///< nonzeros of L
  double analysis_cpu = 0.0;    ///< [s] of the calling thread, as below
  double numeric_cpu = 0.0;     ///< [s]
};

/// A condensed net as one full block on rows of another matrix.
struct DenseBlock {
  std::vector<std::int64_t> rows;          ///< [m] rows there, -1: none
  const base::Matrix* stiffness = nullptr; ///< [m, m] symmetric; not looked at by forecasts
};

/// Whether such blocks are better kept out of the sparse matrix: together with the externals they
/// fill most of what they touch.
bool stacking_pays(std::span<const DenseBlock> blocks, std::int64_t rows, std::int64_t externals);

/// One Cholesky factorisation of K with the external rows last, and everything that is read off
/// it: the Schur complement S = K_ee - K_el K_ll^-1 K_le, condensed loads, recovered locals.
/// Externals carry a shift s on their diagonal, taken off again (condensation rule 3), so that a
/// floating body needs no support. With no externals it is a plain solver.
class Condensation {
public:
  /// K [n, n] lower triangle, the last `externals` rows external. Check the report: when its status
  /// is not ok, nothing else may be asked for.
  /// K is given up as soon as it is copied into the order of elimination: move it in.
  Condensation(base::SymmetricCsc K, std::int64_t externals,
               Ordering ordering = Ordering::automatic);
  /// The symbolic phase alone: flops, fill and memory of what the constructor would do with a
  /// matrix of this pattern (values are not looked at).
  static FactorReport forecast(base::SymmetricCsc pattern, std::int64_t externals,
                               Ordering ordering = Ordering::automatic);
  /// With dense blocks on top of K, which has a row, if an empty one, for each of theirs. With
  /// `early` S may be given as a factor: what it needs of the one block is taken from there or left
  /// there for the next matrix with the same block.
  Condensation(const base::SymmetricCsc& K, std::int64_t externals,
               std::span<const DenseBlock> blocks,
               std::shared_ptr<const EarlyRows>* early = nullptr);
  /// `early`: rows of the block that would be there already; those of this matrix from then on.
  static FactorReport forecast(const base::SymmetricCsc& pattern, std::int64_t externals,
                               std::span<const DenseBlock> blocks, EarlyLists* early = nullptr);
  ~Condensation();
  Condensation(Condensation&&) noexcept;
  Condensation& operator=(Condensation&&) noexcept;

  [[nodiscard]] const FactorReport& report() const;
  /// S [externals, externals], symmetric to the last bit.
  [[nodiscard]] const base::Matrix& schur() const;
  /// Hands S over to who needs it last; schur() is empty from then on.
  [[nodiscard]] base::Matrix take_schur();
  /// The factor that stands in its place, if one does.
  [[nodiscard]] std::optional<FactoredExternals> take_factor();
  /// Loads f [n, k] -> condensed loads f_e - K_el K_ll^-1 f_l [externals, k].
  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const;
  /// All unknowns [n, k] from external displacements [externals, k] and the loads f [n, k].
  [[nodiscard]] base::Matrix recover(const base::Matrix& u_external, const base::Matrix& f) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace spricka::solve
