// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "estimate/contact_edges.hpp"
#include "estimate/enrichment.hpp"
#include "fe/dependence.hpp"

#include <vector>

namespace spricka::estimate {

/// Which mode freedoms are unknowns: x[freedom] = factor * unknown, 0 where held.
struct ModeFreedomMap {
  std::vector<std::int32_t> unknown; ///< [freedom], -1: held at zero
  std::vector<double> factor;        ///< [freedom]
  Eigen::Index unknowns = 0;
  /// [freedom] stiffness that another body adds, as a part of the mode's own.
  std::vector<std::pair<std::size_t, double>> support;

  /// All mode freedoms of the values of the unknowns; zero where held.
  [[nodiscard]] base::Vector expand(const base::Vector& y) const; ///< [unknowns] to [freedoms]
  [[nodiscard]] base::Matrix
  reduce(const base::Matrix& f) const; ///< [freedoms, k] to [unknowns, k]
};

/// What stays the same at all steps. Held are modes along freedoms that are suppressed or
/// prescribed at all nodes of an edge, and all modes of edges that ties join to others (manual,
/// estimate.9): matching edges of two nets share theirs.
struct ModeSupports {
  std::vector<bool> held; ///< [freedom]
  struct SharedEdgeModes {
    std::size_t edge = 0, as = 0;
    double factor = 1.0; ///< of both directions
  };
  std::vector<SharedEdgeModes> shared; ///< edges whose modes are those of another one
};
/// cls [dim * node]
ModeSupports find_mode_supports(const CubicEnrichment& enrichment,
                                const std::vector<model::FreedomRole>& cls,
                                const fe::ConstraintTransformation& ties);

/// With the closed contact edges of a step (manual, estimate.10): on matching edges the normal mode
/// of both bodies is one; on others it is held, or carries the pressure where it is `loaded`;
/// bonded ones treat the tangential mode alike.
ModeFreedomMap map_mode_freedoms(const CubicEnrichment& enrichment, const ModeSupports& supports,
                                 const std::vector<ClosedContactEdge>& closed);

} // namespace spricka::estimate
