// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/condense.hpp"
#include "solve/dense_cholesky.hpp"
#include "solve/layered_cholesky.hpp"
#include "solve/substructured_factor.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace spricka::contact {

/// A row's part in one body: external freedom, or early row of its factor, and weight.
struct RowCoefficient {
  Eigen::Index at = 0;
  double weight = 0.0;
  bool operator==(const RowCoefficient&) const = default;
};

/// A body of which nothing is condensed: all of its unknowns are external to contact,
/// and what loads do is asked of the sparse factor. Rows act on some of the unknowns alone.
struct UncondensedBody {
  solve::SubstructuredFactor factor; ///< its externals hold the body, and no more
  std::vector<Eigen::Index> weighed; ///< unknowns that rows weigh
};

/// A condensed body as contact sees it: stiffness between its external freedoms, and the rigid
/// modes that its supports leave free. The pseudo-inverse S+ (zero on the modes) comes from one
/// dense Cholesky of S + k Q Q^T with k = trace(S)/m, Q the orthonormal modes. Where no mode is
/// free S may come as a factor, whose early rows other bodies have in common with this one.
class CondensedBody {
public:
  /// freedom [m] (dim * node + c), S [m, m], modes [m, r] any basis of the null space, r may be 0.
  CondensedBody(std::vector<std::int32_t> freedom, base::Matrix S, const base::Matrix& modes);
  CondensedBody(std::vector<std::int32_t> freedom, solve::FactoredSchurComplement factor);
  /// freedom and modes of all unknowns [m]. Modes are orthonormal on what rows weigh, so that S+ is
  /// that of a body condensed to it (solve.37).
  CondensedBody(std::vector<std::int32_t> freedom, UncondensedBody whole,
                const base::Matrix& modes);

  [[nodiscard]] const std::vector<std::int32_t>& external_freedoms() const { return freedom_; }
  [[nodiscard]] const base::Matrix& rigid_modes() const { return Q_; } ///< [m, r] orthonormal
  [[nodiscard]] bool is_factorised() const {
    return layered_ ? layered_->L.is_positive_definite() : factor_.is_positive_definite();
  }
  /// The factor in the place of S, else null.
  [[nodiscard]] const solve::FactoredSchurComplement* external_block_factor() const {
    return layered_ ? &*layered_ : nullptr;
  }
  /// Whether it is a UncondensedBody; then compliance_with_externals_held() stands in the place of
  /// compliance_root().
  [[nodiscard]] bool is_uncondensed() const { return !whole_.factor.empty(); }
  /// Y [.., k] with Y^T Y = F^T S+ F.
  [[nodiscard]] base::Matrix compliance_root(const base::Matrix& F) const;
  /// G S+ G^T [k, k] of rows. The first `lasting` of them weigh only locals of the part that lasts
  /// (SubstructuredFactor), for which something is kept.
  [[nodiscard]] solve::RowCompliance
  compliance_with_externals_held(const std::vector<std::vector<RowCoefficient>>& rows,
                                 std::int64_t lasting = 0,
                                 solve::LastingColumns* kept = nullptr) const;
  /// Of an uncondensed body: what may be kept, and of what (SubstructuredFactor).
  [[nodiscard]] const solve::SubstructuredFactor& factor() const { return whole_.factor; }
  /// S+ F [m, k].
  [[nodiscard]] base::Matrix displacements_under_forces(const base::Matrix& F) const;

private:
  [[nodiscard]] base::Matrix project(base::Matrix F) const;
  /// F on the rows of the factor.
  [[nodiscard]] base::Matrix spread(const base::Matrix& F) const;
  [[nodiscard]] base::Matrix response(const base::Matrix& F) const;
  [[nodiscard]] base::Matrix hold(const base::Matrix& load) const;
  [[nodiscard]] base::Matrix off_modes(base::Matrix F) const;

  std::vector<std::int32_t> freedom_;
  base::Matrix Q_;
  solve::DenseCholesky factor_; ///< of a whole body that of the externals which hold it
  std::optional<solve::FactoredSchurComplement> layered_;
  UncondensedBody whole_;
  base::Matrix held_modes_; ///< [externals, r] of a whole body, orthonormal there
};

} // namespace spricka::contact
