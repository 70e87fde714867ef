// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace spricka::program {

struct CrackSize {
  double a = 0.0; ///< its length; in space the semi-axis A of an ellipse [length]
  double c = 0.0; ///< in space the semi-axis C, else 0 [length]
  bool operator==(const CrackSize&) const = default;
};

/// Size of a crack: axes of an ellipse, else the length that the state has of it; without one that
/// of the deck [length].
CrackSize crack_size(const model::Model& model, const results::LoadStepResult& state,
                     std::size_t crack);

/// A state that was found at one size of the cracks.
struct FrontsAtSize {
  double a = 0.0; ///< as increments are sorted by it
  CrackSize size; ///< of the first crack
  std::vector<results::FrontResult> fronts;
};

/// Fronts at all sizes that were tried, with the setting each was found in: loads, fits and cards,
/// as a text to compare.
class TriedSizes {
public:
  /// Replaces what the same setting has of these sizes.
  void add(const std::string& setting, FrontsAtSize found);
  /// Those of a setting, by size.
  [[nodiscard]] std::vector<FrontsAtSize> at(const std::string& setting) const;

private:
  struct TriedSize {
    std::string setting;
    FrontsAtSize found;
  };
  std::vector<TriedSize> known_;
};

} // namespace spricka::program
