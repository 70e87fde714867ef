// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/forward.hpp"

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace spricka::fe {

/// A freedom dim * node + c and its coefficient.
struct FreedomTerm {
  std::int32_t freedom = 0;
  double coefficient = 0.0;
};

/// sum coefficient * u = rhs, made from an entry of Model::mpcs. The first term is the freedom that
/// shall follow the others.
struct Tie {
  std::vector<FreedomTerm> terms;
  double rhs = 0.0;
  std::size_t mpc = 0;
};

/// Ties solved for: u = T w + g, where w are the freedoms that nothing ties, so that K becomes
/// T^T K T and loads become T^T (f - K g): no penalty, no multiplier (Shephard 1984, "Linear
/// multipoint constraints applied via transformation as part of a direct stiffness assembly
/// process"). Dependent freedoms follow independent ones, chains are substituted.
class ConstraintTransformation {
public:
  /// A freedom that follows: u = sum of terms + constant. Its masters are never dependent; those
  /// that are suppressed or prescribed are kept, as they carry reactions.
  struct DependentRow {
    std::int32_t freedom = 0;
    std::vector<FreedomTerm> terms;
    double constant = 0.0;
    std::size_t mpc = 0;
  };
  /// A tie between freedoms that are all given: true or a contradiction.
  struct FullyGivenTie {
    std::vector<FreedomTerm> terms;
    double rhs = 0.0;
    double scale = 0.0; ///< of the right-hand sides that met in `rhs`
    std::size_t mpc = 0;
  };

  /// Solves the ties one after another in their order. The first term of each is eliminated where
  /// it can be, else the largest coefficient that is left. `cls` is by freedom of the mesh.
  ConstraintTransformation(const std::vector<Tie>& ties,
                           const std::vector<model::FreedomRole>& cls);

  [[nodiscard]] const std::vector<DependentRow>& rows() const { return rows_; }
  [[nodiscard]] const std::vector<FullyGivenTie>& fully_given_ties() const { return demands_; }
  [[nodiscard]] int redundant_tie_count() const { return redundant_; }
  [[nodiscard]] bool has_constants() const;
  /// The row of a dependent freedom; null for the others.
  [[nodiscard]] const DependentRow* find_row(std::int32_t freedom) const;

  /// Gives dependent freedoms their displacements: u_d = sum c u_m + scale * constant.
  void set_dependent_displacements(Eigen::Ref<base::Vector> u, double scale) const;
  /// Hands forces on dependent freedoms over to their masters: f <- T^T f, by columns.
  void transfer_forces_to_masters(base::Matrix& f) const;

  /// A block of coefficients on some freedoms once dependent ones are replaced: K <- T^T K T.
  struct BlockTransformation {
    std::vector<std::int32_t> freedom; ///< [r]
    Eigen::SparseMatrix<double> T;     ///< [freedoms given, r]
  };
  /// Empty when no freedom of the block is dependent.
  [[nodiscard]] std::optional<BlockTransformation>
  find_block_transformation(std::span<const std::int32_t> freedoms) const;

private:
  struct Sum;
  /// Of what was added up to a row's terms and constant: round-off of those is its error.
  struct TermMagnitudes {
    std::vector<double> terms;
    double constant = 0.0;
  };
  void add(const Tie& tie, const std::vector<model::FreedomRole>& cls);
  void eliminate(std::int32_t freedom, std::size_t by);

  std::vector<DependentRow> rows_;
  std::vector<TermMagnitudes> sizes_; ///< of the rows, while ties are being solved
  std::vector<std::int32_t> row_of_;  ///< [freedom] or -1
  std::map<std::int32_t, std::vector<std::size_t>> users_; ///< rows that have this master
  std::vector<FullyGivenTie> demands_;
  int redundant_ = 0;
};

} // namespace spricka::fe
