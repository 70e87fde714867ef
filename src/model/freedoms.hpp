// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/id.hpp"
#include "base/source.hpp"

#include <array>
#include <variant>
#include <vector>

/// Freedoms that are held, prescribed or tied.
namespace spricka::model {

/// Dependent freedoms follow others by an MPC; no card says so, the ties do.
enum class FreedomRole { local, external, suppressed, prescribed, dependent };

/// Whether a support gives the freedom its displacement: suppressed or prescribed.
constexpr bool is_suppressed_or_prescribed(FreedomRole cls) {
  return cls == FreedomRole::suppressed || cls == FreedomRole::prescribed;
}

struct NodeSetFreedomRole {
  FreedomRole cls = FreedomRole::suppressed;
  std::array<bool, 3> dof{}; ///< x y z
  base::NodeSetId nodes;
  base::SourceSpan span;
};

/// A tie between freedoms: sum of coefficient * displacement = rhs.
struct ConstraintEquation {
  struct ConstraintTerm {
    double coefficient = 0.0;
    base::NodeId node;
    int dof = 0; ///< 0 x, 1 y, 2 z
  };
  std::vector<ConstraintTerm> terms; ///< each freedom once, coefficients not zero
  double rhs = 0.0;
  base::SourceSpan span;
};
/// Slave nodes tied to the master faces by their shape functions.
struct TransitionTie {
  base::NodeSetId slave;
  base::FaceSetId master;
  base::SourceSpan span;
};
/// Slave nodes that move as one rigid body.
struct RigidTie {
  base::NodeSetId slave;
  base::SourceSpan span;
};
using Mpc = std::variant<ConstraintEquation, TransitionTie, RigidTie>;

} // namespace spricka::model
