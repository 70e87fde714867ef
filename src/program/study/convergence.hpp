// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// What a series of ever finer meshes says: the power that errors fall by, where they stop falling,
/// and what is true of a mesh and all finer ones. Plain numbers; nothing here knows a deck.
namespace spricka::program {

/// One mesh of a series. Errors are without sign, as parts of the answer.
struct MeshSizeAndError {
  double size = 1.0; ///< of its elements, as a part of the deck's: 0.5 is twice as fine
  double error = 0.0;
};

/// error = factor size^power.
struct ConvergenceRate {
  double power = 0.0;
  double factor = 0.0;
  std::size_t points = 0; ///< that it was fitted to
};

/// The power by least squares of the logarithms, of points above `floor`; needs three of them. With
/// `reference` > 0 the errors are differences to a mesh of that size, which has an error of the
/// same law: |size^power - reference^power|. Points at or below that size are left out.
std::optional<ConvergenceRate> fit_convergence_rate(std::span<const MeshSizeAndError> points,
                                                    double floor, double reference = 0.0);

/// The largest error of each point and all finer ones, in the order given: what a user can rely on,
/// as an error that passes through zero is small by luck. [point]
std::vector<double> error_envelope(std::span<const MeshSizeAndError> points);

/// Where errors have stopped falling: from point `first` of the series, coarse to fine, on.
struct ErrorPlateau {
  std::size_t first = 0;
  double level = 0.0; ///< the largest error on it
};

/// The fine end of a series if errors there, lasting ones, fall with less than half the power of
/// the size. Points coarse to fine; needs two of them on the plateau. Errors below `nothing` are
/// round-off.
std::optional<ErrorPlateau> find_error_plateau(std::span<const MeshSizeAndError> points,
                                               double nothing = 1e-12);

/// What a run that could be chosen costs.
struct RankedRunCost {
  double cpu = 0.0;  ///< [s] infinite: it is no good
  double rank = 0.0; ///< of runs that take as long the least is chosen
};

/// The run to choose: of those that take the least CPU time, or as long (within 15 %, as one and
/// the same run differs by so much), the one of the least rank, of several the quickest. Empty:
/// none is any good.
std::optional<std::size_t> cheapest_run(std::span<const RankedRunCost> runs);

} // namespace spricka::program
