// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "engines/multigrid/nodal_stiffness.hpp"

#include <memory>

namespace spricka::engines {

/// An approximate inverse of a body's stiffness by aggregation multigrid (Vaněk, Mandel and Brezina
/// 1996, not smoothed; GAMG of PETSc): nodes are gathered in aggregates that move rigidly, and
/// these again, down to a few; a W cycle, each level smoothed by two steps of Chebyshev over the
/// diagonal before and after. Symmetric and positive definite, the same for every vector.
class MultigridPreconditioner {
public:
  /// K must outlive it. Throws std::bad_alloc, and std::runtime_error where PETSc fails.
  explicit MultigridPreconditioner(const NodalStiffness& K);
  ~MultigridPreconditioner();
  MultigridPreconditioner(const MultigridPreconditioner&) = delete;
  MultigridPreconditioner& operator=(const MultigridPreconditioner&) = delete;

  /// z [3 nodes] from a residual r [3 nodes]. Throws likewise.
  void apply(const base::Vector& r, base::Vector& z) const;

private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

} // namespace spricka::engines
