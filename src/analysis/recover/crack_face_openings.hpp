// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "model/forward.hpp"

#include <optional>
#include <vector>

namespace spricka::analysis {

/// Openings of crack faces that may meet, where two nodes lie on one another: by pair how far they
/// are apart and how far along the face, as linear functions of displacements.
class CrackFaceOpenings {
public:
  CrackFaceOpenings(const model::Model& model, const Discretisation& scene);

  [[nodiscard]] Eigen::Index count() const { return 2 * static_cast<Eigen::Index>(pairs_.size()); }
  /// From displacements [dim * node]. [opening]
  [[nodiscard]] base::Vector evaluate_openings(const base::Vector& u) const;
  /// The functions from `first` on, so many. [dim * node, opening]
  [[nodiscard]] base::Matrix opening_functionals(Eigen::Index first, Eigen::Index count) const;
  /// Adds crack lines to `lines` whose faces overlap by these values [opening], each once.
  void add_overlapping_crack_lines(const base::Vector& value,
                                   std::vector<std::size_t>& lines) const;

private:
  struct WatchedFaceNodePair {
    std::size_t line = 0;
    contact::ConstraintRow apart;
    std::optional<contact::ConstraintRow> along; ///< none in a half model
  };

  const Discretisation& scene_;
  std::vector<WatchedFaceNodePair> pairs_;
};

} // namespace spricka::analysis
