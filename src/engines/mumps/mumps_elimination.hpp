// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/sparse.hpp"
#include "base/vec.hpp"
#include "engines/mumps/mumps_instance.hpp"
#include "engines/mumps/mumps_matrix.hpp"
#include "solve/ordering.hpp"
#include "solve/row_elimination.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace spricka::engines {

/// The locals of a net eliminated by MUMPS in our own order, the externals its Schur complement;
/// then loads and displacements by that factor. Right-hand sides are eliminated, and the same ones
/// substituted back: between the two nobody else may ask (see MumpsCondensation).
class MumpsElimination {
public:
  /// K is moved from. There must be locals. With `step`, on rank 0, all ranks of the run do it
  /// together. Throws std::bad_alloc.
  MumpsElimination(base::SymmetricCsc& K, std::int64_t externals, solve::OrderingMethod ordering,
                   solve::CollectiveStep step = {});

  /// The symbolic phase: whether it could be done.
  bool analyse() { return mumps_.run(MumpsJob::analysis); }
  /// The numeric phase, with S [externals, externals], symmetric to the last bit; the factor goes
  /// to files where the folder is not empty. Whether it could be done.
  bool factorise(base::Matrix& S);
  void put_factor_on_disk(bool on_disk) { mumps_.control(22) = on_disk ? 1 : 0; }
  /// False: the name is too long for MUMPS.
  bool set_folder(const std::string& folder) { return mumps_.set_folder(folder); }

  [[nodiscard]] const MumpsInstance& mumps() const { return mumps_; }
  [[nodiscard]] const MumpsMatrix& matrix() const { return K_; }
  [[nodiscard]] base::SymmetricCsc give_back_matrix() { return K_.give_back(); }
  [[nodiscard]] std::int64_t size() const { return K_.size(); }
  [[nodiscard]] std::int64_t locals() const { return K_.locals(); }
  /// Where a pivot of exactly zero has stopped the factorisation; -1: not known.
  [[nodiscard]] std::int64_t stopped_at_row() const;
  /// What hardly any force holds: the local that moves most under loads on all.
  [[nodiscard]] std::int64_t loosest_row();
  /// The relative error of displacements that are known: what the factor makes of their forces.
  [[nodiscard]] double error_of_known_displacements();

  /// X [n, k], scaled loads; returns what is left for the externals [externals, k]. Without
  /// externals X becomes the solution.
  base::Matrix eliminate(base::Matrix& X);
  /// X [n, k] becomes the locals of what was eliminated last, the externals displaced as given.
  void back_substitute(const base::Matrix& u_external, base::Matrix& X);
  /// W and what is left for the externals of columns F [n, k], in blocks of block_width(k).
  [[nodiscard]] solve::RowCompliance compliance_of_rows(const solve::SparseRightHandSides& F);
  [[nodiscard]] std::int64_t block_width(std::int64_t columns) const;

private:
  void ask(int what, base::Matrix& X, base::Matrix& external);

  std::int64_t externals_;
  std::vector<int> order_, external_rows_; ///< as MUMPS wants them, counted from 1
  MumpsMatrix K_;
  MumpsInstance mumps_;
};

} // namespace spricka::engines
